// A formation of a visitor's own, changed before it is taken up. Places lie in a group's own axes, which face x.

import { type GroundPoint } from './plane';
import { spreadOver } from './spread';

export interface OwnShape {
  /** Between neighbours [m]. */
  readonly spacing: number;
  /** About the middle [m]. */
  readonly places: readonly GroundPoint[];
}

/** Neighbours stand between so near and so far from each other [m]. */
export const kSpacings = { least: 0.5, most: 5 };
/** Cells of a spacing, where places are spread afresh. */
const kCells = 5;
/** Places take up a disc of this radius then, in spacings. */
const kDisc = 0.6;

/** The two sides of an axis change; its direction from x [rad]. */
export function mirrored({ spacing, places }: OwnShape, axis = 0): OwnShape {
  const [c, s] = [Math.cos(2 * axis), Math.sin(2 * axis)];
  return { spacing, places: places.map(({ x, y }) => ({ x: c * x + s * y, y: s * x - c * y })) };
}

/** Turned to the left [rad]. */
export function turned({ spacing, places }: OwnShape, angle: number): OwnShape {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { spacing, places: places.map(({ x, y }) => ({ x: c * x - s * y, y: s * x + c * y })) };
}

/** With neighbours so many times as far apart, within limits. */
export function loosened({ spacing, places }: OwnShape, factor: number): OwnShape {
  const wanted = Math.min(kSpacings.most, Math.max(kSpacings.least, spacing * factor));
  const scale = wanted / spacing;
  return { spacing: wanted, places: places.map(({ x, y }) => ({ x: scale * x, y: scale * y })) };
}

/** The same shape for more or fewer people, who stand as far apart. */
export function forCount(shape: OwnShape, count: number): OwnShape {
  const { spacing, places } = shape;
  if (places.length === count || places.length === 0 || count < 1) return shape;
  const cell = spacing / kCells;
  const reach = kDisc * kCells;
  const xs = places.map(({ x }) => x / cell);
  const ys = places.map(({ y }) => y / cell);
  const [left, top] = [Math.min(...xs) - reach, Math.max(...ys) + reach];
  const width = Math.ceil(Math.max(...xs) + reach - left) + 1;
  const height = Math.ceil(top - Math.min(...ys) + reach) + 1;
  const cells = new Uint8Array(width * height);
  places.forEach((_, i) => {
    const [column, row] = [xs[i]! - left, top - ys[i]!];
    for (let r = Math.ceil(row - reach); r <= row + reach; ++r)
      for (let c = Math.ceil(column - reach); c <= column + reach; ++c)
        if ((r - row) ** 2 + (c - column) ** 2 <= reach * reach) cells[r * width + c] = 1;
  });
  const spread = spreadOver({ width, height, cells }, count);
  if (spread.places.length < count) return shape;
  const scale = spacing / spread.gap;
  return { spacing, places: spread.places.map(({ x, y }) => ({ x: scale * x, y: scale * y })) };
}
