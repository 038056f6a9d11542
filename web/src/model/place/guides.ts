// Edges and middles that line up with those of others while something is moved.

import { extentOf, moved, type Extent, type Thing } from './things';
import type { GroundPoint } from '../plane';

/** A line through everything that lines up. */
export interface Guide {
  readonly from: GroundPoint;
  readonly to: GroundPoint;
}

export interface Aligned {
  /** The move that lines up [m]. */
  readonly dx: number;
  readonly dy: number;
  readonly guides: readonly Guide[];
}

const lines = (low: number, high: number): readonly number[] => [low, (low + high) / 2, high];

interface Match {
  /** By how much more it has to move. */
  readonly by: number;
  readonly at: number;
}

/** The least move that brings one of `own` onto one of `others`, at most `reach`; null for none. */
function match(own: readonly number[], others: readonly number[], reach: number): Match | null {
  let best: Match | null = null;
  for (const mine of own)
    for (const at of others)
      if (Math.abs(at - mine) <= (best ? Math.abs(best.by) - 1e-9 : reach)) best = { by: at - mine, at };
  return best;
}

/** Those whose low edge, middle or high edge lies at `at` on an axis. */
function onLine(extents: readonly Extent[], at: number, axis: 'x' | 'y'): readonly Extent[] {
  const of = (e: Extent): readonly number[] => (axis === 'x' ? lines(e.minX, e.maxX) : lines(e.minY, e.maxY));
  return extents.filter((one) => of(one).some((value) => Math.abs(value - at) < 1e-6));
}

/** Where a move by `dx`, `dy` lines up with others within `reach` [m]: each axis by itself; unmatched axes keep their move. */
export function aligned(
  chosen: readonly Thing[],
  others: readonly Thing[],
  dx: number,
  dy: number,
  reach: number,
): Aligned {
  const extent = extentOf(chosen.map((one) => moved(one, dx, dy)));
  const around = others.map((one) => extentOf([one])).filter((one) => one !== null);
  if (!extent || around.length === 0) return { dx, dy, guides: [] };
  const x = match(
    lines(extent.minX, extent.maxX),
    around.flatMap(({ minX, maxX }) => lines(minX, maxX)),
    reach,
  );
  const y = match(
    lines(extent.minY, extent.maxY),
    around.flatMap(({ minY, maxY }) => lines(minY, maxY)),
    reach,
  );
  const [byX, byY] = [x?.by ?? 0, y?.by ?? 0];
  const own = { minX: extent.minX + byX, maxX: extent.maxX + byX, minY: extent.minY + byY, maxY: extent.maxY + byY };
  const guides: Guide[] = [];
  if (x) {
    const all = [own, ...onLine(around, x.at, 'x')];
    guides.push({
      from: { x: x.at, y: Math.min(...all.map(({ minY }) => minY)) },
      to: { x: x.at, y: Math.max(...all.map(({ maxY }) => maxY)) },
    });
  }
  if (y) {
    const all = [own, ...onLine(around, y.at, 'y')];
    guides.push({
      from: { x: Math.min(...all.map(({ minX }) => minX)), y: y.at },
      to: { x: Math.max(...all.map(({ maxX }) => maxX)), y: y.at },
    });
  }
  return { dx: dx + byX, dy: dy + byY, guides };
}
