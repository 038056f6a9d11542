// Places made of outlines: a new one around them, or events that add them to the present one.

import { startFor } from './free_ground';
import { count, type LeftOut } from './left_out';
import {
  type Bounds,
  boundsOfOutlines,
  obstacleOf,
  type ObstacleDefinition,
  type Outline,
  type PlaceDefinition,
  toMillimetre,
} from './place';

/** Free ground around what was imported: such a share of its size, at least [m]. */
const kMargin = { share: 0.08, least: 6 };
/** Cells of the ground: at most so many, and so large where places are large [m]. */
const kMostGround = 15.5e6;
const kCells = { fine: 0.25, usual: 0.5, fineUpTo: 200 };
/** What one message may hold (docs/protocol.md). */
export const kMostEvents = 256;
export const kMostBytes = 256 * 1024;

export interface EditMessage {
  readonly type: 'Edit';
  readonly label: string;
  readonly gesture: number;
  readonly events: string;
}

export function cellFor(wide: number, high: number): number {
  const usual = Math.max(wide, high) <= kCells.fineUpTo ? kCells.fine : kCells.usual;
  const least = Math.sqrt((wide * high) / kMostGround);
  return Math.max(usual, Math.ceil(least * 20) / 20);
}

/** The box of a place around these outlines. */
export function boxAround(outlines: readonly Outline[]): Bounds {
  const bounds = boundsOfOutlines(outlines) ?? { min: { x: -16, y: -16 }, max: { x: 16, y: 16 } };
  const { min, max } = bounds;
  const margin = Math.max(kMargin.least, kMargin.share * Math.max(max.x - min.x, max.y - min.y));
  return {
    min: { x: Math.floor(min.x - margin), y: Math.floor(min.y - margin) },
    max: { x: Math.ceil(max.x + margin), y: Math.ceil(max.y + margin) },
  };
}

/** A place around outlines, with people where they have room. */
export function placeAround(
  outlines: readonly Outline[],
  about: { readonly name: string; readonly description: string; readonly people: number },
): PlaceDefinition {
  const box = boxAround(outlines);
  const { x, y } = startFor(about.people, box, outlines);
  return {
    format: 'muster-scenario',
    version: 1,
    name: about.name,
    description: about.description,
    box: [
      [box.min.x, box.min.y],
      [box.max.x, box.max.y],
    ],
    cell: cellFor(box.max.x - box.min.x, box.max.y - box.min.y),
    obstacles: outlines.map(obstacleOf),
    groups: [
      {
        name: 'Crowd',
        count: about.people,
        formation: 'square',
        position: [toMillimetre(x), toMillimetre(y)],
        angle: 0,
      },
    ],
  };
}

/** Those that reach into a box; the others are counted. */
export function within(outlines: readonly Outline[], box: Bounds, left: LeftOut): Outline[] {
  const kept = outlines.filter((outline) => {
    const { min, max } = boundsOfOutlines([outline])!;
    return max.x > box.min.x && max.y > box.min.y && min.x < box.max.x && min.y < box.max.y;
  });
  count(left, 'outside', outlines.length - kept.length);
  return kept;
}

/** Messages that add obstacles; one undo takes all of them back. */
export function additionOf(obstacles: readonly ObstacleDefinition[], label: string, gesture: number): EditMessage[] {
  const bytes = new TextEncoder();
  const messages: EditMessage[] = [];
  let events: string[] = [];
  let size = 2;
  const send = (): void => {
    if (events.length > 0) messages.push({ type: 'Edit', label, gesture, events: `[${events.join(',')}]` });
    [events, size] = [[], 2];
  };
  for (const definition of obstacles) {
    const event = JSON.stringify({ kind: 'obstacle', definition });
    const own = bytes.encode(event).length + 1;
    if (events.length === kMostEvents || size + own > kMostBytes) send();
    events.push(event);
    size += own;
  }
  send();
  return messages;
}
