// All motion clips as poses, one after the other.

import { kPoseNumbers, type Rig, kPoseFloats, solveRig } from '../bodies/rig';
import { kJoints } from '../../../model/skeleton';

/** A clip as the server or a file has it. */
export interface ClipPoses {
  readonly name: string;
  readonly motion: string;
  /** Poses a second. */
  readonly rate: number;
  readonly cyclic: boolean;
  readonly poses: number;
  /** x, y, z per pose [m]. */
  readonly hips: ArrayLike<number>;
  /** x, y, z, w per joint and pose; whole numbers over 32767 or true ones. */
  readonly rotations: ArrayLike<number>;
}

interface Entry {
  readonly first: number;
  readonly poses: number;
  readonly cyclic: boolean;
  readonly name: string;
  readonly motion: string;
  /** A visitor's clip replaces the server's: the server's whole poses do not belong to it. */
  readonly replaced: boolean;
}

/** Stands with hanging arms; what is shown before clips arrive. */
export function standingClip(): ClipPoses {
  const rotations = new Array<number>(4 * kJoints).fill(0);
  for (let j = 0; j < kJoints; ++j) rotations[4 * j + 3] = 1;
  const turnArm = (joint: number, angle: number): void => {
    rotations[4 * joint] = Math.sin(angle / 2);
    rotations[4 * joint + 3] = Math.cos(angle / 2);
  };
  turnArm(6, -1.35);
  turnArm(10, 1.35);
  return { name: 'idle', motion: 'run', rate: 1, cyclic: true, poses: 1, hips: [0, 0, 0.95], rotations };
}

export class ClipBank {
  readonly poseCount: number;
  /** kPoseNumbers per pose. */
  readonly poses: Float32Array;
  private readonly entries_: Entry[] = [];

  /** `own`: clips that replace those of the same name. */
  constructor(clips: readonly ClipPoses[], own: readonly ClipPoses[] = []) {
    const wanted = clips.length > 0 ? clips : [standingClip()];
    const played = wanted.map((clip) => own.find((one) => one.name === clip.name) ?? clip);
    this.poseCount = played.reduce((sum, clip) => sum + clip.poses, 0);
    this.poses = new Float32Array(kPoseNumbers * this.poseCount);
    let first = 0;
    played.forEach((clip, i) => {
      const original = wanted[i]!;
      this.entries_.push({
        first,
        poses: clip.poses,
        cyclic: original.cyclic,
        name: original.name,
        motion: original.motion,
        replaced: clip !== original,
      });
      this.fill(clip, first);
      first += clip.poses;
    });
  }

  get clipCount(): number {
    return this.entries_.length;
  }

  name(clip: number): string {
    return this.entry(clip).name;
  }

  motion(clip: number): string {
    return this.entry(clip).motion;
  }

  replaced(clip: number): boolean {
    return this.entry(clip).replaced;
  }

  /** Where in the bank its poses are. */
  span(clip: number): { readonly first: number; readonly poses: number; readonly cyclic: boolean } {
    return this.entry(clip);
  }

  /** All poses solved on a body: kPoseFloats per pose. */
  bake(rig: Rig, out: Float32Array): void {
    for (let i = 0; i < this.poseCount; ++i) solveRig(rig, this.poses, kPoseNumbers * i, out, kPoseFloats * i);
  }

  private entry(clip: number): Entry {
    return this.entries_[clip] ?? this.entries_[0]!;
  }

  private fill(clip: ClipPoses, first: number): void {
    const { hips, rotations, poses } = clip;
    const whole = ArrayBuffer.isView(rotations) && rotations instanceof Int16Array ? 1 / 32767 : 1;
    for (let i = 0; i < poses; ++i) {
      const at = kPoseNumbers * (first + i);
      for (let k = 0; k < 3; ++k) this.poses[at + k] = hips[3 * i + k] ?? 0;
      for (let k = 0; k < 4 * kJoints; ++k) this.poses[at + 3 + k] = (rotations[4 * kJoints * i + k] ?? 0) * whole;
    }
  }
}
