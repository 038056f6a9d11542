// Lines as walls of a width.

import { mendedRing, simplifiedLine, type Ring } from './rings';
import type { GroundPoint } from '../plane';

/** Detail of lines that is left out [m]. */
const kDetail = 0.03;
/** Mitres reach so many half widths at most. */
const kMitre = 2;

const isSame = (a: GroundPoint, b: GroundPoint): boolean => Math.hypot(a.x - b.x, a.y - b.y) < 2e-3;

function leftOf(a: GroundPoint, b: GroundPoint): GroundPoint {
  const long = Math.hypot(b.x - a.x, b.y - a.y);
  return { x: (a.y - b.y) / long, y: (b.x - a.x) / long };
}

/** One side of a line, `away` to the left of it. */
function offset(line: Ring, away: number): GroundPoint[] {
  return line.map((p, i) => {
    const before = i > 0 ? leftOf(line[i - 1]!, p) : leftOf(p, line[1]!);
    const after = i + 1 < line.length ? leftOf(p, line[i + 1]!) : before;
    const [x, y] = [before.x + after.x, before.y + after.y];
    const square = Math.max(x * x + y * y, 2 / kMitre ** 2);
    return { x: p.x + (2 * away * x) / square, y: p.y + (2 * away * y) / square };
  });
}

function box(a: GroundPoint, b: GroundPoint, half: number): Ring {
  const { x, y } = leftOf(a, b);
  // Longer by half the width at both ends, so that corners are closed.
  const along = { x: half * y, y: -half * x };
  return [
    { x: a.x - along.x - half * x, y: a.y - along.y - half * y },
    { x: b.x + along.x - half * x, y: b.y + along.y - half * y },
    { x: b.x + along.x + half * x, y: b.y + along.y + half * y },
    { x: a.x - along.x + half * x, y: a.y - along.y + half * y },
  ];
}

/** Outlines of a wall along a line; a closed line becomes two walls that meet. Empty where it has no length. */
export function wallsAlong(line: Ring, width: number): Ring[] {
  const straight = simplifiedLine(
    line.filter((p, i) => i === 0 || !isSame(p, line[i - 1]!)),
    kDetail,
  );
  const n = straight.length;
  if (n < 2) return [];
  if (n > 3 && isSame(straight[0]!, straight[n - 1]!)) {
    const half = n >> 1;
    return [...wallsAlong(straight.slice(0, half + 1), width), ...wallsAlong(straight.slice(half), width)];
  }
  const whole = mendedRing([...offset(straight, -width / 2), ...offset(straight, width / 2).reverse()]);
  if (typeof whole !== 'string' && whole.length === 1) return [...whole];
  return straight.slice(1).flatMap((p, i) => {
    const part = mendedRing(box(straight[i]!, p, width / 2));
    return typeof part === 'string' ? [] : [...part];
  });
}
