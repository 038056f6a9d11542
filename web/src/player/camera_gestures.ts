// Turns, zooms and moves the camera by mouse, fingers and keys, without keeping the page from scrolling: one finger that goes
// up or down, and the wheel without Ctrl, are the page's.

import type { ViewCamera } from './play/view_camera';

const kTurnPerPicture = 3;
const kPitchPerPicture = 1.6;
const kWheel = 0.0025;
const kKeyTurn = 0.12;
const kKeyZoom = 1.15;

/** A finger that has gone so far across turns the view; one that goes up or down first is the page's [px]. */
const kSlop = 8;

interface Point {
  readonly x: number;
  readonly y: number;
}

/** Where a pointer is, where it came down, and whether the view follows it. */
interface Held extends Point {
  readonly from: Point;
  readonly turns: boolean;
}

export interface GestureHost {
  /** The camera, where it may be moved now. */
  readonly camera: ViewCamera | null;
  /** Full screen: the wheel is the camera's. */
  readonly whole: boolean;
  moved(): void;
}

export class CameraGestures {
  private readonly pointers_ = new Map<number, Held>();

  /** `area_` is the picture; `all` what lies over it, too, for the wheel. */
  constructor(
    private readonly area_: HTMLElement,
    private readonly host_: GestureHost,
    all: HTMLElement = area_,
  ) {
    area_.addEventListener('pointerdown', (event) => this.down(event));
    area_.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      area_.addEventListener(end, (event) => this.pointers_.delete(event.pointerId));
    all.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    area_.addEventListener('dblclick', () => this.with((camera) => camera.reset()));
    area_.addEventListener('keydown', (event) => this.key(event));
    area_.addEventListener('contextmenu', (event) => {
      if (event.shiftKey) event.preventDefault();
    });
  }

  private with(change: (camera: ViewCamera) => void): boolean {
    const { camera } = this.host_;
    if (!camera) return false;
    change(camera);
    this.host_.moved();
    return true;
  }

  private down(event: PointerEvent): void {
    if (!this.host_.camera || (event.pointerType === 'mouse' && event.button !== 0)) return;
    const at = { x: event.clientX, y: event.clientY };
    const turns = event.pointerType === 'mouse' || this.host_.whole || this.pointers_.size > 0;
    this.pointers_.set(event.pointerId, { ...at, from: at, turns });
    this.area_.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const before = this.pointers_.get(event.pointerId);
    if (!before) return;
    const now = { x: event.clientX, y: event.clientY };
    const others = [...this.pointers_].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    const other = others[0];
    const gone = { x: Math.abs(now.x - before.from.x), y: Math.abs(now.y - before.from.y) };
    const turns = before.turns || other !== undefined || (gone.x > kSlop && gone.x > gone.y);
    this.pointers_.set(event.pointerId, { ...before, ...now, turns });
    if (!turns) return;
    const size = Math.max(1, this.area_.clientHeight);
    const by = { x: (now.x - before.x) / size, y: (now.y - before.y) / size };
    this.with((camera) => {
      if (other) pinch(camera, before, now, other, size);
      else if (event.shiftKey) camera.pan(-by.x, by.y);
      else camera.orbit(-kTurnPerPicture * by.x, kPitchPerPicture * by.y);
    });
  }

  private wheel(event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey && !this.host_.whole) return;
    const by = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 * event.deltaY : event.deltaY;
    if (this.with((camera) => camera.zoom(Math.exp(kWheel * Math.max(-200, Math.min(200, by))))))
      event.preventDefault();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const changes: Readonly<Record<string, (camera: ViewCamera) => void>> = {
      ArrowLeft: (camera) => camera.orbit(kKeyTurn, 0),
      ArrowRight: (camera) => camera.orbit(-kKeyTurn, 0),
      ArrowUp: (camera) => camera.orbit(0, kKeyTurn),
      ArrowDown: (camera) => camera.orbit(0, -kKeyTurn),
      '+': (camera) => camera.zoom(1 / kKeyZoom),
      '=': (camera) => camera.zoom(1 / kKeyZoom),
      '-': (camera) => camera.zoom(kKeyZoom),
      '0': (camera) => camera.reset(),
    };
    const change = changes[event.key];
    if (change && this.with(change)) event.preventDefault();
  }
}

/** Two fingers: zoom by their distance, turn by their angle, move by their middle. */
function pinch(camera: ViewCamera, before: Point, now: Point, other: Point, size: number): void {
  const apart = (p: Point): number => Math.max(10, Math.hypot(p.x - other.x, p.y - other.y));
  const angle = (p: Point): number => Math.atan2(p.y - other.y, p.x - other.x);
  const turn = angle(now) - angle(before);
  camera.zoom(apart(before) / apart(now));
  camera.orbit(turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)), 0);
  camera.pan(-(now.x - before.x) / (2 * size), (now.y - before.y) / (2 * size));
}
