// The camera's pose, and the projection between screen and ground. It is independent of three.js: the stage copies its
// pose.

import type { CameraControls, CameraPose, GroundSight, Padding, SeenGround } from './camera_controls';
import { basisOf, groundMatrix, type Basis } from './ground_matrix';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import type { SceneBox } from '../../protocol/messages';

const kDegree = Math.PI / 180;
/** Field of view from straight above. */
const kLongLens = 8 * kDegree;
/** Least while somebody steers, who needs ground under every finger, and while a take is watched. */
export const kSteeredPitch = 25 * kDegree;
export const kWatchedPitch = 7 * kDegree;
const kPitchMax = 85 * kDegree;
/** Seen from above. */
const kPitchTop = 89.5 * kDegree;
/** Without perspective the lens is this narrow, and the eye as much farther away. */
const kFlatLens = 2 * kDegree;
/** [m] */
const kDistanceMin = 5;

export class CameraController implements CameraControls, GroundSight {
  private pose_: CameraPose = { targetX: 0, targetY: 0, distance: 40, turn: 0.33, pitch: 46 * kDegree };
  private width_ = 1;
  private height_ = 1;
  private fieldOfView_ = 24 * kDegree;
  /** Of the world [m]. */
  private diagonal_ = 125;
  private bounds_ = { minX: -1e6, minY: -1e6, maxX: 1e6, maxY: 1e6 };
  /** The view from straight above that is kept; null where the camera moves. */
  private down_: { readonly box: SceneBox; readonly padding: Padding } | null = null;
  flattest = kSteeredPitch;
  private top_ = false;
  private flat_ = false;
  private glide_: { from: CameraPose; to: CameraPose; start: number; duration: number } | null = null;
  private placed_ = false;
  /** The axes of the last pose that somebody asked for. */
  private basis_ = { of: { ...this.pose_ }, basis: basisOf(this.pose_) };

  get pose(): Readonly<CameraPose> {
    return this.pose_;
  }

  /** Vertical [rad]. */
  get fieldOfView(): number {
    return this.fieldOfView_;
  }

  get width(): number {
    return this.width_;
  }

  get height(): number {
    return this.height_;
  }

  /** Size of the canvas [CSS px]; the lens follows it. */
  resize(width: number, height: number): void {
    this.width_ = Math.max(1, width);
    this.height_ = Math.max(1, height);
    this.setLens();
    if (this.down_) this.straightDown(this.down_.box, this.down_.padding);
  }

  /** Straight from above. */
  get top(): boolean {
    return this.top_;
  }

  /** Looks straight down, or as a scene opens. */
  setTop(top: boolean): void {
    this.glide_ = null;
    this.top_ = top;
    this.pose_.pitch = top ? kPitchTop : this.openPitch();
  }

  /** Without perspective: what is far is drawn as large as what is near. */
  get flat(): boolean {
    return this.flat_;
  }

  setFlat(flat: boolean): void {
    this.flat_ = flat;
    this.setLens();
  }

  /** The middle of the view keeps its scale. */
  private setLens(): void {
    this.glide_ = null;
    const before = Math.tan(this.fieldOfView_ / 2);
    const usual = Math.min(this.width_, this.height_) < 520 ? 28 : 24;
    this.fieldOfView_ = this.flat_ ? kFlatLens : usual * kDegree;
    // A window of another size keeps its distance.
    const ratio = before / Math.tan(this.fieldOfView_ / 2);
    if (ratio > 2 || ratio < 0.5) this.pose_.distance = this.clampDistance(this.pose_.distance * ratio);
  }

  private openPitch(): number {
    return (this.height_ > this.width_ ? 50 : 46) * kDegree;
  }

  /** From straight above, all of the box between the panels, and so from now on: nothing moves this camera. */
  straightDown(box: SceneBox, padding: Padding): void {
    this.glide_ = null;
    this.down_ = { box, padding };
    const width = Math.max(80, this.width_ - padding.left - padding.right);
    const height = Math.max(80, this.height_ - padding.top - padding.bottom);
    const [x, y] = [box.max[0] - box.min[0], box.max[1] - box.min[1]];
    const [lying, standing] = [Math.min(width / x, height / y), Math.min(width / y, height / x)];
    // On a high window the world stands on its left side.
    const turn = standing > 1.2 * lying ? -Math.PI / 2 : 0;
    const scale = turn === 0 ? lying : standing;
    // A long lens: at the rim a head stands hardly beside its feet.
    this.fieldOfView_ = kLongLens;
    const distance = this.height_ / (2 * Math.tan(kLongLens / 2) * scale);
    this.pose_ = { targetX: 0, targetY: 0, distance, turn, pitch: Math.PI / 2 };
    const { right, up } = this.basis();
    const across = (padding.left + width / 2 - this.width_ / 2) / scale;
    const along = (this.height_ / 2 - padding.top - height / 2) / scale;
    this.pose_.targetX = (box.min[0] + box.max[0]) / 2 - right[0] * across - up[0] * along;
    this.pose_.targetY = (box.min[1] + box.max[1]) / 2 - right[1] * across - up[1] * along;
  }

  /** As straightDown() before, between other panels. */
  keepDown(padding: Padding): void {
    if (this.down_) this.straightDown(this.down_.box, padding);
  }

  seenGround(): SeenGround {
    const lens = this.height_ / (2 * Math.tan(this.fieldOfView_ / 2));
    return {
      matrix: groundMatrix(this.basis(), lens, this.width_, this.height_),
      width: this.width_,
      height: this.height_,
    };
  }

  /** True once the view has been brought to a pose since the scene opened. */
  get placed(): boolean {
    return this.placed_;
  }

  /** The view as a scene opens, before a fit. */
  open(): void {
    if (this.down_) return this.straightDown(this.down_.box, this.down_.padding);
    this.glide_ = null;
    this.placed_ = false;
    this.pose_.turn = 0.33;
    this.pose_.pitch = this.top_ ? kPitchTop : this.openPitch();
  }

  /** Keeps the target in the world and the eye at a useful height. */
  setWorld(minX: number, minY: number, maxX: number, maxY: number): void {
    this.bounds_ = { minX, minY, maxX, maxY };
    this.diagonal_ = Math.hypot(maxX - minX, maxY - minY);
    this.limit();
  }

  setPose(pose: CameraPose): void {
    this.pose_ = { ...pose };
    this.limit();
  }

  pan(from: ScreenPoint, to: ScreenPoint): void {
    const before = this.screenToGround(from);
    const after = this.screenToGround(to);
    if (before && after) this.shift(before.x - after.x, before.y - after.y);
  }

  panBy(dx: number, dy: number): void {
    const middle = { x: this.width_ / 2, y: this.height_ / 2 };
    this.pan(middle, { x: middle.x + dx, y: middle.y + dy });
  }

  pinch(before: readonly [ScreenPoint, ScreenPoint], after: readonly [ScreenPoint, ScreenPoint]): void {
    const a = this.screenToGround(before[0]);
    const b = this.screenToGround(before[1]);
    if (this.down_ || !a || !b || Math.hypot(b.x - a.x, b.y - a.y) < 1e-6) return;
    // Turn, distance and target depend on each other through perspective, so the similarity is found by iteration.
    for (let round = 0; round < 24; ++round) {
      const c = this.screenToGround(after[0]);
      const d = this.screenToGround(after[1]);
      if (!c || !d) return;
      const wanted = Math.hypot(b.x - a.x, b.y - a.y);
      const found = Math.hypot(d.x - c.x, d.y - c.y);
      if (found < 1e-6) return;
      let angle = Math.atan2(b.y - a.y, b.x - a.x) - Math.atan2(d.y - c.y, d.x - c.x);
      angle = Math.atan2(Math.sin(angle), Math.cos(angle));
      this.pose_.turn += angle;
      this.pose_.distance = this.clampDistance(this.pose_.distance * Math.min(2, Math.max(0.5, wanted / found)));
      const e = this.screenToGround(after[0]);
      const f = this.screenToGround(after[1]);
      if (!e || !f) return;
      this.shift((a.x + b.x - e.x - f.x) / 2, (a.y + b.y - e.y - f.y) / 2);
      if (Math.abs(angle) < 1e-9 && Math.abs(wanted / found - 1) < 1e-9) return;
    }
  }

  zoomAt(at: ScreenPoint, factor: number): void {
    if (this.down_) return;
    const before = this.screenToGround(at);
    this.glide_ = null;
    this.pose_.distance = this.clampDistance(this.pose_.distance / factor);
    const after = this.screenToGround(at);
    if (before && after) this.shift(before.x - after.x, before.y - after.y);
  }

  orbit(turn: number, tilt: number): void {
    if (this.down_) return;
    this.glide_ = null;
    this.pose_.turn += turn;
    if (this.top_ && tilt === 0) return;
    this.top_ = false;
    this.pose_.pitch = Math.min(kPitchMax, Math.max(this.flattest, this.pose_.pitch + tilt));
  }

  fit(points: readonly GroundPoint[], padding: Padding): void {
    if (points.length === 0 || this.down_) return;
    this.glide_ = null;
    const left = padding.left;
    const top = padding.top;
    const width = Math.max(80, this.width_ - padding.left - padding.right);
    const height = Math.max(80, this.height_ - padding.top - padding.bottom);
    for (let round = 0; round < 16; ++round) {
      const box = this.screenBox(points);
      const ratio = Math.max((box.maxX - box.minX) / width, (box.maxY - box.minY) / height, 1e-3);
      this.pose_.distance = this.clampDistance(this.pose_.distance * Math.min(4, Math.max(0.25, ratio)));
      const moved = this.screenBox(points);
      this.pan(
        { x: (moved.minX + moved.maxX) / 2, y: (moved.minY + moved.maxY) / 2 },
        { x: left + width / 2, y: top + height / 2 },
      );
    }
  }

  /** The pose in which all points are shown between the panels; the camera stays as it is. */
  poseFor(points: readonly GroundPoint[], padding: Padding): CameraPose {
    const { pose_: before, glide_: glide } = this;
    this.pose_ = { ...before };
    this.fit(points, padding);
    const found = this.pose_;
    this.pose_ = before;
    this.glide_ = glide;
    return found;
  }

  /** Goes a share of the way to a pose; its turn and pitch do not matter. */
  approach({ targetX, targetY, distance }: CameraPose, share: number): void {
    this.glide_ = null;
    const { pose_: pose } = this;
    pose.targetX += share * (targetX - pose.targetX);
    pose.targetY += share * (targetY - pose.targetY);
    pose.distance *= (distance / pose.distance) ** share;
    this.limit();
  }

  /** Glides to a pose, turning the shorter way round. */
  glideToPose(pose: CameraPose, now: number, duration: number): void {
    this.placed_ = true;
    const from = { ...this.pose_ };
    const around = Math.atan2(Math.sin(pose.turn - from.turn), Math.cos(pose.turn - from.turn));
    this.top_ = pose.pitch > kPitchMax;
    this.setPose({ ...pose, turn: from.turn + around });
    this.glideFrom(from, now, duration);
  }

  /** As `fit`, but gliding there within `duration` [ms]. */
  glideFit(points: readonly GroundPoint[], padding: Padding, now: number, duration: number): void {
    const from = { ...this.pose_ };
    this.fit(points, padding);
    this.glideFrom(from, now, duration);
  }

  /** Glides until the point lies in the middle between the panels; distance, turn and pitch stay. */
  glideTo(point: GroundPoint, padding: Padding, now: number, duration: number): void {
    const from = { ...this.pose_ };
    const middle = this.screenToGround({
      x: (padding.left + this.width_ - padding.right) / 2,
      y: (padding.top + this.height_ - padding.bottom) / 2,
    });
    if (middle) this.shift(point.x - middle.x, point.y - middle.y);
    this.glideFrom(from, now, duration);
  }

  /** False during a glide. */
  get atRest(): boolean {
    return this.glide_ === null;
  }

  /** Moves along a glide; true while it lasts. */
  update(now: number): boolean {
    const glide = this.glide_;
    if (!glide) return false;
    const t = Math.min(1, Math.max(0, (now - glide.start) / glide.duration));
    const s = t * t * (3 - 2 * t);
    const mix = (a: number, b: number): number => a + (b - a) * s;
    this.pose_.targetX = mix(glide.from.targetX, glide.to.targetX);
    this.pose_.targetY = mix(glide.from.targetY, glide.to.targetY);
    this.pose_.distance = mix(glide.from.distance, glide.to.distance);
    this.pose_.turn = mix(glide.from.turn, glide.to.turn);
    this.pose_.pitch = mix(glide.from.pitch, glide.to.pitch);
    if (t >= 1) this.glide_ = null;
    return true;
  }

  /** Null above the horizon. */
  screenToGround(at: ScreenPoint): GroundPoint | null {
    const { eye, forward, right, up } = this.basis();
    const tangent = Math.tan(this.fieldOfView_ / 2);
    const u = ((2 * at.x) / this.width_ - 1) * tangent * (this.width_ / this.height_);
    const v = (1 - (2 * at.y) / this.height_) * tangent;
    const dz = forward[2] + up[2] * v + right[2] * u;
    if (dz > -1e-4) return null;
    const t = -eye[2] / dz;
    return {
      x: eye[0] + t * (forward[0] + right[0] * u + up[0] * v),
      y: eye[1] + t * (forward[1] + right[1] * u + up[1] * v),
    };
  }

  /** A point `z` [m] above the ground on the screen. Points behind the eye land far outside. */
  worldToScreen(x: number, y: number, z = 0): ScreenPoint {
    const { eye, forward, right, up } = this.basis();
    const dx = x - eye[0];
    const dy = y - eye[1];
    const dz = z - eye[2];
    const depth = Math.max(1e-3, dx * forward[0] + dy * forward[1] + dz * forward[2]);
    const scale = this.height_ / (2 * Math.tan(this.fieldOfView_ / 2)) / depth;
    return {
      x: this.width_ / 2 + scale * (dx * right[0] + dy * right[1] + dz * right[2]),
      y: this.height_ / 2 - scale * (dx * up[0] + dy * up[1] + dz * up[2]),
    };
  }

  /** CSS px of a metre across the view at its middle. */
  pixelsPerMetre(): number {
    return this.height_ / (2 * Math.tan(this.fieldOfView_ / 2) * this.pose_.distance);
  }

  /** Eye and axes, all in world coordinates with z up. */
  basis(): Basis {
    const { of, basis } = this.basis_;
    const { targetX, targetY, distance, turn, pitch } = this.pose_;
    const moved = of.targetX !== targetX || of.targetY !== targetY || of.distance !== distance;
    if (!moved && of.turn === turn && of.pitch === pitch) return basis;
    this.basis_ = { of: { ...this.pose_ }, basis: basisOf(this.pose_) };
    return this.basis_.basis;
  }

  private screenBox(points: readonly GroundPoint[]): { minX: number; minY: number; maxX: number; maxY: number } {
    const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
    for (const point of points) {
      const at = this.worldToScreen(point.x, point.y);
      box.minX = Math.min(box.minX, at.x);
      box.minY = Math.min(box.minY, at.y);
      box.maxX = Math.max(box.maxX, at.x);
      box.maxY = Math.max(box.maxY, at.y);
    }
    return box;
  }

  /** From a pose to the one it has now. */
  private glideFrom(from: CameraPose, now: number, duration: number): void {
    if (duration <= 0 || this.down_) return;
    this.glide_ = { from, to: { ...this.pose_ }, start: now, duration };
    this.pose_ = { ...from };
  }

  private shift(dx: number, dy: number): void {
    if (this.down_) return;
    this.glide_ = null;
    this.pose_.targetX += dx;
    this.pose_.targetY += dy;
    this.limit();
  }

  private clampDistance(distance: number): number {
    const farther = this.flat_ ? Math.tan(12 * kDegree) / Math.tan(kFlatLens / 2) : 1;
    // The whole world is seen, in narrow windows as well.
    const across =
      2 * Math.tan((this.flat_ ? 24 * kDegree : this.fieldOfView_) / 2) * Math.min(1, this.width_ / this.height_);
    const most = Math.max(60, 3.2 * this.diagonal_, (1.5 * this.diagonal_) / across);
    return Math.min(farther * most, Math.max(farther * kDistanceMin, distance));
  }

  private limit(): void {
    if (this.down_) return;
    const { minX, minY, maxX, maxY } = this.bounds_;
    this.pose_.targetX = Math.min(maxX, Math.max(minX, this.pose_.targetX));
    this.pose_.targetY = Math.min(maxY, Math.max(minY, this.pose_.targetY));
    this.pose_.distance = this.clampDistance(this.pose_.distance);
    this.pose_.pitch = this.top_ ? kPitchTop : Math.min(kPitchMax, Math.max(this.flattest, this.pose_.pitch));
  }
}
