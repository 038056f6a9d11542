// The characters as the picture shows them, between two frames. The graphics card interpolates positions; the page does
// so only on request, once per picture.

import { kRowFloats } from '../../model/studio_frame';
import { bodyOf, lookOf, sizeOf } from './look';
import { mix } from '../drawing/blend';
import type { FrameBlend } from '../../model/frame_timeline';
import type { FrameView, Numbers } from '../../model/frame_view';
import { StandingGrid } from '../../model/standing_grid';

/** A character that moves farther than this between two frames was put elsewhere; its path is not interpolated [m]. */
export const kJump = 1.5;

/** A body of another radius is drawn larger by this power of the ratio: twice as broad is 1.6 times as tall. */
const kScalePower = 0.7;
const kScaleLeast = 0.6;
const kScaleMost = 4;

export class CrowdState {
  count = 0;
  ids = new Uint32Array(0);
  group = new Uint16Array(0);
  /** Size of each character relative to the skeleton. */
  size = new Float32Array(0);
  /** How much larger than usual each body is drawn. */
  scale = new Float32Array(0);
  /** Radius of each body [m]. */
  radius = new Float32Array(0);
  /** Class of each character; 0 for none. */
  unitClass = new Uint8Array(0);
  /** Skin and hair as one number. */
  look = new Uint8Array(0);
  /** Grows when the list of members changes. */
  version = 0;
  private radiiTold_ = new Uint8Array(0);
  private usualRadius_ = 0.25;
  private bodyDraw_ = new Uint8Array(0);
  private blend_: FrameBlend | null = null;
  private positions_ = new Float32Array(0);
  private positionsStale_ = true;
  private readonly grid_ = new StandingGrid();
  private gridStale_ = true;

  clear(): void {
    this.setMembers([], []);
    this.blend_ = null;
  }

  /** Takes the ids and groups of the characters, their classes and radii [cm]; empty where all are as usual. */
  setMembers(ids: Numbers, group: Numbers, unitClass: Numbers = [], radius: Numbers = []): void {
    const count = ids.length;
    this.count = count;
    this.version += 1;
    this.ids = Uint32Array.from(ids);
    this.group = Uint16Array.from(group);
    [this.size, this.look, this.bodyDraw_] = [new Float32Array(count), new Uint8Array(count), new Uint8Array(count)];
    this.unitClass = Uint8Array.from({ length: count }, (_, i) => unitClass[i] ?? 0);
    this.radiiTold_ = Uint8Array.from(radius);
    this.setRadii();
    this.positions_ = new Float32Array(2 * count);
    for (let i = 0; i < count; ++i) {
      const id = this.ids[i]!;
      const { skin, hair } = lookOf(id);
      this.size[i] = sizeOf(id);
      this.look[i] = 5 * skin + hair;
      // Divisible by as many bodies as there may ever be.
      this.bodyDraw_[i] = bodyOf(id, 12);
    }
    this.positionsStale_ = this.gridStale_ = true;
  }

  /** What a body usually has [m]; true where that changes how somebody looks. */
  setUsualRadius(radius: number): boolean {
    if (radius === this.usualRadius_) return false;
    this.usualRadius_ = radius;
    this.setRadii();
    this.version += 1;
    return true;
  }

  private setRadii(): void {
    const usual = this.usualRadius_;
    this.radius = Float32Array.from({ length: this.count }, (_, i) => (this.radiiTold_[i] ?? 100 * usual) / 100);
    this.scale = this.radius.map((own) => Math.min(kScaleMost, Math.max(kScaleLeast, (own / usual) ** kScalePower)));
  }

  /** Takes the ids and groups of a frame; true where they differ from those before. */
  takeMembers(frame: FrameView): boolean {
    if (frame.ids.length > 0 && !this.hasMembersOf(frame)) {
      this.setMembers(frame.ids, frame.group, frame.unitClass, frame.radius);
      return true;
    }
    if (frame.x.length > 0 || this.count === 0) return false;
    this.setMembers([], []);
    return true;
  }

  private hasMembersOf({ ids, group, unitClass, radius }: FrameView): boolean {
    const same = sameNumbers(ids, this.ids, group, this.group) && sameNumbers(radius, this.radiiTold_, [], []);
    return (
      same && (unitClass.length > 0 ? sameNumbers(unitClass, this.unitClass, [], []) : !this.unitClass.some(Boolean))
    );
  }

  /** Index of the group of the character with this id; undefined where there is none. */
  groupOf(id: number): number | undefined {
    const index = this.ids.indexOf(id);
    return index < 0 ? undefined : (this.group[index] ?? -1);
  }

  /** Which of `bodies` (1, 2, 3, 4, 6) a character has. */
  body(i: number, bodies: number): number {
    return this.bodyDraw_[i]! % bodies;
  }

  /** Sets the moment between two frames. */
  update(blend: FrameBlend): void {
    this.gridStale_ ||= blend.to !== this.blend_?.to;
    this.blend_ = blend;
    this.positionsStale_ = true;
  }

  /** x, y of all characters at this moment [m]. */
  get positions(): Float32Array {
    if (this.positionsStale_ && this.blend_) this.mixPositions(this.blend_);
    this.positionsStale_ = false;
    return this.positions_;
  }

  /** True where somebody is within `reach` of a spot, in the newer of the two frames [m]. */
  someoneNear(x: number, y: number, reach: number): boolean {
    if (this.gridStale_ && this.blend_)
      this.grid_.fill(this.blend_.to.rows, kRowFloats, Math.min(this.count, this.blend_.to.x.length));
    this.gridStale_ = false;
    return this.grid_.someoneNear(x, y, reach);
  }

  private mixPositions({ from, to, alpha }: FrameBlend): void {
    const count = Math.min(this.count, to.x.length);
    const same = from.x.length === to.x.length;
    for (let i = 0; i < count; ++i) {
      const bx = to.x[i]!,
        by = to.y[i]!;
      const ax = same ? from.x[i]! : bx,
        ay = same ? from.y[i]! : by;
      const t = Math.hypot(bx - ax, by - ay) > kJump ? 1 : alpha;
      this.positions_[2 * i] = mix(ax, bx, t);
      this.positions_[2 * i + 1] = mix(ay, by, t);
    }
  }
}

function sameNumbers(a: Numbers, b: Numbers, c: Numbers, d: Numbers): boolean {
  if (a.length !== b.length || c.length !== d.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i] || c[i] !== d[i]) return false;
  return true;
}
