// The camera as tools see it.

import type { GroundPoint, ScreenPoint } from '../../model/plane';

/** Width that panels cover at the edges of the canvas [CSS px]. */
export interface Padding {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** How the ground is seen. */
export interface SeenGround {
  /** Nine numbers by rows: from (x, y, 1) on the ground [m] to homogeneous px. */
  readonly matrix: readonly number[];
  /** Of the canvas [CSS px]. */
  readonly width: number;
  readonly height: number;
}

/** What tells how the ground is seen now. */
export interface GroundSight {
  seenGround(): SeenGround;
}

export interface CameraControls {
  /** Keeps the ground under a finger that moved. */
  pan(from: ScreenPoint, to: ScreenPoint): void;
  /** Moves the picture by so many px (keyboard). */
  panBy(dx: number, dy: number): void;
  /** Keeps the ground under both fingers: pans, turns and zooms. */
  pinch(before: readonly [ScreenPoint, ScreenPoint], after: readonly [ScreenPoint, ScreenPoint]): void;
  /** Factor above 1 comes nearer; the ground at `at` stays. */
  zoomAt(at: ScreenPoint, factor: number): void;
  /** Turns about the middle of the view and tilts [rad]; pitch stays within 25 to 85 degrees. */
  orbit(turn: number, tilt: number): void;
  /** Shows all points between the panels; pitch and turn stay. */
  fit(points: readonly GroundPoint[], padding: Padding): void;
}
