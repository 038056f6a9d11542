// The part of the screen that marks need. Where a processor draws the page, every pixel of a layer over the scene costs
import type { ScreenPoint } from '../../model/plane';
// time with every picture, whether there is something on it or not.

/** A rectangle of the screen [CSS px]. */
export interface MarkBounds {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Room for what is drawn round a point: a ring, a handle, the overshoot of a smooth path [px]. */
const kRoom = 44;
/** Frames end on multiples of this, so that they stand still while marks move a little [px]. */
const kGrain = 64;
/** A frame is kept until it is this much larger than needed. */
const kSlack = 2.5;

/** Grows with points; says what frame holds them. */
export class MarkExtent {
  private left_ = Infinity;
  private top_ = Infinity;
  private right_ = -Infinity;
  private bottom_ = -Infinity;

  add(at: ScreenPoint): void {
    if (!Number.isFinite(at.x) || !Number.isFinite(at.y)) return;
    this.left_ = Math.min(this.left_, at.x);
    this.top_ = Math.min(this.top_, at.y);
    this.right_ = Math.max(this.right_, at.x);
    this.bottom_ = Math.max(this.bottom_, at.y);
  }

  /** The frame for a screen of this size: `kept` where that still serves; null where nothing is on the screen. */
  bounds(width: number, height: number, kept: MarkBounds | null): MarkBounds | null {
    const x = Math.max(0, Math.floor((this.left_ - kRoom) / kGrain) * kGrain);
    const y = Math.max(0, Math.floor((this.top_ - kRoom) / kGrain) * kGrain);
    const right = Math.min(width, Math.ceil((this.right_ + kRoom) / kGrain) * kGrain);
    const bottom = Math.min(height, Math.ceil((this.bottom_ + kRoom) / kGrain) * kGrain);
    if (!(right > x) || !(bottom > y)) return null;
    const needed = { x, y, width: right - x, height: bottom - y };
    return kept && holds(kept, needed) && fits(kept, width, height) && area(kept) <= kSlack * area(needed)
      ? kept
      : needed;
  }
}

function area(frame: MarkBounds): number {
  return frame.width * frame.height;
}

function holds(outer: MarkBounds, inner: MarkBounds): boolean {
  return (
    outer.x <= inner.x &&
    outer.y <= inner.y &&
    outer.x + outer.width >= inner.x + inner.width &&
    outer.y + outer.height >= inner.y + inner.height
  );
}

function fits(frame: MarkBounds, width: number, height: number): boolean {
  return frame.x + frame.width <= width && frame.y + frame.height <= height;
}
