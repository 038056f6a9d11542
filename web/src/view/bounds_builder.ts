// The box round scattered points, with some room about them.

import type { GroundPoint } from './camera_types';
import type { Numbers } from './frame_types';

/** Room about the points: a part of their extent, and at least so much [m]. */
const kRoomPart = 0.12;
const kRoomLeast = 2.5;

export class BoundsBuilder {
  private minX_ = Infinity;
  private minY_ = Infinity;
  private maxX_ = -Infinity;
  private maxY_ = -Infinity;

  add(x: number, y: number): void {
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    this.minX_ = Math.min(this.minX_, x);
    this.minY_ = Math.min(this.minY_, y);
    this.maxX_ = Math.max(this.maxX_, x);
    this.maxY_ = Math.max(this.maxY_, y);
  }

  /** x, y pairs. */
  addAll(points: Numbers): void {
    for (let i = 0; i + 1 < points.length; i += 2) this.add(points[i] ?? 0, points[i + 1] ?? 0);
  }

  /** Four corners; none where nothing was added. */
  corners(): GroundPoint[] {
    if (this.minX_ > this.maxX_) return [];
    const roomX = Math.max(kRoomLeast, kRoomPart * (this.maxX_ - this.minX_));
    const roomY = Math.max(kRoomLeast, kRoomPart * (this.maxY_ - this.minY_));
    const [left, right] = [this.minX_ - roomX, this.maxX_ + roomX];
    const [low, high] = [this.minY_ - roomY, this.maxY_ + roomY];
    return [{ x: left, y: low }, { x: right, y: low }, { x: right, y: high }, { x: left, y: high }];
  }
}
