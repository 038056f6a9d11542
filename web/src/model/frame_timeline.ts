// Chooses the two frames between which the display interpolates. It runs about one frame late and never extrapolates.

import type { FrameView } from './frame_view';

/** Two frames and how far the display is from the first to the second. */
export interface FrameBlend {
  readonly from: FrameView;
  readonly to: FrameView;
  /** 0 to 1. */
  readonly alpha: number;
}

interface Stamped {
  readonly frame: FrameView;
  /** Arrival without its jitter, by the page's clock [ms]. */
  readonly due: number;
}

const kFirstInterval = 1000 / 60;
/** The display never runs further behind than this [ms]. */
const kDelayMost = 80;
/** A stall longer than this starts the timeline anew [ms]. */
const kBreak = 250;

export class FrameTimeline {
  private readonly stamped_: Stamped[] = [];
  private interval_ = kFirstInterval;
  private jitter_ = 0;
  private lastArrival_ = -Infinity;

  /** The spacing of frames [ms], averaged. */
  get interval(): number {
    return this.interval_;
  }

  /** How far behind the newest frame the display runs [ms]. */
  get delay(): number {
    return Math.min(kDelayMost, this.interval_ + Math.min(this.jitter_, this.interval_ / 2));
  }

  get newest(): FrameView | null {
    return this.stamped_[this.stamped_.length - 1]?.frame ?? null;
  }

  clear(): void {
    this.stamped_.length = 0;
    this.interval_ = kFirstInterval;
    this.jitter_ = 0;
    this.lastArrival_ = -Infinity;
  }

  push(frame: FrameView, receivedAt: number): void {
    const last = this.stamped_[this.stamped_.length - 1];
    const gap = receivedAt - this.lastArrival_;
    this.lastArrival_ = receivedAt;
    let due = receivedAt;
    if (last && gap < kBreak) {
      this.interval_ += 0.08 * (gap - this.interval_);
      const expected = last.due + this.interval_;
      const late = receivedAt - expected;
      this.jitter_ += 0.1 * (Math.min(40, Math.abs(late)) - this.jitter_);
      // A slow pull towards the arrivals keeps motion even while the interval settles.
      due = Math.abs(late) > kBreak ? receivedAt : expected + 0.15 * late;
      if (due <= last.due) due = last.due + 0.5;
    }
    this.stamped_.push({ frame, due });
    if (this.stamped_.length > 8) this.stamped_.shift();
  }

  /** What to show at `now` [ms]; null before the first frame. */
  sample(now: number): FrameBlend | null {
    const stamped = this.stamped_;
    const last = stamped[stamped.length - 1];
    if (!last) return null;
    const time = now - this.delay;
    let index = stamped.length - 1;
    while (index > 0 && (stamped[index]?.due ?? 0) > time) --index;
    const from = stamped[index] ?? last;
    const to = stamped[index + 1];
    if (!to) return { from: from.frame, to: from.frame, alpha: 0 };
    const alpha = Math.min(1, Math.max(0, (time - from.due) / (to.due - from.due)));
    return { from: from.frame, to: to.frame, alpha };
  }
}
