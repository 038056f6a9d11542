// What people do on a thing: by motions of its ground, or they go round it. Some motions are played once across a thing, which
// then has to be as deep as a play is long.

import type { Vec2 } from '../../protocol/generated/commands';
import { convexHull } from '../plane';
import { frameOf, isCarSized, reachAlong, resized, stretched } from './frame';
import { gateOf } from './gates';
import { extentOf, moved, thing, type Thing } from './things';
import type { SceneFacts } from '../../protocol/scene';

/** A motion of the place. `length`: of one play, where people play it once across a thing; else 0 [m]. */
export interface PlaceClip {
  readonly name: string;
  readonly length: number;
}

/** A thing may differ by so much of a play (`muster check` says the same). */
const kShare = 0.15;
/** Where a play's length is not known [m]. */
const kUsualDepth = 2;
/** Lower ones are jumped or climbed [m]. */
export const kJumped = { height: 0.5, most: 0.7 };
export const kClimbed = { height: 1.3, most: 1.4 };
/** How deep what nobody climbs is [m]. */
const kThick = 0.3;

const kWords: Readonly<Record<string, string>> = {
  run: 'Run',
  walk: 'Walk',
  duck: 'Duck',
  crawl: 'Crawl',
  swim: 'Swim',
  jump: 'Jump over',
  climb: 'Climb over',
  idle: 'Stand',
};
export const kGoRound = 'Go round';

/** What ground with a motion is called. */
export const kNames = {
  swim: 'Water',
  crawl: 'Net',
  jump: 'Hedge',
  climb: 'Low wall',
  duck: 'Branches',
} as const;

export function motionWord(clip: string): string {
  return kWords[clip] ?? clip.charAt(0).toUpperCase() + clip.slice(1);
}

/** Index of a motion; -1 where the place has none of that name. */
export function motionOf(clips: readonly PlaceClip[], name: string): number {
  return clips.findIndex((one) => one.name === name);
}

function nameOfObstacle(one: Thing): string {
  if (one.polygon === null) return 'Pillar';
  if (gateOf(one)) return 'Gate';
  const { length, width } = frameOf(one.polygon);
  if (one.path) return isCarSized(length, width) ? 'Car' : 'Mover';
  return Math.min(length, width) < 0.2 * Math.max(length, width) ? 'Wall' : 'Block';
}

const kOthers = { item: 'Item', checkpoint: 'Checkpoint', group: 'People' };
export const kAreas = { exit: 'Exit', source: 'Source', waiting: 'Waiting area' };

/** What a thing is. */
export function kindName(one: Thing, clips: readonly PlaceClip[]): string {
  if (one.area) return kAreas[one.area.kind];
  if (one.kind === 'obstacle') return nameOfObstacle(one);
  if (one.kind !== 'patch') return kOthers[one.kind as keyof typeof kOthers];
  return one.ascent !== null ? 'Stairs' : (kNames[clips[one.motion]?.name as keyof typeof kNames] ?? 'Ground');
}

/** The direction in which it is least across, and how far. */
function leastAcross(polygon: readonly Vec2[]): { readonly axis: Vec2; readonly width: number } {
  const hull = convexHull(polygon.map(([x, y]) => ({ x, y })));
  let best = { axis: [1, 0] as Vec2, width: Infinity };
  hull.forEach((a, k) => {
    const b = hull[(k + 1) % hull.length]!;
    const side = Math.hypot(b.x - a.x, b.y - a.y);
    const axis: Vec2 = [(a.y - b.y) / side, (b.x - a.x) / side];
    const [from, to] = reachAlong(polygon, axis);
    if (to - from < best.width) best = { axis, width: to - from };
  });
  return best;
}

/** As deep as a play, in its narrowest direction; nowhere less. */
function fitted(one: Thing, length: number): Thing {
  let made = one;
  for (let k = 0; k < 4 && made.polygon; ++k) {
    const { axis, width } = leastAcross(made.polygon);
    if (Math.abs(width - length) < 1e-6) break;
    const middle = (along: Vec2): number => reachAlong(made.polygon!, along).reduce((from, to) => (from + to) / 2);
    const [u, v] = [middle(axis), middle([-axis[1], axis[0]])];
    const about = { x: u * axis[0] - v * axis[1], y: u * axis[1] + v * axis[0] };
    made = stretched(made, about, axis, length / width);
  }
  return made;
}

export interface Mistake {
  readonly thing: Thing;
  readonly text: string;
  /** The thing without it. */
  readonly fits: Thing;
}

/** Why people cannot do there what they should; null where they can. */
export function mistakeOf(one: Thing, clips: readonly PlaceClip[]): Mistake | null {
  const clip = one.kind === 'patch' && one.ascent === null ? clips[one.motion] : undefined;
  if (!clip || clip.length <= 0 || !one.polygon) return null;
  const { width } = leastAcross(one.polygon);
  if (Math.abs(width - clip.length) <= kShare * clip.length) return null;
  const [least, most] = [(1 - kShare) * clip.length, (1 + kShare) * clip.length];
  const does = motionWord(clip.name).toLowerCase();
  const text = `${one.name || kindName(one, clips)} is ${width.toFixed(1)} m deep; people can ${does} ${least.toFixed(1)} to ${most.toFixed(1)} m.`;
  return { thing: one, text, fits: fitted(one, clip.length) };
}

/** So far a span has to move to lie within another one; a longer one ends with it in the middle. */
function shiftWithin(low: number, high: number, least: number, most: number): number {
  if (high - low > most - least) return (least + most - low - high) / 2;
  return Math.max(0, least - low) + Math.min(0, most - high);
}

/** What has its middle beyond the ground, where nobody goes; null for all else. */
export function outsideOf(one: Thing, { min, max }: SceneFacts['box'], clips: readonly PlaceClip[]): Mistake | null {
  const [x, y] = one.centre;
  const extent = extentOf([one]);
  if (!extent || (x >= min[0] && x <= max[0] && y >= min[1] && y <= max[1])) return null;
  const text = `${one.name || kindName(one, clips)} lies beyond the ground, where nobody can go.`;
  const dx = shiftWithin(extent.minX, extent.maxX, min[0], max[0]);
  return { thing: one, text, fits: moved(one, dx, shiftWithin(extent.minY, extent.maxY, min[1], max[1])) };
}

/** All mistakes of a place, one for each thing. */
export function mistakesOf(all: readonly Thing[], scene: SceneFacts | null, clips: readonly PlaceClip[]): Mistake[] {
  return all
    .map((one) => (scene && outsideOf(one, scene.box, clips)) ?? mistakeOf(one, clips))
    .filter((one) => one !== null);
}

/** How deep what lies across people's way has to be. */
export function depthFor(clip: PlaceClip | undefined): number {
  return clip && clip.length > 0 ? clip.length : kUsualDepth;
}

/** As a motion does, or as what nobody goes through (-1). It is another thing then where it was the other kind. */
export function withMotion(one: Thing, motion: number, clips: readonly PlaceClip[]): Thing {
  const clip = clips[motion];
  if (clip) {
    const { name, polygon, centre, path } = one;
    const ground = one.kind === 'patch' ? one : thing('patch', { name, polygon, centre, path });
    return clip.length > 0 ? fitted({ ...ground, motion }, clip.length) : { ...ground, motion };
  }
  const { name, polygon, centre, path } = one;
  const now = clips[one.motion]?.name;
  // Only what stands across the way was deeper than it looked.
  const depth = now === 'jump' || now === 'climb' ? kThick : null;
  const height = now === 'jump' ? 1.6 : 3;
  const made = thing('obstacle', { name: name || (now === 'jump' ? 'Hedge' : ''), polygon, centre, path, height });
  if (depth === null || !polygon) return made;
  const { length, width } = frameOf(polygon);
  return resized(made, width <= length ? 'width' : 'length', depth);
}
