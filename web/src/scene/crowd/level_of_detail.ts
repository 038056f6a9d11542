// Chooses the level of detail of each character by its size on the screen; characters out of view are hidden.

import type { CameraController } from '../camera/camera_controller';

export const kHidden = 0;
export const kTiny = 1;
export const kFar = 2;
export const kNear = 3;

/** The limit changes by so much from picture to picture. */
const kStep = 1.06;
/** Reach of a figure around its position, with the longest shadow that may fall into view [m]. */
const kMargin = 3;

/** A least size in px for the better level. It rises and falls so that at most `most_` characters pass. */
class Limit {
  least: number;
  private count_ = 0;
  /** Number of characters that would also pass if the limit were one step lower. */
  private nearly_ = 0;

  constructor(
    private readonly lowest_: number,
    private readonly most_: number,
  ) {
    this.least = lowest_;
  }

  begin(): void {
    if (this.count_ > this.most_) this.least *= kStep;
    else if (this.count_ + this.nearly_ <= this.most_) this.least = Math.max(this.lowest_, this.least / kStep);
    this.count_ = this.nearly_ = 0;
  }

  passes(pixels: number): boolean {
    if (pixels >= this.least) {
      this.count_ += 1;
      return true;
    }
    if (pixels * kStep >= this.least) this.nearly_ += 1;
    return false;
  }
}

/** Least size of a metre [px], and most characters, of the fine and of the coarse level. */
const kFine = { pixels: 13, most: 250 };
const kCoarse = { pixels: 5, most: 1500 };

export class LevelOfDetail {
  private readonly fine_ = new Limit(kFine.pixels, kFine.most);
  private readonly coarse_ = new Limit(kCoarse.pixels, kCoarse.most);
  private readonly eye_ = new Float64Array(3);
  private readonly forward_ = new Float64Array(3);
  private readonly right_ = new Float64Array(2);
  private readonly up_ = new Float64Array(3);
  private tanX_ = 1;
  private tanY_ = 1;
  private scale_ = 1;

  /** Begins a picture. */
  begin(camera: CameraController): void {
    this.fine_.begin();
    this.coarse_.begin();
    const { eye, forward, right, up } = camera.basis();
    this.eye_.set(eye);
    this.forward_.set(forward);
    this.right_.set([right[0], right[1]]);
    this.up_.set(up);
    this.tanY_ = Math.tan(camera.fieldOfView / 2);
    this.tanX_ = (this.tanY_ * camera.width) / camera.height;
    this.scale_ = camera.height / (2 * this.tanY_);
  }

  /** kHidden, kTiny, kFar or kNear for someone at (x, y). */
  levelAt(x: number, y: number): number {
    const { eye_: eye, forward_: forward, right_: right, up_: up } = this;
    const dx = x - eye[0]!,
      dy = y - eye[1]!,
      dz = 0.9 - eye[2]!;
    const depth = dx * forward[0]! + dy * forward[1]! + dz * forward[2]!;
    const across = Math.abs(dx * right[0]! + dy * right[1]!);
    const high = Math.abs(dx * up[0]! + dy * up[1]! + dz * up[2]!);
    if (depth < 0.1 || across > depth * this.tanX_ + kMargin || high > depth * this.tanY_ + kMargin) return kHidden;
    const pixels = this.scale_ / depth;
    if (this.fine_.passes(pixels)) return kNear;
    return this.coarse_.passes(pixels) ? kFar : kTiny;
  }
}
