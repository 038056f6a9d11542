// Exits, sources and waiting areas of a place that is being made: whom a source sends, and lines to queue in.

import type { Command, Vec2 } from '../../protocol/generated/commands';
import type { SceneFacts } from '../../protocol/scene';
import { distance, type GroundPoint } from '../plane';
import { kAdults } from './people';
import type { Thing } from './things';

/** Points of a queue lie so far apart [m]. */
const kQueueStep = 1;

/** Groups that a source may send people to, by words that differ. */
export function groupChoices(scene: SceneFacts | null): { readonly id: number; readonly word: string }[] {
  const groups = scene?.groups ?? [];
  return groups.map(({ id, definition: { name } }) => {
    const twice = groups.filter((one) => one.definition.name === name).length > 1;
    return { id, word: twice || !name ? `${name || 'Group'} ${id}` : name };
  });
}

/** What a new group for the people of a source is called. */
const kArrivals = 'Arrivals';

/** A group for the people of a source: adults who leave by the quickest exit. Nobody is in it at first. */
export function newArrivals({ centre }: Thing): Command {
  const group = {
    name: kArrivals,
    count: 0,
    position: centre,
    people: [kAdults],
    orders: [{ kind: 'leave' }],
  } as const;
  return { kind: 'group', group };
}

/** The source with its group, which has come; null where it has not. `known`: what was there before. */
export function joinedSource(source: Thing, scene: SceneFacts, known: readonly Thing[]): Thing | null {
  const isKnown = (group: number): boolean => known.some(({ kind, id }) => kind === 'group' && id === group);
  const group = scene.groups.find(({ id, definition }) => definition.name === kArrivals && !isKnown(id));
  return group ? { ...source, group: group.id } : null;
}

/** True for a group that nobody is in before people come by a source: there is nothing to take hold of. */
export function isNobody({ kind, count }: Thing): boolean {
  return kind === 'group' && count === 0;
}

/** Groups that nobody is in and nobody comes to where these sources go. */
export function emptiedGroups(removed: readonly Thing[], all: readonly Thing[]): Thing[] {
  const gone = (one: Thing): boolean => removed.some(({ kind, id }) => kind === one.kind && id === one.id);
  const feeds = (group: Thing, { area, group: fed }: Thing): boolean => area?.kind === 'source' && fed === group.id;
  return all.filter(
    (group) =>
      isNobody(group) &&
      !gone(group) &&
      removed.some((one) => feeds(group, one)) &&
      !all.some((one) => feeds(group, one) && !gone(one)),
  );
}

/** The exit with a queue along the drawn line, from its end at the exit; none where the line is short. */
export function queued(exit: Thing, line: readonly GroundPoint[]): Thing {
  const queue: Vec2[] = [];
  for (const { x, y } of line) {
    const last = queue[queue.length - 1];
    if (!last || distance({ x, y }, { x: last[0], y: last[1] }) >= kQueueStep) queue.push([x, y]);
  }
  return { ...exit, area: exit.area && { ...exit.area, queue: queue.length > 1 ? queue : [] } };
}
