// Geometry of control marks: smooth paths, thinned checkpoints, hulls in a steady order.

import type { GroundPoint } from './camera_types';
import type { Numbers } from './frame_types';

/** A path's points from x, y pairs, starting at the handle. */
export function pathPoints(from: GroundPoint, path: Numbers): GroundPoint[] {
  const points: GroundPoint[] = [from];
  for (let i = 0; i + 1 < path.length; i += 2) points.push({ x: path[i] ?? 0, y: path[i + 1] ?? 0 });
  return points;
}

/** A Catmull-Rom curve through the points, `pieces` per span. */
export function smooth(points: readonly GroundPoint[], pieces: number): GroundPoint[] {
  if (points.length < 3) return [...points];
  const out: GroundPoint[] = [];
  const at = (i: number): GroundPoint => points[Math.min(points.length - 1, Math.max(0, i))] as GroundPoint;
  for (let i = 0; i + 1 < points.length; ++i) {
    const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    for (let k = 0; k < pieces; ++k) out.push(spline(a, b, c, d, k / pieces));
  }
  out.push(at(points.length - 1));
  return out;
}

function spline(a: GroundPoint, b: GroundPoint, c: GroundPoint, d: GroundPoint, t: number): GroundPoint {
  const one = (p: number, q: number, r: number, s: number): number =>
    0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t * t * t);
  return { x: one(a.x, b.x, c.x, d.x), y: one(a.y, b.y, c.y, d.y) };
}

/** Indices of points at least `spacing` apart along the way, without the first and the last. */
export function thinned(points: readonly GroundPoint[], spacing: number): number[] {
  const kept: number[] = [];
  let way = 0;
  let left = spacing;
  for (let i = 1; i + 1 < points.length; ++i) {
    const a = points[i - 1] as GroundPoint;
    const b = points[i] as GroundPoint;
    way += Math.hypot(b.x - a.x, b.y - a.y);
    if (way < left) continue;
    kept.push(i);
    left = way + spacing;
  }
  return kept;
}

/** Indices in order of angle round their middle, so that an area's outline does not cross itself. */
export function roundOrder(points: readonly GroundPoint[]): number[] {
  const x = points.reduce((sum, p) => sum + p.x, 0) / Math.max(1, points.length);
  const y = points.reduce((sum, p) => sum + p.y, 0) / Math.max(1, points.length);
  const angle = (i: number): number => {
    const p = points[i] as GroundPoint;
    return Math.atan2(p.y - y, p.x - x);
  };
  return points.map((_, i) => i).sort((a, b) => angle(a) - angle(b) || a - b);
}
