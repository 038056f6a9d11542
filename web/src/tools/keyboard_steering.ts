// Steering a formation without a pointer: grab its middle as an area, move it by arrow keys, drop it.

import { ControlKind } from '../protocol/messages';
import type { GroundPoint } from '../view/camera_types';
import { middleOf, convexHull } from '../geometry/plane';
import type { Held, HeldControls } from './held_controls';
import { lassoCorners } from './lasso';

/** Corners of the grabbed area, from the middle towards the hull. */
const SHARE = 0.6;
/** Per key press [m]. */
const STEP = 0.5;
const LONG_STEP = 2;

export type ArrowKey = 'ArrowUp' | 'ArrowDown' | 'ArrowLeft' | 'ArrowRight';

/** Where keys lead on the ground, as the camera looks. */
export interface GroundAxes {
  readonly right: GroundPoint;
  readonly up: GroundPoint;
}

/** Three to six corners of the inner part of a mesh. */
export function innerCorners(vertices: readonly GroundPoint[]): GroundPoint[] {
  const hull = convexHull(vertices);
  const corners = lassoCorners(hull, 0);
  const middle = middleOf(corners);
  return corners.map((p) => ({ x: middle.x + SHARE * (p.x - middle.x), y: middle.y + SHARE * (p.y - middle.y) }));
}

export class KeyboardSteering {
  private held: Held | null = null;

  constructor(private readonly controls: HeldControls) {}

  get active(): boolean {
    return this.held !== null && this.controls.all.includes(this.held);
  }

  grab(group: number, vertices: readonly GroundPoint[], time: number): boolean {
    const positions = innerCorners(vertices);
    if (this.active || positions.length < 3) return false;
    this.held = this.controls.create({ group, kind: ControlKind.Area, positions, time, keep: true, pinned: false });
    return true;
  }

  move(key: ArrowKey, long: boolean, axes: GroundAxes, time: number): void {
    if (!this.held || !this.active) return;
    const step = long ? LONG_STEP : STEP;
    const axis = key === 'ArrowUp' || key === 'ArrowDown' ? axes.up : axes.right;
    const sign = key === 'ArrowUp' || key === 'ArrowRight' ? step : -step;
    for (const finger of this.held.fingers) {
      const at = { x: finger.at.x + sign * axis.x, y: finger.at.y + sign * axis.y };
      this.controls.move(this.held, finger, at, time);
    }
  }

  drop(time: number): void {
    if (this.held && this.active) this.controls.letGo(this.held, time);
    this.held = null;
  }
}
