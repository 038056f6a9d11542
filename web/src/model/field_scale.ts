// The scale of an overlay's colours and contours.

import type { Numbers } from './frame_view';

export interface FieldScale {
  /** Value at the far end of the ramp. */
  readonly max: number;
  /** Between two contours. */
  readonly step: number;
  /** True where values go beyond `max`. */
  readonly beyond: boolean;
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
