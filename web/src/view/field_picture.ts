// One overlay as the ground shader reads it, and the scale its legend shows.

import type { Numbers, OverlayView } from './frame_types';

export interface FieldScale {
  /** Value at the far end of the ramp. */
  readonly max: number;
  /** Between two contours. */
  readonly step: number;
  /** True where values go beyond `max`. */
  readonly beyond: boolean;
}

export interface FieldPicture {
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

const kNiceSteps = [1, 2, 5];

/** A round number no smaller than `value`: 1, 2 or 5 times a power of ten. */
export function niceCeiling(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  for (const step of kNiceSteps) if (step * power >= value * 0.999999) return step * power;
  return 10 * power;
}

/** The scale of an overlay: 15 contours or fewer, the ramp's end at their multiple of five. */
export function fieldScale(values: Numbers): FieldScale {
  const finite: number[] = [];
  const stride = Math.max(1, Math.floor(values.length / 20000));
  for (let i = 0; i < values.length; i += stride) {
    const value = values[i] ?? Infinity;
    if (Number.isFinite(value) && value < 1e30) finite.push(value);
  }
  if (finite.length === 0) return { max: 1, step: 0.2, beyond: false };
  finite.sort((a, b) => a - b);
  const most = finite[finite.length - 1] ?? 1;
  // Rare extremes (the far corners) must not flatten the rest.
  const useful = finite[Math.floor(0.97 * (finite.length - 1))] ?? most;
  const step = niceCeiling(Math.max(useful, most * 0.2, 1e-9) / 20);
  const max = Math.max(5, Math.ceil(useful / step / 5) * 5) * step;
  return { max, step, beyond: most > max };
}

export function makeFieldPicture(overlay: OverlayView): FieldPicture {
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
    width, height, texels, scale,
    x: overlay.x - cell / 2, y: overlay.y - cell / 2, spanX: width * cell, spanY: height * cell,
  };
}

/** The numbers of each fifth contour, where a ray from the lowest value in direction `angle` [rad] first meets it. */
export function contourLabels(overlay: OverlayView, scale: FieldScale, angle: number): ContourLabel[] {
  const { width, height, cell, values } = overlay;
  let lowest = -1;
  for (let i = 0; i < width * height; ++i) {
    const value = values[i] ?? Infinity;
    if (Number.isFinite(value) && (lowest < 0 || value < (values[lowest] ?? Infinity))) lowest = i;
  }
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
