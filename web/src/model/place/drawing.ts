// Things as they are drawn: from where a pointer came down to where it is.

import type { AreaKindWord } from '../../protocol/generated/words';
import type { Vec2 } from '../../protocol/generated/commands';
import { formationKind } from '../sequence';
import { distance, type GroundPoint } from '../plane';
import { gated, kNever } from './gates';
import { depthFor, kAreas, kClimbed, kJumped, kNames, motionOf, type PlaceClip } from './motions';
import { groupRadius, middle, thing, type Thing } from './things';

export const kBuildTools = [
  'select',
  'wall',
  'door',
  'gate',
  'hedge',
  'water',
  'net',
  'branches',
  'stairs',
  'car',
  'box',
  'disc',
  'polygon',
  'route',
  'exit',
  'source',
  'waiting',
  'people',
  'item',
  'checkpoint',
] as const;
export type BuildTool = (typeof kBuildTools)[number];

/** What new things are like. */
export interface DrawingOptions {
  /** Motions of the place. */
  readonly clips: readonly PlaceClip[];
  /** Of obstacles and walls, which people climb where they are low, and of hedges, which they jump there [m]. */
  readonly height: number;
  readonly hedgeHeight: number;
  /** Of walls, and of doors [m]. */
  readonly width: number;
  readonly doorWidth: number;
  /** Of gates: when they open and shut again [s]. */
  readonly opens: number;
  readonly shuts: number;
  /** Of stairs: across the way up [m], travel speeds relative to running. */
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
  clips: [],
  height: 3,
  hedgeHeight: kJumped.height,
  width: 0.3,
  doorWidth: 1.2,
  opens: kNever,
  shuts: kNever,
  speed: 1.5,
  formation: 'square',
  count: 20,
  spacing: 1,
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
/** Ground that is drawn from corner to corner: its motion. */
const kGrounds = { water: 'swim', net: 'crawl', branches: 'duck' } as const;
/** Of hedges that nobody jumps, and of gates [m]. */
const kHedgeWidth = 0.6;
const kGate = { width: 0.2, height: 2 };

/** The motion that a tool makes ground of; empty for none. */
export function motionOfTool(tool: BuildTool, { height, hedgeHeight }: DrawingOptions): string {
  if (tool === 'water' || tool === 'net' || tool === 'branches') return kGrounds[tool];
  if (tool === 'stairs') return 'walk';
  if (tool === 'hedge') return hedgeHeight <= kJumped.most ? 'jump' : '';
  return tool === 'wall' && height <= kClimbed.most ? 'climb' : '';
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

type Maker = (a: GroundPoint, b: GroundPoint, options: DrawingOptions, tool: BuildTool) => Thing | null;

const ground: Maker = (a, b, options, tool) =>
  groundThing(boxOf(a, b), kNames[kGrounds[tool as keyof typeof kGrounds]], tool, options);
const area: Maker = (a, b, options, tool) => areaThing(tool as AreaKindWord, boxOf(a, b), options);
const formationOf = ({ formation, spacing }: DrawingOptions): Thing['formation'] => ({
  kind: formationKind(formation),
  spacing,
});

const kMakers: Partial<Record<BuildTool, Maker>> = {
  box: (a, b, { height }) => polygonThing(boxOf(a, b), height),
  disc: (a, b, { height }) => thing('obstacle', { ...round(a, b, kPressed.disc), height }),
  wall: barrier,
  hedge: barrier,
  gate: barrier,
  water: ground,
  net: ground,
  branches: ground,
  exit: area,
  source: area,
  waiting: area,
  stairs: stairsThing,
  item: (_a, b) => thing('item', { centre: [b.x, b.y], radius: kPressed.item }),
  checkpoint: (a, b, options) =>
    thing('checkpoint', { ...round(a, b, kPressed.checkpoint), formation: formationOf(options) }),
  people: (a, b, options) => {
    const { count, spacing } = options;
    const angle = distance(a, b) < kPress ? 0 : Math.atan2(b.y - a.y, b.x - a.x);
    const radius = groupRadius(count, spacing);
    return thing('group', { name: 'Group', centre: [a.x, a.y], angle, count, formation: formationOf(options), radius });
  },
};

/** The thing that a stroke from `a` to `b` makes by a tool; null where it makes none. */
export function drawn(tool: BuildTool, a: GroundPoint, b: GroundPoint, options: DrawingOptions): Thing | null {
  return kMakers[tool]?.(a, b, options, tool) ?? null;
}

/** Ground on which people do what its motion says; null where the place has no such motion. */
function groundThing(polygon: readonly Vec2[], name: string, tool: BuildTool, options: DrawingOptions): Thing | null {
  const motion = motionOf(options.clips, motionOfTool(tool, options));
  return motion < 0 ? null : thing('patch', { name, polygon, centre: middle(polygon), motion });
}

/** What stands along the line, across the way of people; null for a press. */
function barrier(a: GroundPoint, b: GroundPoint, options: DrawingOptions, tool: BuildTool): Thing | null {
  const length = distance(a, b);
  if (length < kPress) return null;
  const over = motionOf(options.clips, motionOfTool(tool, options));
  if (over >= 0) {
    // Who jumps or climbs may come from any side.
    const depth = depthFor(options.clips[over]);
    const share = Math.max(1, depth / length);
    const end = { x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) };
    return groundThing(wallOf(a, end, depth)!, tool === 'hedge' ? 'Hedge' : 'Wall', tool, options);
  }
  if (tool === 'wall') return polygonThing(wallOf(a, b, options.width)!, options.height);
  if (tool === 'hedge') return { ...polygonThing(wallOf(a, b, kHedgeWidth)!, options.hedgeHeight)!, name: 'Hedge' };
  return gated({ ...polygonThing(wallOf(a, b, kGate.width)!, kGate.height)!, name: 'Gate' }, options);
}

/** Up from `a` to `b`; null for a press. */
function stairsThing(a: GroundPoint, b: GroundPoint, options: DrawingOptions): Thing | null {
  const polygon = wallOf(a, b, options.stairsWidth);
  const ascent = Math.atan2(b.y - a.y, b.x - a.x);
  const rest = { speed: options.speedUp, speedDown: options.speedDown };
  const motion = Math.max(0, motionOf(options.clips, 'walk'));
  return polygon && thing('patch', { name: 'Stairs', polygon, centre: middle(polygon), motion, ascent, rest });
}

function areaThing(kind: AreaKindWord, polygon: readonly Vec2[], options: DrawingOptions): Thing {
  const rate = { exit: options.exitRate, source: options.sourceRate, waiting: 0 }[kind];
  const area = { kind, open: true, rate, queue: [] };
  const group = kind === 'source' ? options.sourceGroup : 0;
  return thing('area', { name: kAreas[kind], polygon, centre: middle(polygon), area, group });
}

/** An obstacle with these corners; null for fewer than three. */
export function polygonThing(polygon: readonly Vec2[], height: number): Thing | null {
  return polygon.length < 3 ? null : thing('obstacle', { polygon, centre: middle(polygon), height });
}
