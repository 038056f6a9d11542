// Chooses the level of detail of each character by its size on the screen, within a number of triangles that suits the
// canvas; characters out of view are hidden.

import type { CameraController } from '../camera/camera_controller';

export const kHidden = 0;
export const kSpeck = 1;
export const kTiny = 2;
export const kFar = 3;
export const kNear = 4;

/** Triangles of a body by level, a fine one with the coarse one that throws its shadow. */
export const kTriangles = { speck: 36, tiny: 68, far: 360, near: 2460 } as const;

/** Most triangles of the crowd for each CSS px of the canvas. */
const kPerPixel = 1.75;
/** A level takes at most this share of the triangles that are left, so that some are left for the next one. */
const kShare = 0.65;

/** Each level but the lowest, from the finest on: least size of a metre [CSS px], most characters. */
const kLevels = [
  { pixels: 13, most: 250, triangles: kTriangles.near, share: kShare },
  { pixels: 5, most: 1500, triangles: kTriangles.far, share: kShare },
  { pixels: 3, most: Infinity, triangles: kTriangles.tiny, share: 1 },
];

/** The limit changes by so much from picture to picture, and who has a level keeps it until it is so much smaller. */
const kStep = 1.06;
/** Reach of a figure around its position, with the longest shadow that may fall into view [m]. */
const kMargin = 3;

export class LevelOfDetail {
  /** Of each level from the finest on: least size in px, which rises and falls so that not too many characters pass. */
  private readonly least_ = Float64Array.from(kLevels, ({ pixels }) => pixels);
  /** Who passed in this picture, and who would also pass if the limit were one step lower. */
  private readonly passed_ = new Uint32Array(kLevels.length);
  private readonly nearly_ = new Uint32Array(kLevels.length);
  /** Level of each character in the last picture. */
  private had_ = new Uint8Array(0);
  private inView_ = 0;
  private readonly eye_ = new Float64Array(3);
  private readonly forward_ = new Float64Array(3);
  private readonly right_ = new Float64Array(2);
  private readonly up_ = new Float64Array(3);
  private tanX_ = 1;
  private tanY_ = 1;
  private scale_ = 1;

  /** Begins a picture of so many characters. */
  begin(camera: CameraController, count: number): void {
    if (this.had_.length !== count) this.had_ = new Uint8Array(count);
    this.allot(kPerPixel * camera.width * camera.height);
    this.inView_ = 0;
    const { eye, forward, right, up } = camera.basis();
    this.eye_.set(eye);
    this.forward_.set(forward);
    this.right_[0] = right[0];
    this.right_[1] = right[1];
    this.up_.set(up);
    this.tanY_ = Math.tan(camera.fieldOfView / 2);
    this.tanX_ = (this.tanY_ * camera.width) / camera.height;
    this.scale_ = camera.height / (2 * this.tanY_);
  }

  /** Device-independent px of a metre at the distance of one metre. */
  get scale(): number {
    return this.scale_;
  }

  /** Level of the character `i`, which is at (x, y). */
  levelAt(i: number, x: number, y: number): number {
    const { eye_: eye, forward_: forward, right_: right, up_: up } = this;
    const dx = x - eye[0]!,
      dy = y - eye[1]!,
      dz = 0.9 - eye[2]!;
    const depth = dx * forward[0]! + dy * forward[1]! + dz * forward[2]!;
    const across = Math.abs(dx * right[0]! + dy * right[1]!);
    const high = Math.abs(dx * up[0]! + dy * up[1]! + dz * up[2]!);
    if (depth < 0.1 || across > depth * this.tanX_ + kMargin || high > depth * this.tanY_ + kMargin) return kHidden;
    this.inView_ += 1;
    return (this.had_[i] = this.levelOf(this.scale_ / depth, this.had_[i]!));
  }

  private levelOf(pixels: number, had: number): number {
    const { least_: least } = this;
    for (let k = 0; k < kLevels.length; ++k) {
      const size = had >= kNear - k ? pixels * kStep : pixels;
      if (size >= least[k]!) {
        this.passed_[k]! += 1;
        return kNear - k;
      }
      if (size * kStep >= least[k]!) this.nearly_[k]! += 1;
    }
    return kSpeck;
  }

  /** Divides the triangles that the lowest level leaves, by who was in view in the last picture. */
  private allot(all: number): void {
    let left = Math.max(0, all - kTriangles.speck * this.inView_);
    kLevels.forEach(({ pixels, most, triangles, share }, k) => {
      const cost = triangles - kTriangles.speck;
      const room = Math.min(most, Math.floor((share * left) / cost));
      const passed = this.passed_[k]!;
      if (passed > room) this.least_[k]! *= kStep;
      else if (passed + this.nearly_[k]! <= room) this.least_[k] = Math.max(pixels, this.least_[k]! / kStep);
      left = Math.max(0, left - passed * cost);
    });
    this.passed_.fill(0);
    this.nearly_.fill(0);
  }
}
