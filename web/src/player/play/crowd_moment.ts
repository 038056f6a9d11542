// A crowd at any time between two frames of a file.

import { kFadeTime, timeIn, type Crowd } from '../file/crowd_reader';
import type { PlayedClip } from '../file/figures_reader';
import type { LoadedCrowd } from '../file/loaded_crowd';

/** Whoever goes farther in a frame was put elsewhere [m/s]. */
const kPutElsewhere = 30;

export class CrowdMoment {
  /** How many characters there are now. The arrays may be longer. */
  count = 0;
  readonly who: Uint32Array;
  /** [m] */
  readonly x: Float32Array;
  readonly y: Float32Array;
  /** [rad] */
  readonly yaw: Float32Array;
  readonly colour: Uint16Array;
  /** The clip and the time in it; the clip before, its time, and its share, 0 to 1. */
  readonly clip: Uint16Array;
  readonly time: Float32Array;
  readonly fromClip: Uint16Array;
  readonly fromTime: Float32Array;
  readonly fade: Float32Array;
  /** Of moving things: x, y, angle. */
  readonly things: Float32Array;
  private readonly crowd_: Crowd;
  private readonly clips_: readonly PlayedClip[];
  private readonly frameTime_: number;
  private readonly frames_: number;

  constructor({ head, crowd, clips }: LoadedCrowd) {
    this.crowd_ = crowd;
    this.clips_ = clips;
    this.frameTime_ = 1 / head.fps;
    this.frames_ = head.frames;
    const most = head.most;
    this.who = new Uint32Array(most);
    this.x = new Float32Array(most);
    this.y = new Float32Array(most);
    this.yaw = new Float32Array(most);
    this.colour = new Uint16Array(most);
    this.clip = new Uint16Array(most);
    this.time = new Float32Array(most);
    this.fromClip = new Uint16Array(most);
    this.fromTime = new Float32Array(most);
    this.fade = new Float32Array(most);
    this.things = new Float32Array(3 * head.things);
  }

  /** Goes to a time since the first frame [s], which is clamped to the file's. */
  goTo(time: number): void {
    const at = Math.min(this.frames_ - 1, Math.max(0, time / this.frameTime_ || 0));
    const frame = Math.min(Math.floor(at), Math.max(0, this.frames_ - 2));
    const share = at - frame;
    this.moveThings(frame, share);
    this.count = 0;
    if (share <= 0 || this.frames_ < 2) return this.show(frame);
    if (share >= 1) return this.show(frame + 1);
    const { first, before } = this.crowd_;
    for (let to = first[frame + 1]!; to < first[frame + 2]!; ++to) {
      const from = before[to]!;
      if (from >= 0) this.between(from, to, share);
    }
  }

  /** Shows one frame as it is. */
  private show(frame: number): void {
    const { first } = this.crowd_;
    for (let sample = first[frame]!; sample < first[frame + 1]!; ++sample) this.place(sample, sample, 0, this.count++);
    for (let i = 0; i < this.count; ++i) {
      const sample = first[frame]! + i;
      this.play(i, sample, this.crowd_.time[sample]!);
      this.blend(i, this.crowd_.fromClip[sample]!, this.crowd_.fromTime[sample]!, this.crowd_.fade[sample]!);
    }
  }

  private between(from: number, to: number, share: number): void {
    const crowd = this.crowd_;
    const i = this.count++;
    this.place(from, to, share, i);
    if (crowd.switched[to]) {
      this.switching(i, from, to, share);
      return;
    }
    const went = share * crowd.advance[to]!;
    this.play(i, from, crowd.time[from]! + went);
    const faded = (share * this.frameTime_) / kFadeTime;
    this.blend(i, crowd.fromClip[from]!, crowd.fromTime[from]! + went, Math.max(0, crowd.fade[from]! - faded));
  }

  /** Between two frames with a switch of clips: how far that has faded tells when it was. */
  private switching(i: number, from: number, to: number, share: number): void {
    const crowd = this.crowd_;
    const went = share * crowd.advance[from]!;
    const fade = crowd.fade[to]!;
    const faded = this.frameTime_ / kFadeTime;
    const when = fade > 0 ? Math.max(0, 1 - (1 - fade) / faded) : 1;
    if (share < when) {
      this.play(i, from, crowd.time[from]! + went);
      const left = Math.max(0, crowd.fade[from]! - share * faded);
      this.blend(i, crowd.fromClip[from]!, crowd.fromTime[from]! + went, left);
      return;
    }
    this.play(i, to, crowd.time[to]! - (1 - share) * crowd.advance[from]!);
    this.blend(i, crowd.clip[from]!, crowd.time[from]! + went, Math.min(1, fade + (1 - share) * faded));
  }

  private place(from: number, to: number, share: number, i: number): void {
    const { x, y, yaw, who, colour } = this.crowd_;
    const [byX, byY] = [x[to]! - x[from]!, y[to]! - y[from]!];
    const part = Math.hypot(byX, byY) > kPutElsewhere * this.frameTime_ ? 0 : share;
    this.x[i] = x[from]! + part * byX;
    this.y[i] = y[from]! + part * byY;
    const turn = yaw[to]! - yaw[from]!;
    this.yaw[i] = yaw[from]! + part * (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
    this.who[i] = who[to]!;
    this.colour[i] = colour[from]!;
  }

  private play(i: number, sample: number, time: number): void {
    const clip = this.crowd_.clip[sample]!;
    this.clip[i] = clip;
    this.time[i] = timeIn(this.clips_[clip]!, time);
  }

  private blend(i: number, clip: number, time: number, fade: number): void {
    this.fromClip[i] = clip;
    this.fromTime[i] = timeIn(this.clips_[clip]!, time);
    this.fade[i] = fade;
  }

  private moveThings(frame: number, share: number): void {
    const all = this.crowd_.things;
    const count = this.things.length;
    for (let k = 0; k < count; ++k) {
      const now = all[count * frame + k]!;
      const then = all[count * (frame + 1) + k] ?? now;
      this.things[k] = now + share * (then - now);
    }
  }
}
