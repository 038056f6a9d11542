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
/** A window narrower than this between its panels shows less of what stands about [CSS px]. */
const kNarrow = 420;
/** There it is drawn in, by one of these after the other [m], until people are large enough [CSS px per metre]. */
const kWidenNarrow = [kWiden, 4, 2] as const;
const kReadable = 14;

/** Walls at the sides of a place reach so far beyond it on the screen [m]. */
const kWalls = 2;

function corners({ min, max }: SceneFacts['box']): GroundPoint[] {
  const xs = [min[0] - kWalls, max[0] + kWalls];
  return xs.flatMap((x) => [min[1] - kWalls, max[1] + kWalls].map((y) => ({ x, y })));
}

export class ViewFitter {
  /** What panels cover. */
  padding: Padding = { top: 84, right: 24, bottom: 120, left: 24 };
  /** The next world opens with all of it in view. */
  whole = false;
  private scene_: SceneFacts | null = null;
  private opened_ = false;

  constructor(private readonly camera_: CameraController) {}

  /** Another world: its view opens with the first crowd. */
  open(scene: SceneFacts): void {
    this.scene_ = scene;
    this.opened_ = false;
    this.camera_.setWorld(scene.box.min[0], scene.box.min[1], scene.box.max[0], scene.box.max[1]);
    this.camera_.open();
  }

  /** Fits the view to the crowd, its orders and the obstacles near it, with the first frame that has a crowd, unless
   * something else has brought the view to a pose by then: a film camera, say, before the first picture. */
  show(positions: Numbers, groups: readonly GroupView[]): void {
    if (this.opened_ || this.camera_.width < 2) return;
    const points = crowdOutline(positions, groups, this.span());
    if (points.length === 0) return;
    this.opened_ = true;
    const { whole, scene_: scene } = this;
    this.whole = false;
    if (this.camera_.placed) return;
    if (whole && scene) return this.camera_.fit(corners(scene.box), this.padding);
    const wanted = [...points, ...goals(groups, points)];
    for (const widen of this.narrow() ? kWidenNarrow : [kWiden]) {
      this.camera_.fit([...wanted, ...surroundings(this.scene_, points, widen)], this.padding);
      if (!this.narrow() || this.camera_.pixelsPerMetre() >= kReadable) return;
    }
    this.camera_.fit(wanted, this.padding);
  }

  fit(positions: Numbers, groups: readonly GroupView[], atOnce: boolean): void {
    const points = crowdOutline(positions, groups, this.span());
    this.camera_.glideFit(points, this.padding, performance.now(), atOnce ? 0 : kGlide);
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
