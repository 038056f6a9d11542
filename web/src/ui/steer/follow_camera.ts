// Keeps a crowd in the view: while a demonstration runs and until everybody stands again, or for as long as a visitor
// wants it. Whoever moves the camera by hand ends it.

import type { CameraControls, CameraPose, Padding } from '../../scene/camera/camera_controls';
import type { GroundPoint, ScreenPoint } from '../../model/plane';

/** The crowd takes between these shares of the room between the panels before the camera comes nearer or goes away. */
const kFills = { least: 0.42, aim: 0.78, most: 0.96 };
/** Share of that room in which the crowd's middle may move without the camera following. */
const kFree = 0.22;
/** Time in which the camera makes up for most of its lag: usually, and while somebody leaves the view [s]. */
const kEase = { usual: 0.7, urgent: 0.16 };
/** Who moves less than this in so many seconds stands [m], [s]. */
const kStanding = { metres: 0.25, seconds: 2 };
/** A share of the crowd that may go on moving when all the others stand. */
const kRestless = 0.02;
/** After a finger has lifted the view rests for so long [s]. */
const kRest = 0.8;
/** Points that bound the crowd are taken from so many characters at most. */
const kSamples = 2000;

export interface FollowHost {
  readonly camera: Pick<CameraControls, 'poseFor' | 'approach' | 'pose'>;
  worldToScreen(point: GroundPoint): ScreenPoint;
  /** Points whose outline holds these characters: x, y pairs. */
  outline(positions: ArrayLike<number>): GroundPoint[];
  /** Of the canvas [CSS px]. */
  size(): { readonly width: number; readonly height: number };
  padding(): Padding;
}

/** What it reads of a frame. */
export interface WatchedFrame {
  readonly step: number;
  readonly time: number;
  readonly demonstrating: boolean;
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
  /** Index of the group of each character; empty where unchanged. */
  readonly group: ArrayLike<number>;
}

/** Why the camera follows: a demonstration began, or the visitor wants it. */
export type Following = 'no' | 'watching' | 'wanted';

export class FollowCamera {
  private following_: Following = 'no';
  /** The camera has followed the crowd, and the visitor has not moved it since. */
  private away_ = false;
  private running_ = false;
  private step_ = 0;
  private groups_: ArrayLike<number> = [];
  /** Index of the group that is followed alone; -1 for everybody. */
  private alone_ = -1;
  private before_: { time: number; x: Float32Array; y: Float32Array } | null = null;
  private restUntil_ = 0;
  private last_ = 0;

  /** `fit` brings the whole crowd into view; `changed` hears when the camera begins or ends to follow. */
  constructor(
    private readonly host_: FollowHost,
    private readonly fit_: () => void,
    private readonly changed_: (following: Following) => void,
  ) {}

  get following(): Following {
    return this.following_;
  }

  /** Follows everybody, or no more. */
  toggle(): void {
    this.alone_ = -1;
    this.set(this.following_ === 'no' ? 'wanted' : 'no');
    if (this.following_ === 'wanted') this.fit_();
  }

  /** From now on the camera follows this group alone, where it follows at all. */
  watchAlone(group: number): void {
    this.alone_ = group;
  }

  /** The visitor moves the camera: it follows the crowd no more. */
  release(): void {
    this.set('no');
    this.away_ = false;
  }

  /** A finger works on the scene: the ground under it must not move. */
  rest(now: number): void {
    this.restUntil_ = now / 1000 + kRest;
  }

  /** Another world: its view opens by itself. */
  forget(): void {
    this.release();
    this.running_ = false;
    this.step_ = 0;
    this.alone_ = -1;
    this.groups_ = [];
    this.before_ = null;
  }

  /** For each frame, with the page's clock [ms]. */
  observe(frame: WatchedFrame, now: number): void {
    if (frame.group.length > 0 || frame.x.length === 0) this.groups_ = frame.group;
    if (frame.step < this.step_) this.backAtStart();
    if (frame.demonstrating && !this.running_) {
      this.alone_ = -1;
      this.set('watching');
    }
    this.running_ = frame.demonstrating;
    this.step_ = frame.step;
    if (this.following_ === 'no' || frame.x.length === 0) return;
    this.goAlong(frame, now / 1000);
    if (this.following_ === 'watching' && !this.running_ && this.allStand(frame)) this.set('no');
  }

  private backAtStart(): void {
    this.before_ = null;
    this.running_ = false;
    if (!this.away_) return;
    this.away_ = false;
    if (this.following_ === 'watching') this.set('no');
    this.fit_();
  }

  private set(following: Following): void {
    if (following === this.following_) return;
    this.following_ = following;
    this.before_ = null;
    this.changed_(following);
  }

  private goAlong(frame: WatchedFrame, now: number): void {
    const passed = Math.min(0.2, Math.max(0, now - this.last_));
    this.last_ = now;
    if (now < this.restUntil_) return;
    const points = this.host_.outline(this.watched(frame));
    if (points.length === 0) return;
    const { width, height } = this.host_.size();
    const padding = this.host_.padding();
    const wanted = this.wantedPose(points, padding, width, height);
    if (!wanted) return;
    this.away_ = true;
    this.host_.camera.approach(wanted.pose, 1 - Math.exp(-passed / (wanted.urgent ? kEase.urgent : kEase.usual)));
  }

  /** Null where the crowd is well in view as it is. */
  private wantedPose(
    points: readonly GroundPoint[],
    padding: Padding,
    width: number,
    height: number,
  ): { pose: CameraPose; urgent: boolean } | null {
    const { camera } = this.host_;
    const inner = {
      x: Math.max(80, width - padding.left - padding.right),
      y: Math.max(80, height - padding.top - padding.bottom),
    };
    const at = points.map((point) => this.host_.worldToScreen(point));
    const [x0, x1] = [Math.min(...at.map((p) => p.x)), Math.max(...at.map((p) => p.x))];
    const [y0, y1] = [Math.min(...at.map((p) => p.y)), Math.max(...at.map((p) => p.y))];
    const fills = Math.max((x1 - x0) / inner.x, (y1 - y0) / inner.y);
    const offX = Math.abs((x0 + x1) / 2 - (padding.left + inner.x / 2)) / inner.x;
    const offY = Math.abs((y0 + y1) / 2 - (padding.top + inner.y / 2)) / inner.y;
    const centred = Math.max(offX, offY) < kFree / 2;
    if (centred && fills > kFills.least && fills < kFills.most) return null;
    const fit = camera.poseFor(points, padding);
    const near = fills > kFills.least && fills < kFills.most;
    const distance = near ? camera.pose.distance : fit.distance / kFills.aim;
    const urgent = x0 < padding.left || x1 > width - padding.right || y0 < padding.top || y1 > height - padding.bottom;
    return { pose: { ...fit, distance }, urgent };
  }

  /** x, y of those who are followed; of a large crowd every second, third... */
  private watched({ x, y }: WatchedFrame): Float32Array {
    const { groups_: groups, alone_: alone } = this;
    const stride = Math.max(1, Math.floor(x.length / kSamples));
    const out: number[] = [];
    for (let i = 0; i < x.length; i += stride) {
      if (alone >= 0 && groups[i] !== alone) continue;
      out.push(x[i] ?? 0, y[i] ?? 0);
    }
    return Float32Array.from(out);
  }

  /** Whether nearly everybody is where they were two seconds ago. */
  private allStand({ time, x, y }: WatchedFrame): boolean {
    const { before_: before } = this;
    if (!before || before.x.length !== x.length) {
      this.before_ = { time, x: Float32Array.from(x), y: Float32Array.from(y) };
      return false;
    }
    if (time - before.time < kStanding.seconds) return false;
    let moved = 0;
    for (let i = 0; i < x.length; ++i) {
      const away = Math.hypot((x[i] ?? 0) - (before.x[i] ?? 0), (y[i] ?? 0) - (before.y[i] ?? 0));
      if (away > kStanding.metres) moved += 1;
    }
    this.before_ = { time, x: Float32Array.from(x), y: Float32Array.from(y) };
    return moved <= kRestless * x.length;
  }
}
