// Steering a formation without a pointer: grab its middle as an area, move it by arrow keys, drop it.

import { ControlKind } from '../protocol/messages';
import { middleOf, convexHull, type GroundPoint } from '../model/plane';
import type { VirtualControl, VirtualControls } from './virtual_controls';
import { lassoCorners } from './lasso';

/** Corners of the grabbed area, from the middle towards the hull. */
const kShare = 0.6;
/** Per key press [m]. */
const kStep = 0.5;
const kLongStep = 2;

export type ArrowKey = 'ArrowUp' | 'ArrowDown' | 'ArrowLeft' | 'ArrowRight';

/** Directions of the arrow keys on the ground, as the camera sees it. */
export interface GroundAxes {
  readonly right: GroundPoint;
  readonly up: GroundPoint;
}

/** What one press of an arrow key moves by. */
export function arrowStep(key: ArrowKey, long: boolean, { right, up }: GroundAxes): GroundPoint {
  const axis = key === 'ArrowUp' || key === 'ArrowDown' ? up : right;
  const step = (long ? kLongStep : kStep) * (key === 'ArrowUp' || key === 'ArrowRight' ? 1 : -1);
  return { x: step * axis.x, y: step * axis.y };
}

/** Three to six corners of the inner part of a mesh. */
export function innerCorners(vertices: readonly GroundPoint[]): GroundPoint[] {
  const hull = convexHull(vertices);
  const corners = lassoCorners(hull, 0);
  const middle = middleOf(corners);
  return corners.map((p) => ({ x: middle.x + kShare * (p.x - middle.x), y: middle.y + kShare * (p.y - middle.y) }));
}

export class KeyboardSteering {
  private control_: VirtualControl | null = null;

  constructor(private readonly controls_: VirtualControls) {}

  get active(): boolean {
    return this.control_ !== null && this.controls_.all.includes(this.control_);
  }

  grab(group: number, vertices: readonly GroundPoint[], time: number): boolean {
    const positions = innerCorners(vertices);
    if (this.active || positions.length < 3) return false;
    this.control_ = this.controls_.create({
      group,
      kind: ControlKind.Area,
      positions,
      time,
      keep: true,
      pinned: false,
    });
    return true;
  }

  move(key: ArrowKey, long: boolean, axes: GroundAxes, time: number): void {
    if (!this.control_ || !this.active) return;
    const step = arrowStep(key, long, axes);
    for (const finger of this.control_.fingers) {
      const at = { x: finger.at.x + step.x, y: finger.at.y + step.y };
      this.controls_.move(this.control_, finger, at, time);
    }
  }

  drop(time: number): void {
    if (this.control_ && this.active) this.controls_.letGo(this.control_, time);
    this.control_ = null;
  }
}
