// Animations that a visitor's file carries under names of motions: they replace our clips.

import { AnimationMixer, type AnimationClip, type Object3D, Quaternion, Vector3 } from 'three';
import type { ClipPoses } from '../clips/clip_bank';
import { pointToOurs, turnToOurs, type OwnRig } from './own_rig';
import { conjugate, multiply } from '../bodies/quaternion';
import { jointIndex, kJoints, kSkeleton } from '../../../model/skeleton';

/** Poses a second. */
const kRate = 30;
/** Longest part of an animation that is taken [s]. */
const kLongest = 12;

/** The first pattern that matches decides: a running jump is a jump. */
const kMotions: readonly (readonly [RegExp, string])[] = [
  [/crawl/, 'crawl'],
  [/swim/, 'swim'],
  [/climb/, 'climb'],
  [/jump/, 'jump'],
  [/\b(duck|crouch|sneak)/, 'duck'],
  [/sprint/, 'sprint'],
  [/\brun(ning)?\b/, 'run'],
  [/\bjog(ging)?\b/, 'jog'],
  [/\bwalk(ing)?\b/, 'walk'],
  [/\b(idle|stand(ing)?|breathing)\b/, 'idle'],
];

/** The clip that an animation of this name stands for; null for none. */
export function clipOfName(name: string): string | null {
  const words = name
    .replace(/^.*\|/, '')
    .replace(/([a-z])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .replace(/[_.]+/g, ' ');
  // Told from "run" only by their further words: "run left", "start walk" and the like are not the plain motion.
  if (/\b(left|right|back(wards?)?|turn|start|stop|strafe|enter|exit|to)\b/.test(words)) return null;
  return kMotions.find(([pattern]) => pattern.test(words))?.[1] ?? null;
}

/** One clip per motion: the first animation that stands for it. */
export function readClips(root: Object3D, animations: readonly AnimationClip[], own: OwnRig): ClipPoses[] {
  const rest = own.bones.map((bone) => bone.getWorldQuaternion(new Quaternion()).invert());
  const clips: ClipPoses[] = [];
  for (const animation of animations) {
    const name = clipOfName(animation.name);
    if (!name || animation.duration < 0.1 || clips.some((clip) => clip.name === name)) continue;
    clips.push(new Sampler(root, animation, own, rest).sample(name));
  }
  return clips;
}

class Sampler {
  private readonly turned_ = new Float32Array(4 * kJoints);
  private readonly scratch_ = new Float32Array(4);
  private readonly hips_: number[] = [];
  private readonly rotations_: number[] = [];

  constructor(
    private readonly root_: Object3D,
    private readonly animation_: AnimationClip,
    private readonly own_: OwnRig,
    private readonly rest_: readonly Quaternion[],
  ) {}

  sample(name: string): ClipPoses {
    const mixer = new AnimationMixer(this.root_);
    mixer.clipAction(this.animation_).play();
    const duration = Math.min(kLongest, this.animation_.duration);
    const poses = Math.max(2, Math.round(duration * kRate));
    for (let i = 0; i < poses; ++i) {
      mixer.setTime((duration * i) / poses);
      this.root_.updateMatrixWorld(true);
      this.take();
    }
    mixer.stopAllAction();
    this.root_.updateMatrixWorld(true);
    this.stay(poses);
    return {
      name,
      motion: name,
      rate: poses / duration,
      cyclic: true,
      poses,
      hips: this.hips_,
      rotations: this.rotations_,
    };
  }

  private take(): void {
    const { bones, roles, axes, rig } = this.own_;
    const now = new Quaternion();
    kSkeleton.forEach(({ parent }, j) => {
      const bone = roles[j]! < 0 ? null : bones[roles[j]!]!;
      if (!bone) {
        this.turned_.copyWithin(4 * j, 4 * Math.max(0, parent), 4 * Math.max(0, parent) + 4);
      } else {
        bone.getWorldQuaternion(now).multiply(this.rest_[roles[j]!]!);
        conjugate(this.scratch_, 0, rig.align, 4 * j);
        multiply(this.turned_, 4 * j, turnToOurs(axes, now), 0, this.scratch_, 0);
      }
      this.local(j, parent);
    });
    const hips = bones[roles[jointIndex('Hips')]!]!;
    this.hips_.push(
      ...pointToOurs(axes, new Vector3().setFromMatrixPosition(hips.matrixWorld)).map((one) => one / rig.scale),
    );
  }

  private local(j: number, parent: number): void {
    if (parent < 0) {
      this.rotations_.push(...this.turned_.slice(0, 4));
      return;
    }
    const out = [0, 0, 0, 1];
    conjugate(this.scratch_, 0, this.turned_, 4 * parent);
    multiply(out, 0, this.scratch_, 0, this.turned_, 4 * j);
    this.rotations_.push(...out);
  }

  /** Removes the displacement over the clip, since the simulation moves the characters. */
  private stay(poses: number): void {
    for (const k of [0, 1]) {
      const first = this.hips_[k]!;
      const displacement = this.hips_[3 * (poses - 1) + k]! - first;
      for (let i = 0; i < poses; ++i) this.hips_[3 * i + k]! -= first + (displacement * i) / (poses - 1);
    }
  }
}
