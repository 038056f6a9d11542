// Rings of corners from files: mended until a scenario takes them, or the reason why not.

import { areaOf } from '../outline';
import { distanceToSegment, type GroundPoint, turn } from '../plane';
import { toMillimetre } from './place';

export type Ring = readonly GroundPoint[];
export type RingProblem = 'numbers' | 'flat' | 'crosses';

/** Corners nearer to each other are one [m]. */
const kSame = 2e-3;
/** Corners that stand out less from the line of their neighbours are left out [m]. */
const kFlat = 1e-3;
/** Less ground than this is none [m^2]. */
const kLeastArea = 0.01;
/** Edges must be so far from each other [m]. */
const kApart = 1e-5;
/** A ring that crosses itself is tried with so much of its detail left out [m]. */
const kCoarser: readonly number[] = [0.05, 0.2];

const near = (a: GroundPoint, b: GroundPoint): boolean => Math.hypot(a.x - b.x, a.y - b.y) < kSame;

/** Without repeated corners, spikes and corners on a straight line. */
function cleaned(ring: Ring): GroundPoint[] {
  let corners = ring.map(({ x, y }) => ({ x: toMillimetre(x), y: toMillimetre(y) }));
  for (let before = -1; before !== corners.length && corners.length >= 3;) {
    before = corners.length;
    corners = corners.filter((p, i) => !near(p, corners[(i + 1) % corners.length]!));
    // One after the other: a corner is judged by the neighbours that are left.
    for (let i = 0; i < corners.length && corners.length >= 3; ++i) {
      const a = corners[(i + corners.length - 1) % corners.length]!;
      const [b, c] = [corners[i]!, corners[(i + 1) % corners.length]!];
      const long = Math.hypot(c.x - a.x, c.y - a.y);
      const away = Math.min(distanceToSegment(b, a, c), long < kSame ? 0 : Math.abs(turn(a, b, c)) / long);
      if (away < kFlat) corners.splice(i--, 1);
    }
  }
  return corners;
}

function meet(a: GroundPoint, b: GroundPoint, c: GroundPoint, d: GroundPoint): boolean {
  const across = turn(a, b, c) > 0 !== turn(a, b, d) > 0 && turn(c, d, a) > 0 !== turn(c, d, b) > 0;
  if (across) return true;
  const ends = [
    [a, c, d],
    [b, c, d],
    [c, a, b],
    [d, a, b],
  ] as const;
  return ends.some(([p, q, r]) => distanceToSegment(p, q, r) < kApart);
}

/** True where no two edges cross or touch but at the corner that they share. */
export function isSimple(ring: Ring): boolean {
  const n = ring.length;
  const edges = ring.map((a, i) => {
    const b = ring[(i + 1) % n]!;
    return { i, a, b, left: Math.min(a.x, b.x), right: Math.max(a.x, b.x) };
  });
  edges.sort((p, q) => p.left - q.left);
  for (let k = 0; k < n; ++k) {
    const p = edges[k]!;
    for (let m = k + 1; m < n && edges[m]!.left <= p.right + kApart; ++m) {
      const q = edges[m]!;
      const apart = Math.abs(p.i - q.i);
      if (apart === 1 || apart === n - 1) continue;
      if (meet(p.a, p.b, q.a, q.b)) return false;
    }
  }
  return true;
}

/** A ring that comes back to a corner is two rings. */
function dividedAtCorners(ring: Ring): Ring[] {
  const seen = new Map<string, number>();
  for (let i = 0; i < ring.length; ++i) {
    const key = `${ring[i]!.x} ${ring[i]!.y}`;
    const first = seen.get(key);
    if (first !== undefined)
      return [
        ...dividedAtCorners(ring.slice(first, i)),
        ...dividedAtCorners([...ring.slice(0, first), ...ring.slice(i)]),
      ];
    seen.set(key, i);
  }
  return [ring];
}

/** Leaves out corners that bend little (Douglas and Peucker), of an open line. */
export function simplifiedLine(points: Ring, tolerance: number): GroundPoint[] {
  const keep = new Uint8Array(points.length).fill(0);
  keep[0] = keep[points.length - 1] = 1;
  const spans: [number, number][] = [[0, points.length - 1]];
  for (let span = spans.pop(); span; span = spans.pop()) {
    const [from, to] = span;
    let [farthest, most] = [-1, tolerance];
    for (let i = from + 1; i < to; ++i) {
      const away = distanceToSegment(points[i]!, points[from]!, points[to]!);
      if (away > most) [farthest, most] = [i, away];
    }
    if (farthest < 0) continue;
    keep[farthest] = 1;
    spans.push([from, farthest], [farthest, to]);
  }
  return points.filter((_, i) => keep[i] === 1);
}

/** The same of a ring: the corner farthest from the first divides it in two lines. */
export function simplifiedRing(ring: Ring, tolerance: number): GroundPoint[] {
  if (ring.length < 4) return [...ring];
  const first = ring[0]!;
  let far = 0;
  const away = (p: GroundPoint): number => Math.hypot(p.x - first.x, p.y - first.y);
  ring.forEach((p, i) => {
    if (away(p) > away(ring[far]!)) far = i;
  });
  const there = simplifiedLine(ring.slice(0, far + 1), tolerance);
  const back = simplifiedLine([...ring.slice(far), first], tolerance);
  return [...there.slice(0, -1), ...back.slice(0, -1)];
}

/** The rings that a scenario takes, counter-clockwise; mostly one, more where it comes back to a corner. */
export function mendedRing(ring: Ring): readonly Ring[] | RingProblem {
  if (!ring.every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y))) return 'numbers';
  for (const tolerance of [0, ...kCoarser]) {
    const coarse = tolerance > 0 ? simplifiedRing(cleaned(ring), tolerance) : ring;
    const parts = dividedAtCorners(cleaned(coarse)).map((part) => cleaned(part));
    if (!parts.every(isSimple)) continue;
    const broad = parts.filter((part) => part.length >= 3 && Math.abs(areaOf(part)) >= kLeastArea);
    return broad.length > 0 ? broad.map((part) => (areaOf(part) > 0 ? part : [...part].reverse())) : 'flat';
  }
  return 'crosses';
}
