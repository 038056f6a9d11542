// Corners of what somebody builds: taken hold of, moved, added and removed one by one.

import { outlineOf, type Thing } from './things';
import type { Vec2 } from '../../protocol/generated/commands';
import { distance, insidePolygon, turn, type GroundPoint, type ScreenPoint } from '../plane';

/** Outlines with more corners, such as imported ones, are taken as wholes. */
const kMostCorners = 80;

/** A corner, or the middle of the edge that begins at it, where a new one would come. */
export interface Grip {
  readonly index: number;
  readonly isNew: boolean;
}

/** Whether the corners of what is chosen can be taken. */
export function hasCorners(chosen: readonly Thing[]): boolean {
  const polygon = chosen.length === 1 ? chosen[0]!.polygon : null;
  return polygon !== null && polygon.length <= kMostCorners;
}

/** Between the corners, where new ones come from. */
export function middlesOf(one: Thing): GroundPoint[] {
  const corners = outlineOf(one);
  return corners.map((corner, k) => {
    const next = corners[(k + 1) % corners.length]!;
    return { x: (corner.x + next.x) / 2, y: (corner.y + next.y) / 2 };
  });
}

/** Of two that are as near, corners are taken before middles. */
const kMiddleWeight = 1.35;
/** Inside an outline no more than this share of its shortest edge, so that small things can be moved, too. */
const kInside = 0.3;

/** What a finger at `at` takes within `px`. */
export function gripAt(
  one: Thing,
  at: ScreenPoint,
  toScreen: (point: GroundPoint) => ScreenPoint,
  px: number,
): Grip | null {
  if (!one.polygon) return null;
  const corners = outlineOf(one).map(toScreen);
  const edges = corners.map((corner, k) => distance(corner, corners[(k + 1) % corners.length]!));
  let least = insidePolygon(at, corners) ? Math.min(px, kInside * Math.min(...edges)) : px;
  let best: Grip | null = null;
  for (const isNew of [false, true])
    (isNew ? middlesOf(one).map(toScreen) : corners).forEach((point, index) => {
      const away = distance(point, at) * (isNew ? kMiddleWeight : 1);
      if (away > least) return;
      least = away;
      best = { index, isNew };
    });
  return best;
}

function reshaped(one: Thing, polygon: readonly Vec2[]): Thing {
  const sum = polygon.reduce(([x, y], p) => [x + p[0], y + p[1]] as const, [0, 0] as Vec2);
  return { ...one, polygon, centre: [sum[0] / polygon.length, sum[1] / polygon.length] };
}

/** The thing with that corner, or a new one, at a point. */
export function withCorner(one: Thing, { index, isNew }: Grip, { x, y }: GroundPoint): Thing {
  const polygon = [...(one.polygon ?? [])];
  if (isNew) polygon.splice(index + 1, 0, [x, y]);
  else polygon[index] = [x, y];
  return reshaped(one, polygon);
}

/** The thing without that corner; null where fewer than three would stay. */
export function withoutCorner(one: Thing, index: number): Thing | null {
  const polygon = (one.polygon ?? []).filter((_, k) => k !== index);
  return polygon.length < 3 ? null : reshaped(one, polygon);
}

function segmentsCross(a: GroundPoint, b: GroundPoint, c: GroundPoint, d: GroundPoint): boolean {
  return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

/** True where two edges that do not follow each other meet. */
export function crossesItself(one: Thing): boolean {
  const corners = outlineOf(one);
  const count = corners.length;
  for (let i = 0; i < count; ++i)
    for (let j = i + 2; j < count; ++j) {
      if (i === 0 && j === count - 1) continue;
      if (segmentsCross(corners[i]!, corners[i + 1]!, corners[j]!, corners[(j + 1) % count]!)) return true;
    }
  return false;
}
