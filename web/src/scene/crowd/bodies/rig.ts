// Forward kinematics: from a pose to the joints of a body with proportions of its own.

import { addTurned, multiply } from './quaternion';
import { kJoints, kSkeleton, restPositions } from '../../../model/skeleton';

/** A body's joints as it was modelled. All in body axes: x forward, y left, z up, feet on the ground [m]. */
export interface Rig {
  /** x, y, z per joint. */
  readonly bind: Float32Array;
  /** Per joint the rotation from the modelled pose to our rest pose; it lifts arms that were modelled hanging. */
  readonly align: Float32Array;
  /** Height of its hips divided by that of our skeleton's; it scales the motion of the hips. */
  readonly scale: number;
}

/** Floats per joint: the turn since modelling x, y, z, w, and where it is x, y, z, 0. */
export const kJointFloats = 8;
export const kPoseFloats = kJointFloats * kJoints;
/** Numbers of a pose: hips x, y, z, then per joint x, y, z, w relative to its parent. */
export const kPoseNumbers = 3 + 4 * kJoints;

const kParents = kSkeleton.map((joint) => joint.parent);

/** A rig modelled in our rest pose. */
export function plainRig(bind: Float32Array = restPositions()): Rig {
  const align = new Float32Array(4 * kJoints);
  for (let j = 0; j < kJoints; ++j) align[4 * j + 3] = 1;
  return { bind, align, scale: bind[2]! / restPositions()[2]! };
}

/** True where both rigs have the same joints in every pose. */
export function sameRig(a: Rig, b: Rig): boolean {
  const close = (p: Float32Array, q: Float32Array): boolean => p.every((one, i) => Math.abs(one - q[i]!) < 1e-4);
  return Math.abs(a.scale - b.scale) < 1e-4 && close(a.bind, b.bind) && close(a.align, b.align);
}

const turned = new Float32Array(4 * kJoints);

/** Writes the joints of a pose (from `pose[at]` on) to `out[o]`. */
export function solveRig(rig: Rig, pose: Float32Array, at: number, out: Float32Array, o: number): void {
  const { bind, align, scale } = rig;
  for (let j = 0; j < kJoints; ++j) {
    const parent = kParents[j]!;
    const to = o + kJointFloats * j;
    const local = at + 3 + 4 * j;
    if (parent < 0) {
      for (let k = 0; k < 4; ++k) turned[k] = pose[local + k]!;
      for (let k = 0; k < 3; ++k) out[to + 4 + k] = pose[at + k]! * scale;
    } else {
      const from = o + kJointFloats * parent;
      multiply(turned, 4 * j, turned, 4 * parent, pose, local);
      for (let k = 4; k < 7; ++k) out[to + k] = out[from + k]!;
      addTurned(
        out,
        to + 4,
        out,
        from,
        bind[3 * j]! - bind[3 * parent]!,
        bind[3 * j + 1]! - bind[3 * parent + 1]!,
        bind[3 * j + 2]! - bind[3 * parent + 2]!,
      );
    }
    multiply(out, to, turned, 4 * j, align, 4 * j);
  }
}
