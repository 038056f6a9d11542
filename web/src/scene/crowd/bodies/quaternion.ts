// Quaternions as x, y, z, w in flat arrays. They are used a hundred thousand times a second, so no objects are made.

export type Floats = Float32Array | number[];

/** out = a * b: first b, then a. `out` may be either. */
export function multiply(out: Floats, o: number, a: Floats, i: number, b: Floats, j: number): void {
  const ax = a[i]!,
    ay = a[i + 1]!,
    az = a[i + 2]!,
    aw = a[i + 3]!;
  const bx = b[j]!,
    by = b[j + 1]!,
    bz = b[j + 2]!,
    bw = b[j + 3]!;
  out[o] = aw * bx + ax * bw + ay * bz - az * by;
  out[o + 1] = aw * by + ay * bw + az * bx - ax * bz;
  out[o + 2] = aw * bz + az * bw + ax * by - ay * bx;
  out[o + 3] = aw * bw - ax * bx - ay * by - az * bz;
}

/** out = the inverse of a unit rotation. */
export function conjugate(out: Floats, o: number, a: Floats, i: number): void {
  out[o] = -a[i]!;
  out[o + 1] = -a[i + 1]!;
  out[o + 2] = -a[i + 2]!;
  out[o + 3] = a[i + 3]!;
}

/** Adds the vector (x, y, z), turned by a[i...], to out[o...]. */
export function addTurned(out: Floats, o: number, a: Floats, i: number, x: number, y: number, z: number): void {
  const qx = a[i]!,
    qy = a[i + 1]!,
    qz = a[i + 2]!,
    qw = a[i + 3]!;
  const tx = 2 * (qy * z - qz * y),
    ty = 2 * (qz * x - qx * z),
    tz = 2 * (qx * y - qy * x);
  out[o] = out[o]! + x + qw * tx + qy * tz - qz * ty;
  out[o + 1] = out[o + 1]! + y + qw * ty + qz * tx - qx * tz;
  out[o + 2] = out[o + 2]! + z + qw * tz + qx * ty - qy * tx;
}

/** Normalised linear interpolation between two rotations along the shorter arc. */
export function nlerp(out: Floats, o: number, a: Floats, i: number, b: Floats, j: number, t: number): void {
  const ax = a[i]!,
    ay = a[i + 1]!,
    az = a[i + 2]!,
    aw = a[i + 3]!;
  const bx = b[j]!,
    by = b[j + 1]!,
    bz = b[j + 2]!,
    bw = b[j + 3]!;
  const s = ax * bx + ay * by + az * bz + aw * bw < 0 ? -t : t;
  const x = ax * (1 - t) + bx * s,
    y = ay * (1 - t) + by * s,
    z = az * (1 - t) + bz * s,
    w = aw * (1 - t) + bw * s;
  const size = 1 / Math.sqrt(x * x + y * y + z * z + w * w || 1);
  out[o] = x * size;
  out[o + 1] = y * size;
  out[o + 2] = z * size;
  out[o + 3] = w * size;
}

export type Vector = readonly [number, number, number];

/** The shortest rotation from direction a to direction b; the identity where either is zero. */
export function shortestArc(a: Vector, b: Vector): [number, number, number, number] {
  const la = Math.hypot(...a),
    lb = Math.hypot(...b);
  if (la < 1e-9 || lb < 1e-9) return [0, 0, 0, 1];
  const dot = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (la * lb);
  if (dot < -0.999999) {
    // Opposite directions: half a turn about any axis across them.
    const across: Vector = Math.abs(a[0]) < 0.7 * la ? [0, a[2], -a[1]] : [-a[2], 0, a[0]];
    const size = Math.hypot(...across);
    return [across[0] / size, across[1] / size, across[2] / size, 0];
  }
  const x = (a[1] * b[2] - a[2] * b[1]) / (la * lb),
    y = (a[2] * b[0] - a[0] * b[2]) / (la * lb);
  const z = (a[0] * b[1] - a[1] * b[0]) / (la * lb),
    w = 1 + dot;
  const size = Math.hypot(x, y, z, w);
  return [x / size, y / size, z / size, w / size];
}
