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

export interface CameraPose {
  /** Ground in the middle of the view [m]. */
  targetX: number;
  targetY: number;
  /** From the eye to the target [m]. */
  distance: number;
  /** Direction of view on the ground, from +y, counter-clockwise [rad]. */
  turn: number;
  /** Below the horizon [rad]. */
  pitch: number;
}

/** True for a pose, as it may be kept in a browser. */
export function isPose(value: unknown): value is CameraPose {
  if (typeof value !== 'object' || value === null) return false;
  const pose = value as Record<string, unknown>;
  return ['targetX', 'targetY', 'distance', 'turn', 'pitch'].every((key) => Number.isFinite(pose[key]));
}

/** What gestures and keys do with the camera. */
export interface HandMoves {
  /** Keeps the ground under a finger that moved. */
  pan(from: ScreenPoint, to: ScreenPoint): void;
  /** Moves the picture by so many px (keyboard). */
  panBy(dx: number, dy: number): void;
  /** Keeps the ground under both fingers: pans, turns and zooms. */
  pinch(before: readonly [ScreenPoint, ScreenPoint], after: readonly [ScreenPoint, ScreenPoint]): void;
  /** Factor above 1 comes nearer; the ground at `at` stays. */
  zoomAt(at: ScreenPoint, factor: number): void;
  /** Turns about the middle of the view and tilts [rad]; pitch stays within `flattest` and 85 degrees. */
  orbit(turn: number, tilt: number): void;
}

export interface CameraControls extends HandMoves {
  /** Least pitch [rad]. */
  flattest: number;
  readonly pose: Readonly<CameraPose>;
  /** Shows all points between the panels; pitch and turn stay. */
  fit(points: readonly GroundPoint[], padding: Padding): void;
  /** The pose in which all points are shown between the panels; the camera stays as it is. */
  poseFor(points: readonly GroundPoint[], padding: Padding): CameraPose;
  /** As `fit`, gliding there within `duration` [ms]. */
  glideFit(points: readonly GroundPoint[], padding: Padding, now: number, duration: number): void;
  /** Goes a share of the way to a pose; its turn and pitch do not matter. */
  approach(pose: CameraPose, share: number): void;
  /** Glides to a pose within `duration` [ms]. */
  glideToPose(pose: CameraPose, now: number, duration: number): void;
  /** Straight from above. */
  readonly top: boolean;
  setTop(top: boolean): void;
  /** Without perspective. */
  readonly flat: boolean;
  setFlat(flat: boolean): void;
}
