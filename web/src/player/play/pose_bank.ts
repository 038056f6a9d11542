// The poses of all clips, solved on the skeleton once, and mixed for each character of a picture.

import type { PlayedClip, Skeleton } from '../file/figures_reader';

/** Numbers per joint: its rotation, and where a point that rests at the origin comes to. */
export const kJointFloats = 8;

export class PoseBank {
  readonly joints: number;
  private readonly solved_: Float32Array;
  private readonly first_: number[] = [];

  constructor(
    skeleton: Skeleton,
    private readonly clips_: readonly PlayedClip[],
  ) {
    this.joints = skeleton.parents.length;
    const size = kJointFloats * this.joints;
    this.solved_ = new Float32Array(size * clips_.reduce((sum, clip) => sum + clip.poses, 0));
    let pose = 0;
    for (const clip of clips_) {
      this.first_.push(size * pose);
      for (let k = 0; k < clip.poses; ++k) solve(skeleton, clip, k, this.solved_, size * pose++);
    }
  }

  /** Writes the joints of a character: the clip at a time, and a share of the clip before. */
  write(clip: number, time: number, from: number, fromTime: number, fade: number, out: Float32Array, at: number): void {
    const [a, b, share] = this.spot(clip, time);
    const size = kJointFloats * this.joints;
    if (fade < 0.004) {
      for (let k = 0; k < size; k += kJointFloats) mix(this.solved_, a + k, b + k, share, out, at + k);
      return;
    }
    const [c, d, otherShare] = this.spot(from, fromTime);
    for (let k = 0; k < size; k += kJointFloats) {
      mix(this.solved_, a + k, b + k, share, out, at + k);
      mix(this.solved_, c + k, d + k, otherShare, kOther, 0);
      blend(out, at + k, kOther, fade);
    }
  }

  /** The two poses round a time, and how far from one to the other. */
  private spot(clip: number, time: number): [number, number, number] {
    const { poses, duration, cyclic } = this.clips_[clip]!;
    const size = kJointFloats * this.joints;
    const first = this.first_[clip]!;
    const at = (time / duration) * (cyclic ? poses : poses - 1);
    const whole = Math.min(poses - 1, Math.max(0, Math.floor(at)));
    const next = whole + 1 < poses ? whole + 1 : cyclic ? 0 : whole;
    return [first + size * whole, first + size * next, at - whole];
  }
}

const kOther = new Float32Array(kJointFloats);

/** Between two joints of `from`. */
function mix(from: Float32Array, a: number, b: number, t: number, out: Float32Array, at: number): void {
  let dot = 0;
  for (let k = 0; k < 4; ++k) dot += from[a + k]! * from[b + k]!;
  const [u, v] = [1 - t, dot < 0 ? -t : t];
  for (let k = 0; k < 4; ++k) out[at + k] = u * from[a + k]! + v * from[b + k]!;
  for (let k = 4; k < 7; ++k) out[at + k] = u * from[a + k]! + t * from[b + k]!;
  normalise(out, at);
}

/** Mixes a share of another joint into one. */
function blend(out: Float32Array, at: number, other: Float32Array, t: number): void {
  let dot = 0;
  for (let k = 0; k < 4; ++k) dot += out[at + k]! * other[k]!;
  const v = dot < 0 ? -t : t;
  for (let k = 0; k < 4; ++k) out[at + k] = (1 - t) * out[at + k]! + v * other[k]!;
  for (let k = 4; k < 7; ++k) out[at + k] = (1 - t) * out[at + k]! + t * other[k]!;
  normalise(out, at);
}

function normalise(out: Float32Array, at: number): void {
  const length = Math.hypot(out[at]!, out[at + 1]!, out[at + 2]!, out[at + 3]!) || 1;
  for (let k = 0; k < 4; ++k) out[at + k]! /= length;
}

/** Forward kinematics of one pose. The hips hang on nothing, all others on their parents. */
function solve(skeleton: Skeleton, clip: PlayedClip, pose: number, out: Float32Array, at: number): void {
  const { parents, offsets } = skeleton;
  const joints = parents.length;
  const rest = restPlaces(skeleton);
  const places = new Float32Array(3 * joints);
  for (let j = 0; j < joints; ++j) {
    const own = clip.rotations.subarray(4 * (joints * pose + j), 4 * (joints * pose + j) + 4);
    const to = at + kJointFloats * j;
    const parent = parents[j]!;
    if (parent < 0) {
      out.set(own, to);
      places.set(clip.hips.subarray(3 * pose, 3 * pose + 3), 3 * j);
    } else {
      const up = at + kJointFloats * parent;
      multiply(out, up, own, out, to);
      const moved = turned(out, up, offsets, 3 * j);
      for (let k = 0; k < 3; ++k) places[3 * j + k] = places[3 * parent + k]! + moved[k]!;
    }
    normalise(out, to);
    const back = turned(out, to, rest, 3 * j);
    for (let k = 0; k < 3; ++k) out[to + 4 + k] = places[3 * j + k]! - back[k]!;
  }
}

/** Where the joints are in the rest pose. */
function restPlaces({ parents, offsets }: Skeleton): Float32Array {
  const rest = new Float32Array(offsets.length);
  for (let j = 0; j < parents.length; ++j)
    for (let k = 0; k < 3; ++k)
      rest[3 * j + k] = offsets[3 * j + k]! + (parents[j]! < 0 ? 0 : rest[3 * parents[j]! + k]!);
  return rest;
}

function multiply(a: Float32Array, at: number, b: Float32Array, out: Float32Array, to: number): void {
  const [ax, ay, az, aw] = [a[at]!, a[at + 1]!, a[at + 2]!, a[at + 3]!];
  const [bx, by, bz, bw] = [b[0]!, b[1]!, b[2]!, b[3]!];
  out[to] = aw * bx + ax * bw + ay * bz - az * by;
  out[to + 1] = aw * by - ax * bz + ay * bw + az * bx;
  out[to + 2] = aw * bz + ax * by - ay * bx + az * bw;
  out[to + 3] = aw * bw - ax * bx - ay * by - az * bz;
}

function turned(q: Float32Array, at: number, v: Float32Array, from: number): [number, number, number] {
  const [qx, qy, qz, qw] = [q[at]!, q[at + 1]!, q[at + 2]!, q[at + 3]!];
  const [x, y, z] = [v[from]!, v[from + 1]!, v[from + 2]!];
  const [tx, ty, tz] = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)];
  return [x + qw * tx + qy * tz - qz * ty, y + qw * ty + qz * tx - qx * tz, z + qw * tz + qx * ty - qy * tx];
}
