// Doors: openings that are put into walls.

import type { Vec2 } from '../../protocol/generated/commands';
import { turn, type GroundPoint } from '../plane';
import { reachAlong } from './frame';
import { middle as middleOf, type Thing } from './things';

/** Shorter pieces are left out [m]. */
const kLeast = 0.05;

/** The part of a convex outline on which `worth` is 0 or more. */
function clipped(polygon: readonly Vec2[], worth: (p: Vec2) => number): Vec2[] {
  return polygon.flatMap((a, k) => {
    const b = polygon[(k + 1) % polygon.length]!;
    const [u, v] = [worth(a), worth(b)];
    const kept: Vec2[] = u >= 0 ? [a] : [];
    if (u >= 0 === v >= 0) return kept;
    const share = u / (u - v);
    return [...kept, [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])] as const];
  });
}

function isConvex(polygon: readonly Vec2[]): boolean {
  const points = polygon.map(([x, y]) => ({ x, y }));
  const turns = points.map((p, k) => turn(p, points[(k + 1) % points.length]!, points[(k + 2) % points.length]!));
  return turns.every((one) => one >= -1e-9) || turns.every((one) => one <= 1e-9);
}

/** The direction of the longest side. */
function along(polygon: readonly Vec2[]): Vec2 {
  const sides = polygon.map(([x, y], k): Vec2 => {
    const [x1, y1] = polygon[(k + 1) % polygon.length]!;
    return [x1 - x, y1 - y];
  });
  const [x, y] = sides.reduce((best, one) => (Math.hypot(...one) > Math.hypot(...best) ? one : best));
  return [x / Math.hypot(x, y), y / Math.hypot(x, y)];
}

/** The wall with an opening of that width [m] there, in two pieces or one; else why it has none. */
export function withDoor(wall: Thing, at: GroundPoint, width: number): readonly Thing[] | string {
  const { polygon } = wall;
  if (!polygon || wall.path || !isConvex(polygon)) return 'A door needs a wall that is straight and stands still.';
  const [ux, uy] = along(polygon);
  const [from, to] = reachAlong(polygon, [ux, uy]);
  if (to - from < width + kLeast) return `The wall is ${(to - from).toFixed(1)} m long: too short for this door.`;
  const middle = Math.min(to - width / 2, Math.max(from + width / 2, at.x * ux + at.y * uy));
  const place = ([x, y]: Vec2): number => x * ux + y * uy - middle;
  const pieces = [clipped(polygon, (p) => -place(p) - width / 2), clipped(polygon, (p) => place(p) - width / 2)];
  return pieces
    .filter((piece) => piece.length > 2 && reachAlong(piece, [ux, uy]).reduce((a, b) => b - a) >= kLeast)
    .map((piece, k) => ({ ...wall, id: k === 0 ? wall.id : 0, polygon: piece, centre: middleOf(piece) }));
}
