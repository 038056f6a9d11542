// From a drawn loop to the outline of a formation.

import { distanceToSegment, type GroundPoint } from './plane';

/** Corners of an outline, at most. */
const kMostCorners = 80;
/** A loop smaller than this is no shape [m^2]. */
const kLeastArea = 2;
/** Corners nearer to the line of their neighbours than this share of the loop's size are left out. */
const kFlat = 0.008;

export type Outline = { readonly corners: readonly GroundPoint[] } | { readonly why: string };

/** Signed area; positive where counter-clockwise. */
export function areaOf(points: readonly GroundPoint[]): number {
  let sum = 0;
  points.forEach((a, i) => {
    const b = points[(i + 1) % points.length]!;
    sum += a.x * b.y - b.x * a.y;
  });
  return sum / 2;
}

/** Centre of area. */
export function centreOf(points: readonly GroundPoint[]): GroundPoint {
  const area = areaOf(points);
  let [x, y] = [0, 0];
  points.forEach((a, i) => {
    const b = points[(i + 1) % points.length]!;
    const cross = a.x * b.y - b.x * a.y;
    x += (a.x + b.x) * cross;
    y += (a.y + b.y) * cross;
  });
  return { x: x / (6 * area), y: y / (6 * area) };
}

/** Where two segments cross, as a share of the first; null where they do not. */
function crossing(a: GroundPoint, b: GroundPoint, c: GroundPoint, d: GroundPoint): number | null {
  const [rx, ry, sx, sy] = [b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y];
  const cross = rx * sy - ry * sx;
  if (Math.abs(cross) < 1e-12) return null;
  const t = ((c.x - a.x) * sy - (c.y - a.y) * sx) / cross;
  const u = ((c.x - a.x) * ry - (c.y - a.y) * rx) / cross;
  return t >= 0 && t <= 1 && u >= 0 && u <= 1 ? t : null;
}

/** The stroke without the ends that hang over where it crosses itself; the widest such crossing counts. */
function withoutTails(stroke: readonly GroundPoint[]): readonly GroundPoint[] {
  for (let span = stroke.length - 2; span > stroke.length / 2; --span) {
    for (let i = 0; i + span + 1 < stroke.length; ++i) {
      const [a, b] = [stroke[i]!, stroke[i + 1]!];
      const t = crossing(a, b, stroke[i + span]!, stroke[i + span + 1]!);
      if (t === null) continue;
      return [{ x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y) }, ...stroke.slice(i + 1, i + span + 1)];
    }
  }
  return stroke;
}

function crossesItself(loop: readonly GroundPoint[]): boolean {
  const n = loop.length;
  for (let i = 0; i < n; ++i)
    for (let j = i + 2; j < n; ++j) {
      if (i === 0 && j === n - 1) continue;
      if (crossing(loop[i]!, loop[i + 1]!, loop[j]!, loop[(j + 1) % n]!) !== null) return true;
    }
  return false;
}

/** Leaves out corners that bend little (Douglas and Peucker). */
function simplified(points: readonly GroundPoint[], tolerance: number): GroundPoint[] {
  if (points.length < 3) return [...points];
  const [first, last] = [points[0]!, points[points.length - 1]!];
  let [farthest, most] = [0, 0];
  for (let i = 1; i + 1 < points.length; ++i) {
    const away = distanceToSegment(points[i]!, first, last);
    if (away > most) [farthest, most] = [i, away];
  }
  if (most <= tolerance) return [first, last];
  const before = simplified(points.slice(0, farthest + 1), tolerance);
  return [...before.slice(0, -1), ...simplified(points.slice(farthest), tolerance)];
}

/** The outline that a stroke draws, counter-clockwise, or why it is none. */
export function outlineFrom(stroke: readonly GroundPoint[]): Outline {
  const loop = withoutTails(stroke);
  if (loop.length < 3 || Math.abs(areaOf(loop)) < kLeastArea) {
    return { why: 'That outline is too small: draw round at least two square metres.' };
  }
  const xs = loop.map(({ x }) => x);
  const ys = loop.map(({ y }) => y);
  const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  let corners: GroundPoint[] = [];
  for (let tolerance = kFlat * size; ; tolerance *= 1.5) {
    // Closed: the corner farthest from the first divides it in two.
    const far = loop.reduce((best, p, i) => {
      const away = (q: GroundPoint): number => Math.hypot(q.x - loop[0]!.x, q.y - loop[0]!.y);
      return away(p) > away(loop[best]!) ? i : best;
    }, 0);
    const there = simplified(loop.slice(0, far + 1), tolerance);
    const back = simplified([...loop.slice(far), loop[0]!], tolerance);
    corners = [...there.slice(0, -1), ...back.slice(0, -1)];
    if (corners.length <= kMostCorners) break;
  }
  if (corners.length < 3) return { why: 'That is a line, not an outline: draw a closed shape.' };
  if (crossesItself(corners)) return { why: 'That outline crosses itself: draw it in one go, without a loop.' };
  return { corners: areaOf(corners) > 0 ? corners : corners.reverse() };
}
