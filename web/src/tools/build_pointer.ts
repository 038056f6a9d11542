// Pointers over the scene while somebody builds: one draws or drags, two move the camera, three that tap take the last step
// back.

import type { GroundPoint, ScreenPoint } from '../model/plane';

/** What one pointer does. */
export interface BuildStroke {
  readonly screen: ScreenPoint;
  readonly ground: GroundPoint;
  readonly touch: boolean;
  readonly shift: boolean;
  /** Alt: without snapping. */
  readonly free: boolean;
}

export interface BuildStrokes {
  begin(stroke: BuildStroke): void;
  /** `still`: it has not moved so far. */
  move(stroke: BuildStroke, still: boolean): void;
  /** `still`: it has not moved, so it was a tap. */
  end(stroke: BuildStroke, still: boolean): void;
  cancel(): void;
  doubleTap(stroke: BuildStroke): void;
  /** Three fingers tapped. */
  threeFingers(): void;
}

export interface BuildCamera {
  pan(from: ScreenPoint, to: ScreenPoint): void;
  pinch(before: readonly [ScreenPoint, ScreenPoint], after: readonly [ScreenPoint, ScreenPoint]): void;
  zoomAt(at: ScreenPoint, factor: number): void;
  orbit(turn: number, tilt: number): void;
}

export interface BuildView {
  readonly camera: BuildCamera;
  screenToWorld(at: ScreenPoint): GroundPoint | null;
  wake(): void;
}

interface Down {
  readonly from: ScreenPoint;
  at: ScreenPoint;
  readonly touch: boolean;
}

const kStill = 8;
const kDoubleMs = 350;
const kTapMs = 350;
const kRadiansPerPx = 0.006;

export class BuildPointer {
  private readonly down_ = new Map<number, Down>();
  private drawing_ = -1;
  private camera_: 'pan' | 'orbit' | null = null;
  private moved_ = false;
  private most_ = 0;
  private began_ = 0;
  private lastTap_ = { time: -Infinity, at: { x: 0, y: 0 } };

  constructor(
    private readonly strokes_: BuildStrokes,
    private readonly eye_: BuildCamera,
    private readonly toGround_: (at: ScreenPoint) => GroundPoint | null,
    private readonly moves_: () => void,
  ) {}

  /** Draws on the scene's ground. */
  static over(view: BuildView, strokes: BuildStrokes): BuildPointer {
    return new BuildPointer(
      strokes,
      view.camera,
      (at) => view.screenToWorld(at),
      () => view.wake(),
    );
  }

  listen(surface: SVGSVGElement): void {
    surface.addEventListener('pointerdown', (event) => this.pressed(event, surface));
    surface.addEventListener('pointermove', (event) => this.moved(event));
    surface.addEventListener('pointerup', (event) => this.lifted(event, false));
    surface.addEventListener('pointercancel', (event) => this.lifted(event, true));
    surface.addEventListener('contextmenu', (event) => event.preventDefault());
    surface.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        this.eye_.zoomAt({ x: event.clientX, y: event.clientY }, Math.exp(-event.deltaY * 0.0016));
        this.moves_();
      },
      { passive: false },
    );
  }

  private pressed(event: PointerEvent, surface: Element): void {
    event.preventDefault();
    try {
      surface.setPointerCapture(event.pointerId);
    } catch {
      // The pointer has gone in the meantime.
    }
    const at = { x: event.clientX, y: event.clientY };
    const touch = event.pointerType === 'touch';
    if (this.down_.size === 0) this.beginAnew(event.timeStamp);
    this.down_.set(event.pointerId, { from: at, at, touch });
    this.most_ = Math.max(this.most_, this.down_.size);
    if (this.down_.size > 1) return this.leaveDrawing();
    if (event.button === 1) this.camera_ = 'orbit';
    else if (event.button === 2) this.camera_ = 'pan';
    if (this.camera_) return;
    const stroke = this.strokeOf(event);
    if (!stroke) return;
    this.drawing_ = event.pointerId;
    this.strokes_.begin(stroke);
  }

  private beginAnew(time: number): void {
    this.moved_ = false;
    this.most_ = 0;
    this.began_ = time;
    this.camera_ = null;
  }

  private leaveDrawing(): void {
    if (this.drawing_ >= 0) this.strokes_.cancel();
    this.drawing_ = -1;
  }

  private moved(event: PointerEvent): void {
    const one = this.down_.get(event.pointerId);
    if (!one) return;
    const at = { x: event.clientX, y: event.clientY };
    this.moved_ ||= Math.hypot(at.x - one.from.x, at.y - one.from.y) > kStill;
    if (this.camera_ === 'pan') this.eye_.pan(one.at, at);
    if (this.camera_ === 'orbit') this.eye_.orbit((at.x - one.at.x) * kRadiansPerPx, (at.y - one.at.y) * kRadiansPerPx);
    if (this.down_.size === 2 && this.moved_) this.pinch(event.pointerId, at);
    one.at = at;
    if (this.camera_ || this.down_.size > 1) return this.moves_();
    const stroke = this.strokeOf(event);
    if (stroke && event.pointerId === this.drawing_) this.strokes_.move(stroke, !this.moved_);
  }

  private pinch(pointer: number, at: ScreenPoint): void {
    const [a, b] = [...this.down_.entries()];
    if (!a || !b) return;
    const after = (one: readonly [number, Down]): ScreenPoint => (one[0] === pointer ? at : one[1].at);
    this.eye_.pinch([a[1].at, b[1].at], [after(a), after(b)]);
  }

  private lifted(event: PointerEvent, cancelled: boolean): void {
    if (!this.down_.delete(event.pointerId)) return;
    if (event.pointerId === this.drawing_) this.endStroke(event, cancelled);
    if (this.down_.size > 0) return;
    const quick = event.timeStamp - this.began_ < kTapMs;
    if (this.most_ === 3 && !this.moved_ && quick && !cancelled) this.strokes_.threeFingers();
  }

  private endStroke(event: PointerEvent, cancelled: boolean): void {
    this.drawing_ = -1;
    const stroke = this.strokeOf(event);
    if (cancelled || !stroke) return this.strokes_.cancel();
    this.strokes_.end(stroke, !this.moved_);
    if (this.moved_) return;
    const { time, at } = this.lastTap_;
    const twice = event.timeStamp - time < kDoubleMs && Math.hypot(at.x - stroke.screen.x, at.y - stroke.screen.y) < 24;
    this.lastTap_ = { time: twice ? -Infinity : event.timeStamp, at: stroke.screen };
    if (twice) this.strokes_.doubleTap(stroke);
  }

  private strokeOf(event: PointerEvent): BuildStroke | null {
    const screen = { x: event.clientX, y: event.clientY };
    const ground = this.toGround_(screen);
    const { shiftKey: shift, altKey: free } = event;
    return ground && { screen, ground, touch: event.pointerType === 'touch', shift, free };
  }
}
