// Who is in view, and who is large enough on the screen for the fine body.

import type { CameraController } from './camera_controller';

export const kHidden = 0;
export const kFar = 1;
export const kNear = 2;

/** A metre of a fine body takes at least so many px. */
const kFinePixels = 13;
/** Beyond this many fine bodies, only larger ones are fine. */
const kFineMost = 250;
/** The limit changes by so much from picture to picture. */
const kStep = 1.06;
/** A person's reach round its place, and the longest shadow that may fall into view [m]. */
const kMargin = 3;

export class LevelOfDetail {
  private least_ = kFinePixels;
  private fine_ = 0;
  /** Who would be fine too, were the limit one step lower. */
  private nearly_ = 0;
  private basis_: ReturnType<CameraController['basis']> | null = null;
  private tanX_ = 1;
  private tanY_ = 1;
  private scale_ = 1;

  /** Begins a frame; the limit follows how many were fine in the last. */
  begin(camera: CameraController): void {
    if (this.fine_ > kFineMost) this.least_ *= kStep;
    else if (this.fine_ + this.nearly_ <= kFineMost) this.least_ = Math.max(kFinePixels, this.least_ / kStep);
    this.fine_ = 0;
    this.nearly_ = 0;
    this.basis_ = camera.basis();
    this.tanY_ = Math.tan(camera.fieldOfView / 2);
    this.tanX_ = (this.tanY_ * camera.width) / camera.height;
    this.scale_ = camera.height / (2 * this.tanY_);
  }

  /** kHidden, kFar or kNear for someone at (x, y). */
  levelAt(x: number, y: number): number {
    const { eye, forward, right, up } = this.basis_!;
    const dx = x - eye[0], dy = y - eye[1], dz = 0.9 - eye[2];
    const depth = dx * forward[0] + dy * forward[1] + dz * forward[2];
    const across = Math.abs(dx * right[0] + dy * right[1]);
    const high = Math.abs(dx * up[0] + dy * up[1] + dz * up[2]);
    if (depth < 0.1 || across > depth * this.tanX_ + kMargin || high > depth * this.tanY_ + kMargin) return kHidden;
    const pixels = this.scale_ / depth;
    if (pixels < this.least_) {
      if (pixels * kStep >= this.least_) this.nearly_ += 1;
      return kFar;
    }
    this.fine_ += 1;
    return kNear;
  }
}
