// Which part of a picture people stand on: what is dark.

import type { Mask } from './spread';

/** Of 255: darker is inside. */
const kDark = 128;
/** Of 255: what shines through more is outside. */
const kSolid = 128;

/** Pixels as red, green, blue, opacity, row by row. */
export function maskOfPixels(data: ArrayLike<number>, width: number, height: number): Mask {
  const cells = new Uint8Array(width * height);
  for (let i = 0; i < cells.length; ++i) {
    const [red, green, blue, solid] = [data[4 * i]!, data[4 * i + 1]!, data[4 * i + 2]!, data[4 * i + 3]!];
    // Weights of brightness after ITU-R BT.601.
    const bright = 0.299 * red + 0.587 * green + 0.114 * blue;
    cells[i] = solid >= kSolid && bright < kDark ? 1 : 0;
  }
  return { width, height, cells };
}

/** The size at which a picture is read: as large, but at most so many pixels on a side. */
export function readSize(width: number, height: number, most: number): { width: number; height: number } {
  const scale = Math.min(1, most / Math.max(width, height, 1));
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}
