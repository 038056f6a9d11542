// Brings crowd and spots into view, and opens the view of a world.

import type { SceneFacts } from '../../protocol/scene';
import type { GroupView, Numbers } from '../../model/frame_view';
import type { GroundPoint } from '../../model/plane';
import { crowdOutline, kSpanLeast } from './bounds_builder';
import type { CameraController } from './camera_controller';
import type { Padding } from './camera_controls';
import { goals, kWiden, surroundings } from './opening';

/** Duration of a camera move to another view [ms]. */
const kGlide = 260;
/** Views are the same within this share of their distance. */
const kSame = 0.04;
/** A window narrower than this between its panels shows less of what stands about [CSS px]. */
const kNarrow = 420;
/** There it is drawn in, by one of these after the other [m], until people are large enough [CSS px per metre]. */
const kWidenNarrow = [kWiden, 4, 2] as const;
const kReadable = 14;

/** In the padding: above the ground that must be seen figures stand up, and at its sides there is a gap [CSS px]. */
export const kHeadroom = 44;
const kGap = 12;

/** Walls at the sides of a place reach so far beyond it on the screen [m]. */
const kWalls = 2;

export class ViewFitter {
  /** What panels cover. */
  padding: Padding = { top: 84, right: 24, bottom: 120, left: 24 };
  /** The next world opens with all of it in view. */
  whole = false;
  private scene_: SceneFacts | null = null;
  private opened_ = false;
  /** The last fit was to the crowd, and asks for the place next. */
  private fitted_ = false;

  constructor(private readonly camera_: CameraController) {}

  /** The world has changed: its box may have grown. */
  know(scene: SceneFacts): void {
    this.scene_ = scene;
    this.camera_.setWorld(scene.box.min[0], scene.box.min[1], scene.box.max[0], scene.box.max[1]);
  }

  /** Another world: its view opens with the first crowd. */
  open(scene: SceneFacts): void {
    this.know(scene);
    this.opened_ = false;
    this.camera_.open();
  }

  /** Fits the view to the crowd, its orders and the obstacles near it, with the first frame that has a crowd, unless
   * something else has brought the view to a pose by then: a film camera, say, before the first picture. */
  show(places: () => Numbers, groups: readonly GroupView[]): void {
    if (this.opened_ || this.camera_.width < 2) return;
    const positions = places();
    const crowd = crowdOutline(positions, groups, 0);
    if (crowd.length === 0) return;
    this.opened_ = true;
    const { whole } = this;
    this.whole = false;
    if (this.camera_.placed) return;
    if (whole) return this.camera_.fit(this.place(), this.padding);
    const alone = surroundings(this.scene_, crowd).length === 0;
    const points = alone ? crowdOutline(positions, groups, this.span()) : crowd;
    const wanted = [...points, ...goals(groups, points)];
    for (const widen of this.narrow() ? kWidenNarrow : [kWiden]) {
      this.camera_.fit([...wanted, ...surroundings(this.scene_, points, widen)], this.padding);
      if (!this.narrow() || this.camera_.pixelsPerMetre() >= kReadable) return;
    }
    this.camera_.fit(wanted, this.padding);
  }

  /** Fits crowd and paths; with `orPlace` the whole place, where they are fitted already. True where it was the place. */
  fit(positions: Numbers, groups: readonly GroupView[], atOnce: boolean, orPlace = false): boolean {
    const points = crowdOutline(positions, groups, this.span());
    const place = orPlace && this.fitted_ && this.shows(points) ? this.place() : [];
    this.camera_.glideFit(place.length > 0 ? place : points, this.padding, performance.now(), atOnce ? 0 : kGlide);
    this.fitted_ = orPlace && place.length === 0;
    return place.length > 0;
  }

  /** The view shows these points as a fit would, or is on its way there. */
  private shows(points: readonly GroundPoint[]): boolean {
    if (!this.camera_.atRest) return true;
    const { pose } = this.camera_;
    const wanted = this.camera_.poseFor(points, this.padding);
    const away = Math.hypot(wanted.targetX - pose.targetX, wanted.targetY - pose.targetY);
    return Math.max(away, Math.abs(wanted.distance - pose.distance)) < kSame * wanted.distance;
  }

  /** The corners of the place, with the walls about it. */
  private place(): GroundPoint[] {
    if (!this.scene_) return [];
    const { min, max } = this.scene_.box;
    const ys = [min[1] - kWalls, max[1] + kWalls];
    return [min[0] - kWalls, max[0] + kWalls].flatMap((x) => ys.map((y) => ({ x, y })));
  }

  /** Between the panels, with the room above the ground that must be seen [CSS px]. */
  get room(): { left: number; right: number; top: number } {
    const { left, right, top } = this.padding;
    return { left: left - kGap, right: this.camera_.width - right + kGap, top: top - kHeadroom };
  }

  lookAt(point: GroundPoint, atOnce: boolean): void {
    this.camera_.glideTo(point, this.padding, performance.now(), atOnce ? 0 : kGlide);
  }

  private narrow(): boolean {
    return this.camera_.width - this.padding.left - this.padding.right < kNarrow;
  }

  private span(): number {
    return this.narrow() ? kSpanLeast.narrow : kSpanLeast.wide;
  }
}
