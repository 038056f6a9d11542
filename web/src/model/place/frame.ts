// The axes of an outline: along its first side and across. A wall, a hedge, stairs and a gate are drawn along theirs.

import type { Vec2 } from '../../protocol/generated/commands';
import type { GroundPoint } from '../plane';
import type { Thing } from './things';

export interface Frame {
  /** The middle of the box in these axes. */
  readonly middle: GroundPoint;
  /** Heading of the first side [rad]. */
  readonly angle: number;
  /** Along the first side, and across [m]. */
  readonly length: number;
  readonly width: number;
}

/** Lengths and widths of cars [m]. */
const kCar = { longLeast: 2.8, longMost: 7, wideLeast: 1.3, wideMost: 2.6 };

/** True where something with such sides [m] has the size of a car. */
export function isCarSized(a: number, b: number): boolean {
  const [long, short] = [Math.max(a, b), Math.min(a, b)];
  return long >= kCar.longLeast && long <= kCar.longMost && short >= kCar.wideLeast && short <= kCar.wideMost;
}

/** How far the corners reach along a direction: from, to. */
export function reachAlong(polygon: readonly Vec2[], [ux, uy]: Vec2): readonly [number, number] {
  const all = polygon.map(([x, y]) => x * ux + y * uy);
  return [Math.min(...all), Math.max(...all)];
}

export function frameOf(polygon: readonly Vec2[]): Frame {
  const [a, b] = [polygon[0]!, polygon[1]!];
  const angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [u0, u1] = reachAlong(polygon, [c, s]);
  const [v0, v1] = reachAlong(polygon, [-s, c]);
  const [u, v] = [(u0 + u1) / 2, (v0 + v1) / 2];
  return { middle: { x: c * u - s * v, y: s * u + c * v }, angle, length: u1 - u0, width: v1 - v0 };
}

/** Stretched along a direction, about a point. */
export function stretched(one: Thing, about: GroundPoint, [ux, uy]: Vec2, factor: number): Thing {
  const map = ([x, y]: Vec2): Vec2 => {
    const grows = (factor - 1) * ((x - about.x) * ux + (y - about.y) * uy);
    return [x + grows * ux, y + grows * uy];
  };
  return { ...one, polygon: one.polygon?.map(map) ?? null, centre: map(one.centre) };
}

/** As long or as wide as wished [m], about its middle. */
export function resized(one: Thing, side: 'length' | 'width', wished: number): Thing {
  if (!one.polygon) return one;
  const { middle, angle, ...now } = frameOf(one.polygon);
  const turn = side === 'length' ? angle : angle + Math.PI / 2;
  return stretched(one, middle, [Math.cos(turn), Math.sin(turn)], wished / Math.max(1e-3, now[side]));
}
