// Things as they are drawn: from where a pointer came down to where it is.

import type { AreaKindWord } from '../../protocol/generated/words';
import type { Vec2 } from '../../protocol/generated/commands';
import { formationKind } from '../sequence';
import { distance, type GroundPoint } from '../plane';
import { groupRadius, thing, type Thing } from './things';

export const kBuildTools = [
  'select',
  'box',
  'disc',
  'polygon',
  'wall',
  'patch',
  'stairs',
  'route',
  'exit',
  'source',
  'waiting',
  'item',
  'checkpoint',
  'people',
] as const;
export type BuildTool = (typeof kBuildTools)[number];

/** What new things are like. */
export interface DrawingOptions {
  /** Of walls and other obstacles [m]. */
  readonly height: number;
  /** Of walls [m]. */
  readonly width: number;
  /** Of patches: index into the scene's clips. */
  readonly motion: number;
  /** Of stairs: index into the scene's clips, across the way up [m], travel speeds relative to running. */
  readonly stairsMotion: number;
  readonly stairsWidth: number;
  readonly speedUp: number;
  readonly speedDown: number;
  /** Of exits: the most who leave [1/s], 0 for as many as come. */
  readonly exitRate: number;
  /** Of sources: how many come [1/s], and whom they join: id of a group, 0 for a new one. */
  readonly sourceRate: number;
  readonly sourceGroup: number;
  /** Of movers [m/s]. */
  readonly speed: number;
  /** Of people and checkpoints. */
  readonly formation: string;
  readonly count: number;
  /** Between people [m]. */
  readonly spacing: number;
}

/** What is drawn before anything else was chosen. */
export const kDrawingOptions: DrawingOptions = {
  height: 3,
  width: 0.3,
  motion: 3,
  speed: 1.5,
  formation: 'square',
  count: 20,
  spacing: 1,
  stairsMotion: 1,
  stairsWidth: 2,
  speedUp: 0.5,
  speedDown: 0.7,
  exitRate: 0,
  sourceRate: 1,
  sourceGroup: 0,
};

/** Shorter strokes are presses [m]. */
const kPress = 0.3;
/** Of what is pressed, not drawn [m]. */
const kPressed = { box: 1, disc: 0.5, checkpoint: 2, item: 0.5 };
const kAreaNames = { exit: 'Exit', source: 'Source', waiting: 'Waiting area' };
/** Points of a route lie so far apart [m]. */
const kRouteStep = 0.5;

export function isAreaTool(tool: BuildTool): tool is AreaKindWord {
  return tool in kAreaNames;
}

function rectangle(a: GroundPoint, b: GroundPoint): Vec2[] {
  const [x0, x1] = [Math.min(a.x, b.x), Math.max(a.x, b.x)];
  const [y0, y1] = [Math.min(a.y, b.y), Math.max(a.y, b.y)];
  return [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
}

function boxOf(a: GroundPoint, b: GroundPoint): Vec2[] {
  const flat = Math.abs(a.x - b.x) < 0.1 || Math.abs(a.y - b.y) < 0.1;
  const half = kPressed.box;
  return flat ? rectangle({ x: a.x - half, y: a.y - half }, { x: a.x + half, y: a.y + half }) : rectangle(a, b);
}

/** A wall of that width along the line; null for a press. */
export function wallOf(a: GroundPoint, b: GroundPoint, width: number): Vec2[] | null {
  const length = distance(a, b);
  if (length < kPress) return null;
  const [nx, ny] = [((a.y - b.y) / length) * (width / 2), ((b.x - a.x) / length) * (width / 2)];
  return [
    [a.x - nx, a.y - ny],
    [b.x - nx, b.y - ny],
    [b.x + nx, b.y + ny],
    [a.x + nx, a.y + ny],
  ];
}

function round(a: GroundPoint, b: GroundPoint, pressed: number): { centre: Vec2; radius: number } {
  const radius = distance(a, b);
  return { centre: [a.x, a.y], radius: radius < kPress ? pressed : radius };
}

/** The thing that a stroke from `a` to `b` makes by a tool; null where it makes none. */
export function drawn(tool: BuildTool, a: GroundPoint, b: GroundPoint, options: DrawingOptions): Thing | null {
  const { height, motion, count, spacing } = options;
  const formation = { kind: formationKind(options.formation), spacing };
  if (isAreaTool(tool)) return areaThing(tool, boxOf(a, b), options);
  switch (tool) {
    case 'box':
      return polygonThing(boxOf(a, b), height);
    case 'disc':
      return thing('obstacle', { ...round(a, b, kPressed.disc), height });
    case 'wall': {
      const polygon = wallOf(a, b, options.width);
      return polygon && polygonThing(polygon, height);
    }
    case 'patch': {
      const polygon = boxOf(a, b);
      return thing('patch', { polygon, centre: centreOf(polygon), motion });
    }
    case 'stairs':
      return stairsThing(a, b, options);
    case 'item':
      return thing('item', { centre: [b.x, b.y], radius: kPressed.item });
    case 'checkpoint':
      return thing('checkpoint', { ...round(a, b, kPressed.checkpoint), formation });
    case 'people': {
      const angle = distance(a, b) < kPress ? 0 : Math.atan2(b.y - a.y, b.x - a.x);
      const radius = groupRadius(count, spacing);
      return thing('group', { name: 'Group', centre: [a.x, a.y], angle, count, formation, radius });
    }
    case 'select':
    case 'polygon':
    case 'route':
      return null;
  }
}

/** Up from `a` to `b`; null for a press. */
function stairsThing(a: GroundPoint, b: GroundPoint, options: DrawingOptions): Thing | null {
  const polygon = wallOf(a, b, options.stairsWidth);
  const ascent = Math.atan2(b.y - a.y, b.x - a.x);
  const rest = { speed: options.speedUp, speedDown: options.speedDown };
  const { stairsMotion: motion } = options;
  return polygon && thing('patch', { name: 'Stairs', polygon, centre: centreOf(polygon), motion, ascent, rest });
}

function areaThing(kind: AreaKindWord, polygon: readonly Vec2[], options: DrawingOptions): Thing {
  const rate = { exit: options.exitRate, source: options.sourceRate, waiting: 0 }[kind];
  const area = { kind, open: true, rate, queue: [] };
  const group = kind === 'source' ? options.sourceGroup : 0;
  return thing('area', { name: kAreaNames[kind], polygon, centre: centreOf(polygon), area, group });
}

function centreOf(polygon: readonly Vec2[]): Vec2 {
  const sum = polygon.reduce(([x, y], p) => [x + p[0], y + p[1]] as const, [0, 0] as Vec2);
  return [sum[0] / polygon.length, sum[1] / polygon.length];
}

/** An obstacle with these corners; null for fewer than three. */
export function polygonThing(polygon: readonly Vec2[], height: number): Thing | null {
  return polygon.length < 3 ? null : thing('obstacle', { polygon, centre: centreOf(polygon), height });
}

/** The thing moves along a drawn line and back, or round where the line ends near its beginning. `now` is the time of the
 * world [s]: it starts at once. */
export function routed(one: Thing, line: readonly GroundPoint[], speed: number): Thing {
  const points = line.filter((p, k) => k === 0 || k === line.length - 1 || distance(p, line[k - 1]!) >= 0);
  const kept: GroundPoint[] = [];
  for (const p of points) if (kept.length === 0 || distance(p, kept[kept.length - 1]!) >= kRouteStep) kept.push(p);
  if (kept.length < 2) return { ...one, path: null };
  const first = kept[0]!;
  const closes = distance(first, kept[kept.length - 1]!) < 3 * kRouteStep && kept.length > 6;
  const way = closes ? [...kept.slice(0, -1), first] : [...kept, ...[...kept].reverse().slice(1)];
  let t = 0;
  const waypoints = way.map((p, k) => {
    if (k > 0) t += distance(p, way[k - 1]!) / Math.max(0.05, speed);
    return { time: t, position: [p.x - first.x, p.y - first.y] as const, angle: 0 };
  });
  return { ...one, path: { waypoints, loop: true } };
}
