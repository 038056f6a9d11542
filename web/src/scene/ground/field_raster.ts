// One overlay as the ground shader reads it, and the scale its legend shows.

import { fieldScale, type FieldScale } from '../../model/field_scale';
import type { OverlayView } from '../../model/frame_view';

export interface FieldRaster {
  readonly width: number;
  readonly height: number;
  /** Value over max, and 1 where reached, per cell from the lower left. */
  readonly texels: Float32Array<ArrayBuffer>;
  /** Lower left corner and extent of the ground it covers [m]. */
  readonly x: number;
  readonly y: number;
  readonly spanX: number;
  readonly spanY: number;
  readonly scale: FieldScale;
}

/** A contour's number and where it stands [m]. */
export interface ContourLabel {
  readonly text: string;
  readonly x: number;
  readonly y: number;
}

export function makeFieldRaster(overlay: OverlayView): FieldRaster {
  const { width, height, cell, values } = overlay;
  const scale = fieldScale(values);
  const texels = new Float32Array(2 * width * height);
  for (let i = 0; i < width * height; ++i) {
    const value = values[i] ?? Infinity;
    const reached = Number.isFinite(value) && value < 1e30;
    texels[2 * i] = reached ? Math.min(1, Math.max(0, value / scale.max)) : 0;
    texels[2 * i + 1] = reached ? 1 : 0;
  }
  return {
    width,
    height,
    texels,
    scale,
    x: overlay.x - cell / 2,
    y: overlay.y - cell / 2,
    spanX: width * cell,
    spanY: height * cell,
  };
}

/** Index of the cell of the lowest value; -1 where none is reached. */
function lowestCell({ width, height, values }: OverlayView): number {
  let lowest = -1;
  for (let i = 0; i < width * height; ++i) {
    const value = values[i] ?? Infinity;
    if (Number.isFinite(value) && (lowest < 0 || value < (values[lowest] ?? Infinity))) lowest = i;
  }
  return lowest;
}

/** The numbers of each fifth contour, where a ray from the lowest value in direction `angle` [rad] first meets it. */
export function contourLabels(overlay: OverlayView, scale: FieldScale, angle: number): ContourLabel[] {
  const { width, height, cell, values } = overlay;
  const lowest = lowestCell(overlay);
  if (lowest < 0) return [];
  const labels: ContourLabel[] = [];
  const startX = lowest % width;
  const startY = Math.floor(lowest / width);
  let level = 5 * scale.step;
  for (let t = 0; t < width + height && level < scale.max * 1.0001; t += 0.5) {
    const i = Math.round(startX + t * Math.cos(angle));
    const j = Math.round(startY + t * Math.sin(angle));
    if (i < 0 || j < 0 || i >= width || j >= height) break;
    const value = values[j * width + i] ?? Infinity;
    if (!Number.isFinite(value)) continue;
    if (value >= level) {
      labels.push({ text: String(Number(level.toPrecision(3))), x: overlay.x + i * cell, y: overlay.y + j * cell });
      level += 5 * scale.step;
    }
  }
  return labels;
}
