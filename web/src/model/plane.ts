// Plane geometry, for points on the ground [m] and on the screen [CSS px] alike.

/** CSS px from the upper left corner of the canvas. */
export interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

/** On the ground: x to the east, y to the north [m]. */
export interface GroundPoint {
  readonly x: number;
  readonly y: number;
}

export function distance(a: GroundPoint, b: GroundPoint): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** Twice the signed area of a, b, c: positive where they turn left. */
export function turn(a: GroundPoint, b: GroundPoint, c: GroundPoint): number {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

export function distanceToSegment(p: GroundPoint, a: GroundPoint, b: GroundPoint): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const length2 = dx * dx + dy * dy;
  const along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  const t = Math.min(1, Math.max(0, along));
  return Math.hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/** On an edge counts as inside; the triangle may turn either way. */
export function insideTriangle(p: GroundPoint, a: GroundPoint, b: GroundPoint, c: GroundPoint): boolean {
  const first = turn(a, b, p);
  const second = turn(b, c, p);
  const third = turn(c, a, p);
  const negative = first < 0 || second < 0 || third < 0;
  const positive = first > 0 || second > 0 || third > 0;
  return !(negative && positive);
}

/** Even-odd rule. */
export function insidePolygon(p: GroundPoint, polygon: readonly GroundPoint[]): boolean {
  let inside = false;
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    if (a.y > p.y !== b.y > p.y && p.x < ((b.x - a.x) * (p.y - a.y)) / (b.y - a.y) + a.x) inside = !inside;
  });
  return inside;
}

/** The mean of the points. */
export function middleOf(points: readonly GroundPoint[]): GroundPoint {
  const sum = points.reduce((s, p) => ({ x: s.x + p.x, y: s.y + p.y }), { x: 0, y: 0 });
  const count = Math.max(1, points.length);
  return { x: sum.x / count, y: sum.y / count };
}

/** Corners counter-clockwise (monotone chain); points on edges are left out. */
export function convexHull(points: readonly GroundPoint[]): GroundPoint[] {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  if (sorted.length < 3) return sorted;
  const chain = (list: readonly GroundPoint[]): GroundPoint[] => {
    const half: GroundPoint[] = [];
    for (const p of list) {
      while (half.length >= 2 && turn(half[half.length - 2]!, half[half.length - 1]!, p) <= 0) half.pop();
      half.push(p);
    }
    half.pop();
    return half;
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

/** Pairs x, y of a message as points. */
export function pointsOf(pairs: ArrayLike<number>): GroundPoint[] {
  const points: GroundPoint[] = [];
  for (let i = 0; i + 1 < pairs.length; i += 2) points.push({ x: pairs[i]!, y: pairs[i + 1]! });
  return points;
}

/** Of a line through these points. */
export function lengthOf(points: readonly GroundPoint[]): number {
  return points.reduce((sum, point, i) => (i === 0 ? 0 : sum + distance(points[i - 1]!, point)), 0);
}
