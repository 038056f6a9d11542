// Geometry of control marks: smooth paths and thinned checkpoints.

import type { Numbers } from '../../model/frame_view';
import type { GroundPoint } from '../../model/plane';

/** A path's points from x, y pairs, starting at the handle. */
export function pathPoints(from: GroundPoint, path: Numbers): GroundPoint[] {
  const points: GroundPoint[] = [from];
  for (let i = 0; i + 1 < path.length; i += 2) points.push({ x: path[i] ?? 0, y: path[i + 1] ?? 0 });
  return points;
}

/** A centripetal Catmull-Rom curve through the points, `pieces` per span: no loops where spans differ in length. */
export function smooth(points: readonly GroundPoint[], pieces: number): GroundPoint[] {
  const apart = points.filter((p, i) => i === 0 || knotSpan(points[i - 1] as GroundPoint, p) > 1e-4);
  if (apart.length < 3) return apart;
  const out: GroundPoint[] = [];
  const last = apart.length - 1;
  for (let i = 0; i < last; ++i) {
    const [b, c] = [apart[i], apart[i + 1]] as [GroundPoint, GroundPoint];
    // Beyond the ends the curve goes on straight.
    const a = apart[i - 1] ?? beyond(b, c);
    const d = apart[i + 2] ?? beyond(c, b);
    for (let k = 0; k < pieces; ++k) out.push(spline([a, b, c, d], k / pieces));
  }
  out.push(apart[last] as GroundPoint);
  return out;
}

function knotSpan(a: GroundPoint, b: GroundPoint): number {
  return Math.sqrt(Math.hypot(b.x - a.x, b.y - a.y));
}

function beyond(end: GroundPoint, inner: GroundPoint): GroundPoint {
  return { x: 2 * end.x - inner.x, y: 2 * end.y - inner.y };
}

/** Barry and Goldman's pyramid, from the second point (t = 0) to the third (t = 1). */
function spline([a, b, c, d]: readonly [GroundPoint, GroundPoint, GroundPoint, GroundPoint], t: number): GroundPoint {
  if (t === 0) return b;
  const t1 = knotSpan(a, b);
  const t2 = t1 + knotSpan(b, c);
  const t3 = t2 + knotSpan(c, d);
  const at = t1 + t * (t2 - t1);
  const between = (p: GroundPoint, q: GroundPoint, from: number, to: number): GroundPoint => {
    const share = (at - from) / (to - from);
    return { x: p.x + share * (q.x - p.x), y: p.y + share * (q.y - p.y) };
  };
  const [ab, bc, cd] = [between(a, b, 0, t1), between(b, c, t1, t2), between(c, d, t2, t3)];
  return between(between(ab, bc, 0, t2), between(bc, cd, t1, t3), t1, t2);
}

/**
 * Indices of points about `spacing` apart along the path, without the first and the last. Points that were shown
 * `before` stay, so that checkpoints do not jump while a path loses points at its beginning and gains some at its
 * end. Where none is left the spacing counts from the far end. /
 */
export function thinned(
  points: readonly GroundPoint[],
  spacing: number,
  before: readonly GroundPoint[] = [],
): number[] {
  const far = points.length - 1;
  const was = (p: GroundPoint): boolean => before.some(({ x, y }) => x === p.x && y === p.y);
  const anchor = points.findIndex((p, i) => i > 0 && i < far && was(p));
  const start = anchor < 0 ? far : anchor;
  const chosen = [...spaced(points, start, -1, spacing).reverse(), start, ...spaced(points, start, 1, spacing)];
  return chosen.filter((i) => i > 0 && i < far);
}

/** Indices from `start` on in one direction, each `spacing` after the last. */
function spaced(points: readonly GroundPoint[], start: number, step: 1 | -1, spacing: number): number[] {
  const chosen: number[] = [];
  let length = 0;
  for (let i = start + step; i >= 0 && i < points.length; i += step) {
    const a = points[i - step] as GroundPoint;
    const b = points[i] as GroundPoint;
    length += Math.hypot(b.x - a.x, b.y - a.y);
    if (length < spacing) continue;
    chosen.push(i);
    length = 0;
  }
  return chosen;
}
