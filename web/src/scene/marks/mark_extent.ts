// The part of the screen that marks need. Where a processor draws the page, every pixel of a layer over the scene costs
// time with every picture, whether there is something on it or not.

import type { ScreenPoint } from '../../model/plane';

/** A rectangle of the screen [CSS px]. */
export interface MarkBounds {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Margin for what is drawn around a point: a ring, a handle, the overshoot of a smooth path [px]. */
const kMargin = 44;
/** Bounds end on multiples of this, so that they stay the same while marks move a little [px]. */
const kGrain = 64;
/** Bounds are reused until they are this many times larger than needed. */
const kSlack = 2.5;

/** Collects points and returns bounds that hold them. */
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

  /** The bounds on a screen of this size: `last` where it still serves; null where nothing is on the screen. */
  bounds(width: number, height: number, last: MarkBounds | null): MarkBounds | null {
    const x = Math.max(0, Math.floor((this.left_ - kMargin) / kGrain) * kGrain);
    const y = Math.max(0, Math.floor((this.top_ - kMargin) / kGrain) * kGrain);
    const right = Math.min(width, Math.ceil((this.right_ + kMargin) / kGrain) * kGrain);
    const bottom = Math.min(height, Math.ceil((this.bottom_ + kMargin) / kGrain) * kGrain);
    if (!(right > x) || !(bottom > y)) return null;
    const needed = { x, y, width: right - x, height: bottom - y };
    return last && holds(last, needed) && fits(last, width, height) && area(last) <= kSlack * area(needed)
      ? last
      : needed;
  }
}

function area(bounds: MarkBounds): number {
  return bounds.width * bounds.height;
}

function holds(outer: MarkBounds, inner: MarkBounds): boolean {
  return (
    outer.x <= inner.x &&
    outer.y <= inner.y &&
    outer.x + outer.width >= inner.x + inner.width &&
    outer.y + outer.height >= inner.y + inner.height
  );
}

function fits(bounds: MarkBounds, width: number, height: number): boolean {
  return bounds.x + bounds.width <= width && bounds.y + bounds.height <= height;
}
