// Interpolation between the numbers of two frames.

export function mix(a: number, b: number, alpha: number): number {
  return a + (b - a) * alpha;
}

/** Interpolates angles along the shorter arc [rad]. */
export function mixAngle(a: number, b: number, alpha: number): number {
  let turn = b - a;
  turn -= 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  return a + turn * alpha;
}
