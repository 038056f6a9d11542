// Whole poses of the characters near the view, between the two frames shown. They are interpolated exactly as positions
// and headings are, so that a foot that stands still in both frames stands still on the screen.

import type { Numbers } from '../../../model/frame_view';
import { nlerp } from '../bodies/quaternion';
import { kPoseNumbers, type Rig, kPoseFloats, solveRig } from '../bodies/rig';
import { kJoints } from '../../../model/skeleton';

/** The fields of a frame that they need. */
export interface NearFrame {
  /** One per character: how many there are. */
  readonly x: Numbers;
  readonly near: Numbers;
  readonly nearPoses: Numbers;
}

export class NearPoses {
  /** Per character its slot, or -1. */
  slots = new Int16Array(0);
  count = 0;
  private readonly a_ = new Float32Array(kPoseNumbers);
  private readonly b_ = new Float32Array(kPoseNumbers);
  private earlier_ = new Int32Array(0);
  private poses_ = new Float32Array(0);

  /** Interpolates the whole poses of `to`, at most `most` of them; the crowd has `members` characters. */
  mix(from: NearFrame, to: NearFrame, alpha: number, members: number, most: number): void {
    this.count = Math.min(to.near.length, Math.floor(to.nearPoses.length / kPoseNumbers), most);
    this.reserve(members);
    this.slots.fill(-1);
    this.earlier_.fill(-1);
    // Where the crowd has changed, indices of the two frames do not agree.
    const sameCrowd = from !== to && alpha < 1 && from.x.length === to.x.length;
    if (sameCrowd) for (let k = 0; k < from.near.length; ++k) this.earlier_[from.near[k]!] = k;
    for (let k = 0; k < this.count; ++k) {
      const who = to.near[k]!;
      if (who >= members) continue;
      this.slots[who] = k;
      this.mixOne(from, this.earlier_[who]!, to, k, alpha);
    }
  }

  /** Solves them on a body: kPoseFloats per slot. */
  solve(rig: Rig, out: Float32Array): void {
    for (let k = 0; k < this.count; ++k) solveRig(rig, this.poses_, kPoseNumbers * k, out, kPoseFloats * k);
  }

  private reserve(members: number): void {
    if (this.slots.length !== members) {
      this.slots = new Int16Array(members);
      this.earlier_ = new Int32Array(members);
    }
    if (this.poses_.length < kPoseNumbers * this.count) this.poses_ = new Float32Array(kPoseNumbers * this.count);
  }

  private mixOne(from: NearFrame, earlier: number, to: NearFrame, slot: number, alpha: number): void {
    const at = kPoseNumbers * slot;
    read(to.nearPoses, slot, this.b_);
    if (earlier < 0) {
      this.poses_.set(this.b_, at);
      return;
    }
    read(from.nearPoses, earlier, this.a_);
    for (let k = 0; k < 3; ++k) this.poses_[at + k] = this.a_[k]! + (this.b_[k]! - this.a_[k]!) * alpha;
    for (let j = 0; j < kJoints; ++j) nlerp(this.poses_, at + 3 + 4 * j, this.a_, 3 + 4 * j, this.b_, 3 + 4 * j, alpha);
  }
}

function read(numbers: Numbers, slot: number, out: Float32Array): void {
  const at = kPoseNumbers * slot;
  for (let k = 0; k < kPoseNumbers; ++k) out[k] = numbers[at + k]!;
}
