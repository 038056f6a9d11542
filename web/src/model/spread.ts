// Places for a given number of people spread evenly over the dark part of a picture.

import type { GroundPoint } from './plane';

/** A picture of cells, row by row from the top: above 0 where people may stand. */
export interface Mask {
  readonly width: number;
  readonly height: number;
  readonly cells: ArrayLike<number>;
}

/** More candidates than this are thinned out first. */
const kCandidates = 60000;

/**
 * Each next place is the one farthest from all before (so the same picture and count always give the same places).
 * In cells, about the middle of the picture, y up; empty where nothing is dark. `gap`: the least distance of two.
 */
export function spreadOver(mask: Mask, count: number): { readonly places: GroundPoint[]; readonly gap: number } {
  const spots = darkSpots(mask, count);
  const n = spots.length / 2;
  const places: GroundPoint[] = [];
  if (n === 0 || count <= 0) return { places, gap: 0 };
  const away = new Float64Array(n).fill(Infinity);
  let next = 0;
  let gap = Infinity;
  while (places.length < Math.min(count, n)) {
    const [x, y] = [spots[2 * next]!, spots[2 * next + 1]!];
    if (places.length > 0) gap = Math.min(gap, away[next]!);
    places.push({ x, y });
    let [farthest, most] = [0, -1];
    for (let i = 0; i < n; ++i) {
      const [dx, dy] = [spots[2 * i]! - x, spots[2 * i + 1]! - y];
      const square = dx * dx + dy * dy;
      if (square < away[i]!) away[i] = square;
      if (away[i]! > most) [farthest, most] = [i, away[i]!];
    }
    next = farthest;
  }
  return { places, gap: places.length > 1 ? Math.sqrt(gap) : 1 };
}

/** x, y of dark cells about the picture's middle. */
function darkSpots({ width, height, cells }: Mask, count: number): Float64Array {
  let dark = 0;
  for (let i = 0; i < width * height; ++i) if ((cells[i] ?? 0) > 0) dark += 1;
  // Few enough to be quick, enough to choose from.
  const most = Math.max(6 * count, Math.min(kCandidates, Math.floor(2e7 / Math.max(1, count))));
  const stride = Math.max(1, Math.floor(Math.sqrt(dark / most)));
  const spots: number[] = [];
  for (let row = 0; row < height; row += stride)
    for (let column = 0; column < width; column += stride)
      if ((cells[row * width + column] ?? 0) > 0) spots.push(column - (width - 1) / 2, (height - 1) / 2 - row);
  return Float64Array.from(spots);
}
