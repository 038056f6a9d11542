// What panels and keys ask of the camera: to fit, to follow, to look from above, and to come back to saved views.

import { isPose, type CameraPose, type HandMoves, type Padding } from '../../scene/camera/camera_controls';
import { crowdOutline, kSpanLeast } from '../../scene/camera/bounds_builder';
import type { StudioScene } from '../../scene/studio_scene';
import type { StudioFrame } from '../../model/studio_frame';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import type { CrowdArrow } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { FollowCamera } from './follow_camera';
import { readSetting, writeSetting } from '../widgets/theme';

/** Duration of a move to another view [ms]. */
const kGlide = 320;
/** A group is off screen where less than this share of it is in view. */
const kSeen = 0.1;
/** Between two looks for groups that are off screen [ms]. */
const kLook = 200;
/** From the edge of the room between the panels to the middle of an arrow [CSS px]. */
const kInset = 30;
/** So many characters of a large crowd are looked at before a zoom. */
const kZoomSamples = 3000;
/** A group that is followed or framed comes this near [m]. */
const kSpan = kSpanLeast.narrow;
const kViewsKey = 'muster.views.';

export interface CameraControllerHost {
  readonly view: Pick<StudioScene, 'camera' | 'worldToScreen' | 'fitter' | 'fitCrowd' | 'lookAt'>;
  readonly store: StudioStore;
  readonly canvas: Pick<HTMLCanvasElement, 'clientWidth' | 'clientHeight'>;
  /** What the panels cover. */
  padding(): Padding;
  say(text: string): void;
  /** A hand moves the camera. */
  moved?(): void;
}

/** Calls `moved` before a hand moves the camera. */
export function byHand(camera: HandMoves, moved: () => void): HandMoves {
  return {
    pan: (from, to) => (moved(), camera.pan(from, to)),
    panBy: (dx, dy) => (moved(), camera.panBy(dx, dy)),
    pinch: (before, after) => (moved(), camera.pinch(before, after)),
    zoomAt: (at, factor) => (moved(), camera.zoomAt(at, factor)),
    orbit: (turn, tilt) => (moved(), camera.orbit(turn, tilt)),
  };
}

export class CameraController {
  /** The camera for gestures and keys. */
  readonly hand: HandMoves;
  private readonly follow_: FollowCamera;
  private frame_: StudioFrame | null = null;
  private group_: ArrayLike<number> = [];
  private lookedAt_ = 0;

  constructor(private readonly host_: CameraControllerHost) {
    const { view, store, canvas } = host_;
    this.follow_ = new FollowCamera(
      {
        camera: view.camera,
        worldToScreen: (point) => view.worldToScreen(point),
        outline: (positions) => crowdOutline(positions, [], kSpan),
        size: () => ({ width: canvas.clientWidth, height: canvas.clientHeight }),
        padding: () => host_.padding(),
      },
      () => this.fit(),
      (following) => store.set({ following: following !== 'no' }),
    );
    const hand = byHand(view.camera, () => this.handMoved());
    this.hand = { ...hand, zoomAt: (at, factor) => hand.zoomAt(this.zoomSpot(at, factor), factor) };
  }

  /** A contact works on the scene. */
  contact(): void {
    this.follow_.rest(performance.now());
  }

  forgetWorld(): void {
    this.follow_.forget();
    this.host_.store.set({ arrows: [] });
  }

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
    if (frame.group.length > 0 || frame.x.length === 0) this.group_ = frame.group;
    this.follow_.observe(frame, performance.now());
  }

  /** Once per picture of the display. */
  tick(now: number): void {
    if (now - this.lookedAt_ < kLook) return;
    this.lookedAt_ = now;
    const arrows = this.arrows();
    const { state } = this.host_.store;
    if (arrows.length > 0 || state.arrows.length > 0) this.host_.store.set({ arrows });
  }

  fit(): void {
    this.host_.view.fitter.padding = this.host_.padding();
    this.host_.view.fitCrowd();
  }

  /** Fits the crowd, and the whole place where the crowd is fitted already. */
  fitInTurn(): void {
    this.host_.view.fitter.padding = this.host_.padding();
    const place = this.host_.view.fitCrowd(true);
    if (place) this.follow_.release();
    this.host_.say(place ? 'The whole place in view' : 'The crowd in view');
  }

  lookAt(point: GroundPoint): void {
    this.follow_.release();
    this.host_.view.fitter.padding = this.host_.padding();
    this.host_.view.lookAt(point);
  }

  /** Shows these points. */
  frame(points: readonly GroundPoint[]): void {
    this.follow_.release();
    const outline = crowdOutline(
      points.flatMap(({ x, y }) => [x, y]),
      [],
      kSpan,
    );
    this.host_.view.camera.glideFit(outline, this.host_.padding(), performance.now(), this.glide());
  }

  toggleFollow(): void {
    this.follow_.toggle();
    this.host_.say(this.follow_.following === 'no' ? 'The camera stays' : 'The camera tracks the crowd');
  }

  /** Shows one group, its places and the paths ahead of it. */
  frameGroup(index: number): void {
    const group = this.frame_?.groups[index];
    if (!this.frame_ || !group) return;
    const points = crowdOutline(this.membersOf(this.frame_, index), [group], kSpan);
    if (points.length === 0) return;
    this.follow_.watchAlone(index);
    this.host_.view.camera.glideFit(points, this.host_.padding(), performance.now(), this.glide());
    this.host_.say(`${this.host_.store.state.groups[index]?.name ?? 'The group'} in view`);
  }

  toggleTop(): void {
    const { camera } = this.host_.view;
    camera.setTop(!camera.top);
    this.host_.store.set({ topView: camera.top });
    this.host_.say(camera.top ? 'Seen from above' : 'Seen from the side');
  }

  toggleFlat(): void {
    const { camera } = this.host_.view;
    camera.setFlat(!camera.flat);
    this.host_.store.set({ flatView: camera.flat });
    this.host_.say(camera.flat ? 'Without perspective' : 'With perspective');
  }

  /** Views 1 to 9 belong to the scenario and outlast a reload. */
  saveView(number: number): void {
    const views = { ...this.views(), [number]: { ...this.host_.view.camera.pose } };
    writeSetting(() => window.localStorage, this.viewsKey(), JSON.stringify(views));
    this.host_.say(`View ${number} saved`);
  }

  showView(number: number): void {
    const pose = this.views()[number];
    if (!pose) return this.host_.say(`There is no view ${number} yet`);
    this.follow_.release();
    this.host_.view.camera.glideToPose(pose, performance.now(), this.glide());
    this.host_.store.set({ topView: this.host_.view.camera.top });
    this.host_.say(`View ${number}`);
  }

  private handMoved(): void {
    this.follow_.release();
    this.host_.moved?.();
  }

  /** Where a zoom at a spot would leave nobody in view who is in view now: the nearest of them on the screen. */
  private zoomSpot(at: ScreenPoint, factor: number): ScreenPoint {
    const frame = this.frame_;
    if (!frame || factor <= 1) return at;
    const { clientWidth: width, clientHeight: height } = this.host_.canvas;
    let nearest: ScreenPoint | null = null;
    let least = Infinity;
    const stride = Math.max(1, Math.floor(frame.x.length / kZoomSamples));
    for (let i = 0; i < frame.x.length; i += stride) {
      const one = this.host_.view.worldToScreen({ x: frame.x[i] ?? 0, y: frame.y[i] ?? 0 });
      if (!isInside(one, width, height)) continue;
      const then = { x: at.x + (one.x - at.x) * factor, y: at.y + (one.y - at.y) * factor };
      if (isInside(then, width, height)) return at;
      const away = Math.hypot(one.x - at.x, one.y - at.y);
      if (away < least) [least, nearest] = [away, one];
    }
    return nearest ?? at;
  }

  private viewsKey(): string {
    return kViewsKey + this.host_.store.state.scenario;
  }

  private views(): Record<number, CameraPose> {
    try {
      const kept: unknown = JSON.parse(readSetting(() => window.localStorage, this.viewsKey()) ?? '{}');
      return Object.fromEntries(Object.entries(kept as object).filter(([, pose]) => isPose(pose)));
    } catch {
      return {};
    }
  }

  private glide(): number {
    return window.matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : kGlide;
  }

  private membersOf({ x, y }: StudioFrame, index: number): Float32Array {
    const out: number[] = [];
    for (let i = 0; i < x.length; ++i) if (this.group_[i] === index) out.push(x[i] ?? 0, y[i] ?? 0);
    return Float32Array.from(out);
  }

  /** Where groups are that are off screen. */
  private arrows(): CrowdArrow[] {
    const frame = this.frame_;
    if (!frame) return [];
    const { clientWidth: width, clientHeight: height } = this.host_.canvas;
    const padding = this.host_.padding();
    const { groups } = this.host_.store.state;
    const found = groups.map(() => ({ count: 0, seen: 0, x: 0, y: 0 }));
    const point = { x: 0, y: 0 };
    for (let i = 0; i < frame.x.length; ++i) {
      const group = found[this.group_[i] ?? -1];
      if (!group) continue;
      point.x = frame.x[i]!;
      point.y = frame.y[i]!;
      const at = this.host_.view.worldToScreen(point);
      group.count += 1;
      group.x += at.x;
      group.y += at.y;
      if (at.x > 0 && at.x < width && at.y > 0.5 * padding.top && at.y < height - 0.7 * padding.bottom) group.seen += 1;
    }
    return groups.flatMap(({ id }, index) => {
      const { count, seen, x, y } = found[index]!;
      if (count === 0 || seen >= kSeen * count) return [];
      return [{ index, id, ...arrowAt({ x: x / count, y: y / count }, padding, width, height) }];
    });
  }
}

/** Where the way from the middle between the panels to a spot leaves the room between them, and its direction [rad]. */
export function arrowAt(
  to: ScreenPoint,
  padding: Padding,
  width: number,
  height: number,
): { x: number; y: number; angle: number } {
  const [left, right] = [padding.left + kInset, width - padding.right - kInset];
  const [top, bottom] = [padding.top + kInset, height - padding.bottom - kInset];
  const middle = { x: (left + right) / 2, y: (top + bottom) / 2 };
  const [dx, dy] = [to.x - middle.x, to.y - middle.y];
  const reach = Math.max(
    Math.abs(dx) / Math.max(1, (right - left) / 2),
    Math.abs(dy) / Math.max(1, (bottom - top) / 2),
    1e-9,
  );
  return { x: Math.round(middle.x + dx / reach), y: Math.round(middle.y + dy / reach), angle: Math.atan2(dy, dx) };
}

function isInside({ x, y }: ScreenPoint, width: number, height: number): boolean {
  return x > 0 && y > 0 && x < width && y < height;
}
