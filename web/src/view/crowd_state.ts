// The characters as shown just now: between two frames, with the clips they play.

import { bodyOf, lookOf, sizeOf } from '../people/look';
import { mix, mixAngle } from './blend';
import type { FrameBlend } from './frame_timeline';
import type { FrameView, Numbers } from './frame_types';

/** What it must know of clips, by index. */
export interface ClipLengths {
  /** Of one play [s]. */
  length(clip: number): number;
  cyclic(clip: number): boolean;
}

const kUnknown: ClipLengths = { length: () => 1, cyclic: () => true };

/** Two faces farther apart than this between frames are a fresh start, not a turn or a walk [m]. */
const kJump = 1.5;

export class CrowdState {
  count = 0;
  ids = new Uint32Array(0);
  group = new Uint8Array(0);
  /** x, y, heading, size per character. */
  placement = new Float32Array(0);
  /** Indices of clips, and times in them [s]; `fade`: share of the clip before. */
  clip = new Uint8Array(0);
  time = new Float32Array(0);
  before = new Uint8Array(0);
  beforeTime = new Float32Array(0);
  fade = new Float32Array(0);
  /** Skin and hair as one number. */
  look = new Uint8Array(0);
  private bodyDraw_ = new Uint32Array(0);
  private clips_: ClipLengths = kUnknown;

  setClips(clips: ClipLengths): void {
    this.clips_ = clips;
  }

  clear(): void {
    this.setMembers([], []);
  }

  /** Takes the list of who is there; call when a frame brings one. */
  setMembers(ids: Numbers, group: Numbers): void {
    const count = ids.length;
    this.count = count;
    this.ids = Uint32Array.from(ids);
    this.group = Uint8Array.from(group);
    this.placement = new Float32Array(4 * count);
    [this.clip, this.before, this.look] = [new Uint8Array(count), new Uint8Array(count), new Uint8Array(count)];
    [this.time, this.beforeTime, this.fade] = [new Float32Array(count), new Float32Array(count), new Float32Array(count)];
    this.bodyDraw_ = new Uint32Array(count);
    for (let i = 0; i < count; ++i) {
      const id = this.ids[i]!;
      const { skin, hair } = lookOf(id);
      this.placement[4 * i + 3] = sizeOf(id);
      this.look[i] = 5 * skin + hair;
      // Divisible by as many bodies as there may ever be.
      this.bodyDraw_[i] = bodyOf(id, 12);
    }
  }

  /** Which of `bodies` (1, 2, 3, 4, 6) a character has. */
  body(i: number, bodies: number): number {
    return this.bodyDraw_[i]! % bodies;
  }

  /** Moves everyone to a moment between two frames. */
  update({ from, to, alpha }: FrameBlend): void {
    const count = Math.min(this.count, to.x.length);
    const whole = from.x.length !== to.x.length ? 1 : alpha;
    for (let i = 0; i < count; ++i) {
      const t = this.place(i, from, to, whole);
      this.play(i, from, to, t);
    }
  }

  /** Returns how far from `from` to `to` this one is shown. */
  private place(i: number, from: FrameView, to: FrameView, whole: number): number {
    const p = this.placement;
    const [bx, by] = [to.x[i] ?? 0, to.y[i] ?? 0];
    const [ax, ay] = [from.x[i] ?? bx, from.y[i] ?? by];
    const t = Math.abs(bx - ax) + Math.abs(by - ay) > kJump ? 1 : whole;
    p[4 * i] = t === 1 ? bx : mix(ax, bx, t);
    p[4 * i + 1] = t === 1 ? by : mix(ay, by, t);
    const heading = to.heading[i] ?? 0;
    p[4 * i + 2] = t === 1 ? heading : mixAngle(from.heading[i] ?? heading, heading, t);
    return t;
  }

  private play(i: number, from: FrameView, to: FrameView, t: number): void {
    const clip = to.clip[i] ?? 0;
    const same = t < 1 && from.clip[i] === clip;
    const before = to.fromClip[i] ?? 0;
    const sameBefore = t < 1 && from.fromClip[i] === before;
    const fade = (to.fade[i] ?? 0) / 255;
    this.clip[i] = clip;
    this.before[i] = before;
    this.time[i] = this.timeBetween(clip, same ? from.clipTime[i] : undefined, to.clipTime[i] ?? 0, t);
    this.beforeTime[i] = this.timeBetween(before, sameBefore ? from.fromTime[i] : undefined, to.fromTime[i] ?? 0, t);
    this.fade[i] = same && sameBefore ? mix((from.fade[i] ?? 0) / 255, fade, t) : fade;
  }

  /** Between two times of a clip [ms], the short way round where it is cyclic; in seconds. */
  private timeBetween(clip: number, from: number | undefined, to: number, t: number): number {
    if (from === undefined) return to / 1000;
    let gone = (to - from) / 1000;
    const length = this.clips_.length(clip);
    if (this.clips_.cyclic(clip)) gone -= length * Math.round(gone / length);
    // One that begins anew does not run backwards.
    else if (Math.abs(gone) > 0.5) return to / 1000;
    return to / 1000 - gone * (1 - t);
  }
}
