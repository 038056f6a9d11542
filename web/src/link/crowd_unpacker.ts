// Restores the whole crowd from the changes in a frame. Frames arrive completely and in order, so each holds the
// differences to the one before; a client's first frame, and the first of another crowd, is whole.

import type { CrowdFrame } from '../protocol/messages';
import { kRowFloats, rowsLength } from '../model/studio_frame';

/** What unpacking needs of a clip. */
export interface ClipLength {
  /** Of one play [s]. */
  readonly seconds: number;
  readonly cyclic: boolean;
}

export interface UnpackedCrowd {
  readonly x: Float32Array;
  readonly y: Float32Array;
  readonly clip: Uint8Array;
  readonly rows: Float32Array;
}

const kTurn = 2 * Math.PI;
/** A clip fades out in this time [s]; the server's whole poses do the same. */
const kFade = 0.2;
/** No clip fades after a longer gap [s]. */
const kGap = 0.3;
const kUnknown: ClipLength = { seconds: 1, cyclic: true };

export class CrowdUnpacker {
  private clips_: readonly ClipLength[] = [];
  private count_ = 0;
  private x_ = new Uint16Array(0);
  private y_ = new Uint16Array(0);
  private clip_ = new Uint8Array(0);
  private phase_ = new Float32Array(0);
  private before_ = new Uint8Array(0);
  private beforePhase_ = new Float32Array(0);
  private fade_ = new Float32Array(0);
  private time_ = 0;

  setClips(clips: readonly ClipLength[]): void {
    this.clips_ = clips;
  }

  /** `time`: of the frame, in the world [s]. */
  unpack(crowd: CrowdFrame, time: number): UnpackedCrowd {
    const passed = time - this.time_;
    this.time_ = time;
    const whole = crowd.stepX.length === 0;
    if (whole) this.begin(crowd);
    else this.move(crowd);
    this.play(crowd, !whole && passed >= 0 && passed < kGap ? passed : Infinity);
    return this.write(crowd);
  }

  private begin({ count, x, y, clip }: CrowdFrame): void {
    this.count_ = count;
    this.x_ = Uint16Array.from(x);
    this.y_ = Uint16Array.from(y);
    this.clip_ = Uint8Array.from(clip);
    this.before_ = new Uint8Array(count);
    [this.phase_, this.beforePhase_, this.fade_] = [
      new Float32Array(count),
      new Float32Array(count),
      new Float32Array(count),
    ];
  }

  private move({ stepX, stepY, jumped, jumpedX, jumpedY, count }: CrowdFrame): void {
    if (count !== this.count_) throw new Error(`a frame of ${count} characters after one of ${this.count_}`);
    const { x_: x, y_: y } = this;
    for (let i = 0; i < count; ++i) {
      x[i]! += stepX[i]!;
      y[i]! += stepY[i]!;
    }
    for (let k = 0; k < jumped.length; ++k) {
      x[jumped[k]!] = jumpedX[k]!;
      y[jumped[k]!] = jumpedY[k]!;
    }
  }

  /** Advances the phases of all clips. Where a character changed its clip, the clip before fades. */
  private play(crowd: CrowdFrame, passed: number): void {
    const fine = crowd.phaseFine.length > 0;
    const { clip_: clip, phase_: phase, fade_: fade } = this;
    // A whole frame has set the clips already.
    for (let k = 0; k < crowd.changed.length; ++k) {
      const who = crowd.changed[k]!;
      this.before_[who] = clip[who]!;
      this.beforePhase_[who] = phase[who]!;
      fade[who] = passed < Infinity ? 1 : 0;
      clip[who] = crowd.clip[k]!;
      phase[who] = NaN;
    }
    for (let i = 0; i < this.count_; ++i) {
      const now = (crowd.phase[i]! + (fine ? crowd.phaseFine[i]! / 256 : 0.5)) / 256;
      // A character that has just changed its clip begins to fade with the next frame.
      if (fade[i]! > 0 && phase[i]! >= 0) this.fadeOn(i, now - phase[i]!, passed);
      phase[i] = now;
    }
  }

  private fadeOn(i: number, step: number, passed: number): void {
    const { seconds, cyclic } = this.clips_[this.clip_[i]!] ?? kUnknown;
    const moved = (cyclic ? step - Math.round(step) : Math.max(0, step)) * seconds;
    const before = this.clips_[this.before_[i]!] ?? kUnknown;
    const at = this.beforePhase_[i]! + moved / before.seconds;
    this.beforePhase_[i] = before.cyclic ? at - Math.floor(at) : Math.min(1, at);
    this.fade_[i] = Math.max(0, this.fade_[i]! - passed / kFade);
  }

  private write({ count, x0, y0, quantum, heading, headingFine }: CrowdFrame): UnpackedCrowd {
    const x = new Float32Array(count),
      y = new Float32Array(count),
      rows = new Float32Array(rowsLength(count));
    const fine = headingFine.length > 0;
    for (let i = 0, at = 0; i < count; ++i, at += kRowFloats) {
      x[i] = rows[at] = x0 + this.x_[i]! * quantum;
      y[i] = rows[at + 1] = y0 + this.y_[i]! * quantum;
      rows[at + 2] = ((heading[i]! + (fine ? headingFine[i]! / 256 : 0.5)) / 256) * kTurn;
      rows[at + 3] = this.fade_[i]!;
      rows[at + 4] = this.clip_[i]!;
      rows[at + 5] = this.phase_[i]!;
      rows[at + 6] = this.before_[i]!;
      rows[at + 7] = this.beforePhase_[i]!;
    }
    return { x, y, clip: this.clip_.slice(), rows };
  }
}
