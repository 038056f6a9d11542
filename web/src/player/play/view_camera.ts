// The camera: it looks at a point of the ground from a direction and a distance.

import type { CameraHint } from '../file/player_file';

export type Triple = readonly [number, number, number];
/** 16 numbers, by columns. */
export type Matrix = Float32Array;

const kFilled = 0.94;
const kLeastDistance = 4;
const kMostDistance = 3000;
const kLeastPitch = 0.12;
const kMostPitch = 1.55;
/** Height of a standing character that is kept in view [m]. */
const kSeen = 1.8;

/** Cells of a metre side by side. */
const kRow = 1 << 22;

/** Points of the ground that are to be seen, thinned out. */
export class Extent {
  private readonly cells_ = new Map<number, readonly [number, number]>();

  add(x: number, y: number): void {
    const key = Math.round(x) + kRow * Math.round(y);
    if (!this.cells_.has(key)) this.cells_.set(key, [x, y]);
  }

  get points(): Iterable<readonly [number, number]> {
    return this.cells_.values();
  }

  get empty(): boolean {
    return this.cells_.size === 0;
  }
}

/** The point of the ground that is looked at, and from how far [m]. */
export interface Aim {
  readonly x: number;
  readonly y: number;
  readonly distance: number;
}

export class ViewCamera {
  turn: number;
  pitch: number;
  aspect = 16 / 9;
  /** Share of the picture's height that controls cover below. */
  covered = 0;
  private aim_: Aim = { x: 0, y: 0, distance: 40 };
  /** What the visitor did: moved over the ground [m], zoomed. */
  private moved_: readonly [number, number] = [0, 0];
  private zoomed_ = 1;
  private readonly angle_: number;

  constructor(private readonly hint_: CameraHint) {
    this.turn = hint_.turn;
    this.pitch = hint_.pitch;
    this.angle_ = hint_.angle;
  }

  get target(): Triple {
    return [this.aim_.x + this.moved_[0], this.aim_.y + this.moved_[1], 0];
  }

  get distance(): number {
    return Math.min(kMostDistance, Math.max(kLeastDistance, this.aim_.distance * this.zoomed_));
  }

  /** Looks elsewhere; what the visitor did stays. */
  aim(at: Aim): void {
    this.aim_ = at;
  }

  /** Takes back what the visitor did. */
  reset(): void {
    this.turn = this.hint_.turn;
    this.pitch = this.hint_.pitch;
    this.moved_ = [0, 0];
    this.zoomed_ = 1;
  }

  get changed(): boolean {
    const still = this.turn === this.hint_.turn && this.pitch === this.hint_.pitch;
    return !still || this.zoomed_ !== 1 || this.moved_[0] !== 0 || this.moved_[1] !== 0;
  }

  get right(): Triple {
    return [Math.cos(this.turn), Math.sin(this.turn), 0];
  }

  get forward(): Triple {
    const [s, c, p] = [Math.sin(this.turn), Math.cos(this.turn), Math.cos(this.pitch)];
    return [-s * p, c * p, -Math.sin(this.pitch)];
  }

  get up(): Triple {
    const [s, c, p] = [Math.sin(this.turn), Math.cos(this.turn), Math.sin(this.pitch)];
    return [-s * p, c * p, Math.cos(this.pitch)];
  }

  get eye(): Triple {
    const f = this.forward;
    return [0, 1, 2].map((k) => this.target[k]! - this.distance * f[k]!) as unknown as Triple;
  }

  /** Tangent of half the angle of view, upright. */
  get slope(): number {
    return Math.tan(this.angle_ / 2);
  }

  /** Where to look at from the direction of the file, as near as all points stay in view; null without points. */
  fit(extent: Extent): Aim | null {
    if (extent.empty) return null;
    const { right, up, forward } = new ViewCamera(this.hint_);
    // Slopes of the sides of the view, above, below, and beside.
    const above = kFilled * this.slope;
    const below = (kFilled - 2 * this.covered) * this.slope;
    const across = this.aspect * above;
    const reach = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity, near: Infinity };
    for (const [x, y] of extent.points) {
      for (const z of [0, kSeen]) {
        const [f, r, u] = [forward, right, up].map((a) => a[0] * x + a[1] * y + a[2] * z) as [number, number, number];
        reach.left = Math.min(reach.left, r + across * f);
        reach.right = Math.max(reach.right, r - across * f);
        reach.low = Math.min(reach.low, u + below * f);
        reach.high = Math.max(reach.high, u - above * f);
        reach.near = Math.min(reach.near, f);
      }
    }
    const f = Math.min(
      (reach.left - reach.right) / (2 * across),
      (reach.low - reach.high) / (above + below),
      reach.near - 2 * kLeastDistance,
    );
    const [r, u] = [(reach.left + reach.right) / 2, (reach.low + reach.high + (above - below) * f) / 2];
    const eye = [0, 1, 2].map((k) => f * forward[k]! + r * right[k]! + u * up[k]!) as [number, number, number];
    const distance = eye[2] / -forward[2];
    return { x: eye[0] + distance * forward[0], y: eye[1] + distance * forward[1], distance };
  }

  /** Turns about the point looked at [rad]. */
  orbit(turn: number, pitch: number): void {
    this.turn += turn;
    this.pitch = Math.min(kMostPitch, Math.max(kLeastPitch, this.pitch + pitch));
  }

  zoom(factor: number): void {
    const wanted = this.distance * factor;
    this.zoomed_ = Math.min(kMostDistance, Math.max(kLeastDistance, wanted)) / this.aim_.distance;
  }

  /** Moves over the ground by shares of the picture's height. */
  pan(right: number, up: number): void {
    const size = 2 * this.slope * this.distance;
    const [rx, ry] = this.right;
    const [across, along] = [right * size, (up * size) / Math.max(0.3, Math.sin(this.pitch))];
    this.moved_ = [this.moved_[0] + across * rx - along * ry, this.moved_[1] + across * ry + along * rx];
  }

  /** From the world to the picture. */
  matrix(): Matrix {
    const { right, up, forward, eye } = this;
    const near = Math.max(0.2, this.distance * 0.05);
    const far = this.distance * 6 + 500;
    const [sx, sy] = [1 / (this.slope * this.aspect), 1 / this.slope];
    const [a, b] = [(far + near) / (far - near), (-2 * far * near) / (far - near)];
    const along = (v: Triple): number => v[0] * eye[0] + v[1] * eye[1] + v[2] * eye[2];
    const m = new Float32Array(16);
    for (let k = 0; k < 3; ++k) {
      m[4 * k] = sx * right[k]!;
      m[4 * k + 1] = sy * up[k]!;
      m[4 * k + 2] = a * forward[k]!;
      m[4 * k + 3] = forward[k]!;
    }
    m[12] = -sx * along(right);
    m[13] = -sy * along(up);
    m[14] = -a * along(forward) + b;
    m[15] = -along(forward);
    return m;
  }

  /** Where a point is seen: from -1 to 1, right and up. */
  screen(x: number, y: number, z: number): readonly [number, number] {
    const m = this.matrix();
    const row = (k: number): number => m[k]! * x + m[4 + k]! * y + m[8 + k]! * z + m[12 + k]!;
    return [row(0) / row(3), row(1) / row(3)];
  }

  /** The point of the ground that is seen there: from -1 to 1, right and up; null above the horizon. */
  ground(x: number, y: number): readonly [number, number] | null {
    const { right, up, forward, eye } = this;
    const ray = [0, 1, 2].map((k) => forward[k]! + x * this.slope * this.aspect * right[k]! + y * this.slope * up[k]!);
    if (ray[2]! > -1e-3) return null;
    const t = eye[2] / -ray[2]!;
    return [eye[0] + t * ray[0]!, eye[1] + t * ray[1]!];
  }
}
