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
} from '../../protocol/generated/commands';
import type { GroupBodyEdit } from '../../protocol/messages';
import type { AreaKind, Point2, SceneFacts, SceneGroupBody, ScenePath, SceneRole } from '../../protocol/scene';
import { colourNumber, numberOfColour } from '../accent';
import { distance, insidePolygon, type GroundPoint } from '../plane';
import type { FormationWords } from '../sequence';
import { formationOf } from './formation';
import { likeGroup, type GroupBody } from './group_body';
import { sortsOf } from './people';

export type ThingKind = 'obstacle' | 'patch' | 'area' | 'item' | 'checkpoint' | 'group';

export const kThingKinds: readonly ThingKind[] = ['obstacle', 'patch', 'area', 'item', 'checkpoint', 'group'];

/** What an area does; see SceneArea. */
export interface AreaFields {
  readonly kind: AreaKind;
  readonly open: boolean;
  readonly rate: number;
  readonly queue: readonly Point2[];
}

/** One thing. It has a polygon, or a centre with a radius. */
export interface Thing {
  readonly kind: ThingKind;
  /** 0 where it is not there yet. */
  readonly id: number;
  readonly name: string;
  readonly polygon: readonly Point2[] | null;
  readonly centre: Point2;
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
function middle(polygon: readonly Point2[]): Point2 {
  const sum = polygon.reduce(([x, y], p) => [x + p[0], y + p[1]] as const, [0, 0] as Point2);
  return [sum[0] / Math.max(1, polygon.length), sum[1] / Math.max(1, polygon.length)];
}

function present(fields: Readonly<Record<string, unknown>>): Record<string, unknown> {
  return Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== undefined));
}

/** The room that so many people take: about as a disc. */
export function groupRadius(count: number, spacing: number): number {
  return 0.6 * spacing * Math.sqrt(Math.max(1, count)) + 0.3;
}

function shapeOf(polygon: readonly Point2[] | undefined, centre: Point2 | undefined, radius: number | undefined) {
  const corners = polygon && polygon.length > 0 ? polygon : null;
  return {
    polygon: corners,
    centre: corners ? middle(corners) : (centre ?? [0, 0]),
    radius: corners ? 0 : (radius ?? 0),
  };
}

function pathOf(path: ScenePath | undefined): TimedPath | null {
  const waypoints = path?.waypoints.map(({ t, x, y, angle }) => ({ time: t, position: [x, y] as const, angle }));
  return path && waypoints ? { waypoints, loop: path.loop } : null;
}

function bodyOf({ class: unitClass, ...body }: SceneGroupBody): GroupBody {
  return { ...body, ...(unitClass === undefined ? {} : { unitClass }) };
}

function rolesOf(roles: readonly SceneRole[] | undefined): RoleDef[] {
  return (roles ?? []).map(({ area, class: unitClass }) => ({ area: area as RoleDef['area'], unitClass }));
}

/** All that can be taken hold of, what lies on top last. */
export function thingsOf(scene: SceneFacts): Thing[] {
  const patches = scene.patches.map(({ id, name, polygon, motion, path, ownSpeed, ascent, speedDown }) =>
    thing('patch', {
      id,
      name,
      ...shapeOf(polygon, undefined, undefined),
      motion,
      ascent: ascent ?? null,
      path: pathOf(path),
      rest: present({ speed: ownSpeed, speedDown }),
    }),
  );
  const obstacles = scene.obstacles.map(({ id, name, polygon, centre, radius, height, path, range, strength }) =>
    thing('obstacle', {
      id,
      name,
      ...shapeOf(polygon, centre, radius),
      height,
      path: pathOf(path),
      rest: present({ range, strength }),
    }),
  );
  const checkpoints = scene.checkpoints.map(({ id, position, radius, shape, group, once, trigger, share }) =>
    thing('checkpoint', {
      id,
      centre: position,
      radius,
      formation: formationOf(shape),
      group,
      rest: present({ once, trigger, share }),
    }),
  );
  const items = scene.items.map(({ id, position, radius }) => thing('item', { id, centre: position, radius }));
  const groups = groupsOf(scene);
  return [...patches, ...areasOf(scene), ...obstacles, ...checkpoints, ...items, ...groups];
}

function areasOf(scene: SceneFacts): Thing[] {
  return scene.areas.map(({ id, name, polygon, kind, open, rate, queue, group, from, until, most, timetable }) =>
    thing('area', {
      id,
      name: name ?? '',
      ...shapeOf(polygon, undefined, undefined),
      area: { kind, open, rate, queue: queue ?? [] },
      group: group ?? 0,
      rest: present({ from, until, most, timetable: timetable?.map(({ t, count }) => ({ time: t, count })) }),
    }),
  );
}

function groupsOf(scene: SceneFacts): Thing[] {
  const speed = scene.parameters.find(({ name }) => name === 'character.maxSpeed')?.value;
  const usual: GroupBody = { radius: scene.radius, maxSpeed: speed ?? 2, unitClass: 0 };
  return scene.groups.flatMap(({ id, name, count, colour, chosenColour, build, motions, start }) =>
    start
      ? [
          thing('group', {
            id,
            name,
            count: start.count ?? count,
            centre: start.position,
            angle: start.angle,
            formation: formationOf(start.formation),
            body: start.body ? bodyOf(start.body) : null,
            roles: rolesOf(start.roles),
            colour: colourNumber(colour, chosenColour),
            rest: {
              ...likeGroup(bodyOf(start.body ?? {}), rolesOf(start.roles), usual),
              ...present({ build, motions }),
              ...(chosenColour === undefined ? {} : { colour: numberOfColour(chosenColour) }),
              ...(start.people === undefined ? {} : { people: sortsOf(start.people) }),
            },
            radius: groupRadius(start.count ?? count, start.formation.spacing ?? 1),
          }),
        ]
      : [],
  );
}

export function sameThing(a: Pick<Thing, 'kind' | 'id'>, b: Pick<Thing, 'kind' | 'id'>): boolean {
  return a.kind === b.kind && a.id === b.id;
}

/** Maps every point of a thing; `turn` [rad] turns headings and routes, `scale` grows radii and routes. */
function mapped(one: Thing, map: (p: Point2) => Point2, turn: number, scale: number): Thing {
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

export function turned(one: Thing, about: GroundPoint, angle: number): Thing {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const map = ([x, y]: Point2): Point2 => {
    const [dx, dy] = [x - about.x, y - about.y];
    return [about.x + c * dx - s * dy, about.y + s * dx + c * dy];
  };
  return mapped(one, map, angle, 1);
}

export function scaled(one: Thing, about: GroundPoint, factor: number): Thing {
  const map = ([x, y]: Point2): Point2 => [about.x + factor * (x - about.x), about.y + factor * (y - about.y)];
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
  return { kind: 'placeGroup', group: one.id, position: one.centre, angle: one.angle };
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
  const near = things.find((one) => outlineOf(one).some((corner) => distance(corner, p) <= reach));
  return near ?? null;
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
