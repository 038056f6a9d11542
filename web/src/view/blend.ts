// Mixing numbers of two frames.

import type { Numbers } from './frame_types';

export function mix(a: number, b: number, alpha: number): number {
  return a + (b - a) * alpha;
}

/** From one angle to another the short way round [rad]. */
export function mixAngle(a: number, b: number, alpha: number): number {
  let turn = b - a;
  turn -= 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  return a + turn * alpha;
}

/** Mixes two lists into `out` (grown as needed); lists of different lengths cannot be mixed and the second holds. */
export function mixNumbers(from: Numbers, to: Numbers, alpha: number, out: Float32Array): Float32Array {
  const count = to.length;
  const target = out.length === count ? out : new Float32Array(count);
  const still = from.length !== count || from === to;
  for (let i = 0; i < count; ++i) {
    const b = to[i] ?? 0;
    target[i] = still ? b : mix(from[i] ?? b, b, alpha);
  }
  return target;
}
