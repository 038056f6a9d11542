// What stands and lies in a place, as somebody who builds it takes hold of it: chosen, moved, turned, scaled, and told to
// the server by commands.

import type {
  AreaDef,
  CheckpointDef,
  Command,
  Given,
  GroupDef,
  ObstacleDef,
  PatchDef,
  RoleDef,
  TimedPath,
  Vec2,
} from '../../protocol/generated/commands';
import type { GroupBody, GroupBodyEdit } from '../../protocol/messages';
import type { AreaKindWord } from '../../protocol/generated/words';
import { isMoving, type SceneFacts } from '../../protocol/scene';
import { withChosen } from '../accent';
import { distance, distanceToSegment, insidePolygon, type GroundPoint } from '../plane';
import type { FormationWords } from '../sequence';
import { sortOf } from './people';

export type ThingKind = 'obstacle' | 'patch' | 'area' | 'item' | 'checkpoint' | 'group';

export const kThingKinds: readonly ThingKind[] = ['obstacle', 'patch', 'area', 'item', 'checkpoint', 'group'];

/** What an area does; see AreaDef. */
export interface AreaFields {
  readonly kind: AreaKindWord;
  readonly open: boolean;
  readonly rate: number;
  readonly queue: readonly Vec2[];
}

/** One thing. It has a polygon, or a centre with a radius. */
export interface Thing {
  readonly kind: ThingKind;
  /** 0 where it is not there yet. */
  readonly id: number;
  readonly name: string;
  readonly polygon: readonly Vec2[] | null;
  readonly centre: Vec2;
  readonly radius: number;
  /** Where a group faces; 0 for others [rad]. */
  readonly angle: number;
  /** Of an obstacle [m]. */
  readonly height: number;
  /** Of a patch: index into the scene's clips. */
  readonly motion: number;
  /** Of stairs: heading of the way up [rad]; null for other things. */
  readonly ascent: number | null;
  readonly area: AreaFields | null;
  readonly path: TimedPath | null;
  /** Of a group and a checkpoint. */
  readonly formation: FormationWords;
  readonly count: number;
  /** Of a group: what all have in common. */
  readonly body: GroupBody | null;
  readonly roles: readonly RoleDef[];
  /** Of a group: its colour number. */
  readonly colour: number;
  /** Fields of its definition that building leaves alone. */
  readonly rest: Readonly<Record<string, unknown>>;
  /** Id of the group that a checkpoint concerns, 0 for any; of a source, whom its people join. */
  readonly group: number;
}

/** What an edit changes: a command, or the bodies of a group. */
export type PlaceChange = Command | { readonly kind: 'groupBody'; readonly edit: GroupBodyEdit };

const kBlank: Thing = {
  kind: 'obstacle',
  id: 0,
  name: '',
  polygon: null,
  centre: [0, 0],
  radius: 0,
  angle: 0,
  height: 3,
  motion: 0,
  ascent: null,
  area: null,
  path: null,
  formation: { kind: 'square', spacing: 1 },
  count: 0,
  body: null,
  roles: [],
  colour: 0,
  rest: {},
  group: 0,
};

export function thing(kind: ThingKind, fields: Partial<Thing>): Thing {
  return { ...kBlank, kind, ...fields };
}

/** The mean of the corners. */
export function middle(polygon: readonly Vec2[]): Vec2 {
  const sum = polygon.reduce(([x, y], p) => [x + p[0], y + p[1]] as const, [0, 0] as Vec2);
  return [sum[0] / Math.max(1, polygon.length), sum[1] / Math.max(1, polygon.length)];
}

/** The room that so many people take: about as a disc. */
export function groupRadius(count: number, spacing: number): number {
  return 0.6 * spacing * Math.sqrt(Math.max(1, count)) + 0.3;
}

function shapeOf({ polygon, centre, radius }: { polygon: readonly Vec2[]; centre?: Vec2; radius?: number }) {
  if (polygon.length > 0) return { polygon, centre: middle(polygon), radius: 0 };
  return { polygon: null, centre: centre ?? ([0, 0] as const), radius: radius ?? 0 };
}

const pathOf = (path: TimedPath): TimedPath | null => (isMoving({ path }) ? path : null);

/** All that can be taken hold of, what lies on top last. */
export function thingsOf(scene: SceneFacts): Thing[] {
  const patches = scene.patches.map(({ id, name, polygon, motion, path, ascent, speed, speedDown }) =>
    thing('patch', {
      id,
      name,
      ...shapeOf({ polygon }),
      motion,
      ascent,
      path: pathOf(path),
      rest: { speed, speedDown },
    }),
  );
  const obstacles = scene.obstacles.map(({ id, name, height, path, range, strength, ...shape }) =>
    thing('obstacle', { id, name, ...shapeOf(shape), height, path: pathOf(path), rest: { range, strength } }),
  );
  const checkpoints = scene.checkpoints.map(({ id, position: centre, radius, formation, group, ...rest }) =>
    thing('checkpoint', { id, centre, radius, formation, group, rest }),
  );
  const items = scene.items.map(({ id, position: centre, radius }) => thing('item', { id, centre, radius }));
  return [...patches, ...areasOf(scene), ...obstacles, ...checkpoints, ...items, ...groupsOf(scene)];
}

function areasOf({ areas }: SceneFacts): Thing[] {
  return areas.map(({ id, name, polygon, kind, open, rate, queue, group, ...rest }) =>
    thing('area', { id, name, ...shapeOf({ polygon }), area: { kind, open, rate, queue }, group, rest }),
  );
}

function groupsOf({ groups }: SceneFacts): Thing[] {
  return groups
    .filter(({ placed }) => placed)
    .map(({ id, accent, body, definition }) => {
      const {
        name,
        count,
        position: centre,
        angle,
        formation,
        bodies,
        roles,
        colour,
        build,
        motions,
        people,
      } = definition;
      return thing('group', {
        id,
        name,
        count,
        centre,
        angle,
        formation,
        body,
        roles,
        colour: withChosen(accent, colour),
        rest: { bodies, roles, colour, build, motions, people: people.map(sortOf) },
        radius: groupRadius(count, formation.spacing),
      });
    });
}

export function sameThing(a: Pick<Thing, 'kind' | 'id'>, b: Pick<Thing, 'kind' | 'id'>): boolean {
  return a.kind === b.kind && a.id === b.id;
}

/** Maps every point of a thing; `turn` [rad] turns headings and routes, `scale` grows radii and routes. */
function mapped(one: Thing, map: (p: Vec2) => Vec2, turn: number, scale: number): Thing {
  const [c, s] = [Math.cos(turn) * scale, Math.sin(turn) * scale];
  const grows = one.kind !== 'group';
  return {
    ...one,
    polygon: one.polygon?.map(map) ?? null,
    centre: map(one.centre),
    radius: grows ? Math.max(0.05, one.radius * scale) : one.radius,
    angle: one.angle + turn,
    ascent: one.ascent === null ? null : one.ascent + turn,
    area: one.area && { ...one.area, queue: one.area.queue.map(map) },
    path: one.path && {
      ...one.path,
      waypoints: one.path.waypoints.map(({ time, position: [x, y], angle }) => ({
        time,
        position: [c * x - s * y, s * x + c * y],
        angle,
      })),
    },
  };
}

export function moved(one: Thing, dx: number, dy: number): Thing {
  return mapped(one, ([x, y]) => [x + dx, y + dy], 0, 1);
}

/** What is pasted or doubled stands beside the old one [m]. */
const kBeside = 1;

/** Another one like it, beside it. */
export function beside(one: Thing): Thing {
  return moved({ ...one, id: 0 }, kBeside, -kBeside);
}

export function turned(one: Thing, about: GroundPoint, angle: number): Thing {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const map = ([x, y]: Vec2): Vec2 => {
    const [dx, dy] = [x - about.x, y - about.y];
    return [about.x + c * dx - s * dy, about.y + s * dx + c * dy];
  };
  return mapped(one, map, angle, 1);
}

export function scaled(one: Thing, about: GroundPoint, factor: number): Thing {
  const map = ([x, y]: Vec2): Vec2 => [about.x + factor * (x - about.x), about.y + factor * (y - about.y)];
  return mapped(one, map, 0, factor);
}

function obstacleOf({ name, polygon, centre, radius, height, path, rest }: Thing): Given<ObstacleDef> {
  const shape = polygon ? { polygon } : { centre, radius };
  return { name, ...shape, height, ...(path ? { path } : {}), ...rest };
}

function patchOf({ name, polygon, motion, ascent, path, rest }: Thing): Given<PatchDef> {
  return { name, polygon: polygon ?? [], motion, ascent, ...(path ? { path } : {}), ...rest };
}

function areaOf({ name, polygon, area, rest }: Thing): Given<AreaDef> {
  const { kind, open, rate, queue } = area!;
  return { name, polygon: polygon ?? [], kind, open, rate, queue: queue.length > 1 ? queue : [], ...rest };
}

function groupOf({ name, count, formation, centre, angle, rest }: Thing): Given<GroupDef> {
  return { name, count, formation, position: centre, angle, ...rest };
}

/** Puts the thing there. */
export function addCommand(one: Thing): Command {
  switch (one.kind) {
    case 'group':
      return { kind: 'group', group: groupOf(one) };
    case 'area':
      return { kind: 'putThing', area: areaOf(one), group: one.group };
    case 'obstacle':
      return { kind: 'putThing', obstacle: obstacleOf(one) };
    case 'patch':
      return { kind: 'putThing', patch: patchOf(one) };
    case 'item':
      return { kind: 'putThing', item: { position: one.centre, radius: one.radius } };
    case 'checkpoint':
      return { kind: 'putThing', checkpoint: checkpointOf(one), group: one.group };
  }
}

function checkpointOf({ centre, radius, formation, rest }: Thing): Given<CheckpointDef> {
  return { position: centre, radius, formation, ...rest };
}

/** Makes the thing of that id as it is here. A group is placed; its other fields have commands of their own. */
export function changeCommand(one: Thing): Command {
  const added = addCommand(one);
  if (added.kind === 'putThing') return { ...added, id: one.id };
  return { kind: 'pose', group: one.id, position: one.centre, angle: one.angle, characters: true };
}

export function removeCommand({ kind, id }: Thing): Command {
  return kind === 'group' ? { kind: 'removeGroup', group: id } : { kind: 'removeThing', thing: kind, id };
}

/** Its corners, or points on its circle. */
export function outlineOf(one: Thing, corners = 24): GroundPoint[] {
  if (one.polygon) return one.polygon.map(([x, y]) => ({ x, y }));
  return Array.from({ length: corners }, (_, k) => {
    const angle = (2 * Math.PI * k) / corners;
    return { x: one.centre[0] + one.radius * Math.cos(angle), y: one.centre[1] + one.radius * Math.sin(angle) };
  });
}

/** The thing on top at a point, where anything is nearer than `reach` [m]; null for none. */
export function hit(things: readonly Thing[], p: GroundPoint, reach: number): Thing | null {
  for (let k = things.length - 1; k >= 0; --k) {
    const one = things[k]!;
    const inside = one.polygon
      ? insidePolygon(p, outlineOf(one))
      : distance(p, { x: one.centre[0], y: one.centre[1] }) <= Math.max(one.radius, reach);
    if (inside) return one;
  }
  const near = things.map((one) => ({ one, far: farFrom(outlineOf(one), p) }));
  const nearest = near.reduce<(typeof near)[0] | null>((best, it) => (best && best.far <= it.far ? best : it), null);
  return nearest && nearest.far <= reach ? nearest.one : null;
}

/** How far a point lies from an outline [m]. */
function farFrom(outline: readonly GroundPoint[], p: GroundPoint): number {
  const sides = outline.map((a, k) => distanceToSegment(p, a, outline[(k + 1) % outline.length]!));
  return Math.min(Infinity, ...sides);
}

/** Those whose middle lies in the polygon. */
export function within(things: readonly Thing[], polygon: readonly GroundPoint[]): Thing[] {
  return things.filter((one) => insidePolygon({ x: one.centre[0], y: one.centre[1] }, polygon));
}

export interface Extent {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** The box round all of them; null for none. */
export function extentOf(things: readonly Thing[]): Extent | null {
  const points = things.flatMap((one) => outlineOf(one));
  if (points.length === 0) return null;
  const xs = points.map(({ x }) => x);
  const ys = points.map(({ y }) => y);
  return { minX: Math.min(...xs), minY: Math.min(...ys), maxX: Math.max(...xs), maxY: Math.max(...ys) };
}

/** The middle of the box round all of them; null for none. */
export function middleOfAll(all: readonly Thing[]): GroundPoint | null {
  const extent = extentOf(all);
  return extent && { x: (extent.minX + extent.maxX) / 2, y: (extent.minY + extent.maxY) / 2 };
}

/** Who was chosen before is chosen after: by id in the same world, by the place in the list in one that began anew. */
export function chosenAgain(
  chosen: readonly Thing[],
  before: readonly Thing[],
  after: readonly Thing[],
  sameWorld: boolean,
): Thing[] {
  if (sameWorld) return after.filter((one) => chosen.some((old) => sameThing(old, one)));
  if (before.length !== after.length) return [];
  return after.filter((one, k) => before[k]!.kind === one.kind && chosen.some((old) => sameThing(old, before[k]!)));
}
