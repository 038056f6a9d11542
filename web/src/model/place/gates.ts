// Gates: obstacles that slide aside along their length, and back. A gate's path ends with the world, so that it stays one.

import type { Vec2 } from '../../protocol/generated/commands';
import { isGatePath, kGateEnd } from '../../protocol/scene';
import { frameOf } from './frame';
import type { Thing } from './things';

/** How fast a gate slides [m/s]. */
const kPace = 1.5;
/** A gate begins shut [s]. */
const kSoon = 0.1;
const kShut: Vec2 = [0, 0];

/** When it opens and shuts again; kNever for never [s]. */
export interface GateTimes {
  readonly opens: number;
  readonly shuts: number;
}
export const kNever = Infinity;

/** The gate's times; null for what is no gate. */
export function gateOf({ kind, path, polygon }: Pick<Thing, 'kind' | 'path' | 'polygon'>): GateTimes | null {
  if (kind !== 'obstacle' || !polygon || !isGatePath(path)) return null;
  const points = path!.waypoints.slice(0, -1);
  const isOpen = points.map(({ position: [x, y] }) => x !== 0 || y !== 0);
  const [first, last] = [isOpen.indexOf(true), isOpen.lastIndexOf(true)];
  if (first < 1) return { opens: kNever, shuts: kNever };
  return { opens: points[first - 1]!.time, shuts: last === points.length - 1 ? kNever : points[last]!.time };
}

/** The gate with other times: it has slid aside by its length while it is open. */
export function gated(one: Thing, { opens, shuts }: GateTimes): Thing {
  const { angle, length } = frameOf(one.polygon!);
  const aside: Vec2 = [length * Math.cos(angle), length * Math.sin(angle)];
  const slides = Math.max(0.1, length / kPace);
  const waypoints = [{ time: 0, position: kShut, angle: 0 }];
  const slide = (time: number, to: Vec2): void => {
    const { position } = waypoints[waypoints.length - 1]!;
    waypoints.push({ time, position, angle: 0 }, { time: time + slides, position: to, angle: 0 });
  };
  if (opens < kGateEnd) slide(opens, aside);
  if (opens < kGateEnd && shuts < kGateEnd) slide(Math.max(shuts, opens + slides + 0.1), kShut);
  // What moves no more becomes ground: a gate has something left to do.
  slide(kGateEnd - slides, opens < kGateEnd && shuts >= kGateEnd ? kShut : aside);
  waypoints[waypoints.length - 1]!.time = kGateEnd;
  return { ...one, path: { waypoints, loop: false } };
}

/** After its sides have changed. */
export function gatedAgain(one: Thing): Thing {
  const times = gateOf(one);
  return times ? gated(one, times) : one;
}

/** True while it is open or slides open. */
export function isOpenAt({ opens, shuts }: GateTimes, time: number): boolean {
  return time >= opens && time < shuts;
}

/** Its times where somebody presses it at that time: it opens, or shuts. */
export function pressedAt(times: GateTimes, time: number): GateTimes {
  const soon = Math.max(kSoon, time);
  return isOpenAt(times, time) ? { opens: times.opens, shuts: soon } : { opens: soon, shuts: kNever };
}
