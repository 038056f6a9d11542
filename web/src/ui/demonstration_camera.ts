// The camera follows the crowd during a demonstration, until the visitor moves it.

import type { CameraControls, Padding } from '../scene/camera/camera_controls';
import type { ScreenPoint } from '../model/plane';

/** Share of the window between the panels in which the crowd's middle may move without the camera following. */
const kFree = 0.3;
/** Share of the excess that the camera corrects with each frame. */
const kEase = 0.08;

export interface CameraHost {
  readonly camera: Pick<CameraControls, 'panBy'>;
  worldToScreen(point: { x: number; y: number }): ScreenPoint;
}

/** What it reads of a frame. */
export interface WatchedFrame {
  readonly step: number;
  readonly demonstrating: boolean;
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
}

export class DemonstrationCamera {
  private follows_ = false;
  /** The camera has followed the crowd, and the visitor has not moved it since. */
  private away_ = false;
  private running_ = false;
  private step_ = 0;

  /** `fit` brings the whole crowd into view. */
  constructor(
    private readonly host_: CameraHost,
    private readonly fit_: () => void,
  ) {}

  /** The visitor moves the camera: it follows the crowd no more. */
  release(): void {
    this.follows_ = false;
    this.away_ = false;
  }

  /** Another world: its view opens by itself. */
  forget(): void {
    this.release();
    this.running_ = false;
    this.step_ = 0;
  }

  /** For each frame; the size is the canvas's [CSS px]. */
  observe(frame: WatchedFrame, width: number, height: number, padding: () => Padding): void {
    if (frame.step < this.step_ && this.away_) {
      // The crowd is back at the start.
      this.away_ = false;
      this.fit_();
    }
    if (frame.demonstrating && !this.running_) this.follows_ = true;
    this.running_ = frame.demonstrating;
    this.step_ = frame.step;
    if (this.running_ && this.follows_ && frame.x.length > 0) this.goAlong(frame, width, height, padding());
  }

  private goAlong(frame: WatchedFrame, width: number, height: number, padding: Padding): void {
    const at = this.host_.worldToScreen({ x: mean(frame.x), y: mean(frame.y) });
    const dx = beyond(at.x, padding.left, width - padding.right);
    const dy = beyond(at.y, padding.top, height - padding.bottom);
    if (dx === 0 && dy === 0) return;
    this.away_ = true;
    this.host_.camera.panBy(-kEase * dx, -kEase * dy);
  }
}

function mean(list: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < list.length; ++i) sum += list[i] ?? 0;
  return sum / list.length;
}

/** By how much a value is beyond the free share in the middle of a range. */
function beyond(value: number, low: number, high: number): number {
  const middle = (low + high) / 2;
  const half = (kFree * Math.max(0, high - low)) / 2;
  return value > middle + half ? value - middle - half : value < middle - half ? value - middle + half : 0;
}
