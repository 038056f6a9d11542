// Keys that act on camera and controls.

import { pageClock } from '../engine/latency_meter';
import type { StudioFrame } from '../engine/studio_frame';
import type { CameraControls, GroundPoint, ScreenPoint } from '../view/camera_types';
import { pointsOf } from '../geometry/plane';
import type { HeldControls, OwnControl } from './held_controls';
import { KeyboardSteering, type ArrowKey, type GroundAxes } from './keyboard_steering';
import type { ToolChooser } from './tool_chooser';

export interface KeyScene {
  readonly camera: CameraControls;
  screenToWorld(at: ScreenPoint): GroundPoint | null;
}

export type PointerFacts = Pick<PointerEvent, 'type' | 'pointerType' | 'buttons' | 'clientX' | 'clientY'>;

const PAN_PX = 60;
const PAN_FAR_PX = 240;

/** Right and up on the ground, as the camera looks; the world's axes where the middle shows no ground. */
export function groundAxes(toGround: (at: ScreenPoint) => GroundPoint | null, middle: ScreenPoint): GroundAxes {
  const from = toGround(middle);
  const towards = (x: number, y: number): GroundPoint | null => {
    const to = toGround({ x: middle.x + x, y: middle.y + y });
    if (!from || !to) return null;
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    return length > 0 ? { x: (to.x - from.x) / length, y: (to.y - from.y) / length } : null;
  };
  return { right: towards(20, 0) ?? { x: 1, y: 0 }, up: towards(0, -20) ?? { x: 0, y: 1 } };
}

export class CrowdKeys {
  private readonly steering: KeyboardSteering;
  private frame: StudioFrame | null = null;
  /** Where the mouse is over the scene; null while it drags. */
  private pointer: ScreenPoint | null = null;

  constructor(
    private readonly scene: KeyScene,
    private readonly controls: HeldControls,
    private readonly chooser: ToolChooser,
    private readonly middle: () => ScreenPoint,
    private readonly say: (text: string) => void,
  ) {
    this.steering = new KeyboardSteering(controls);
  }

  observe(frame: StudioFrame): void {
    this.frame = frame;
  }

  /** A pointer event over the scene. A drag has its control in hand: what lies under the mouse then is chance. */
  pointed({ type, pointerType, buttons, clientX, clientY }: PointerFacts): void {
    if (pointerType === 'touch') return;
    this.pointer = type !== 'pointerleave' && buttons === 0 ? { x: clientX, y: clientY } : null;
  }

  arrow(key: ArrowKey, long: boolean): void {
    if (this.steering.active) {
      const axes = groundAxes((at) => this.scene.screenToWorld(at), this.middle());
      this.steering.move(key, long, axes, pageClock());
      return;
    }
    const px = long ? PAN_FAR_PX : PAN_PX;
    const x = key === 'ArrowLeft' ? px : key === 'ArrowRight' ? -px : 0;
    const y = key === 'ArrowUp' ? px : key === 'ArrowDown' ? -px : 0;
    this.scene.camera.panBy(x, y);
  }

  zoom(factor: number): void {
    this.scene.camera.zoomAt(this.middle(), factor);
  }

  turn(radians: number): void {
    this.scene.camera.orbit(radians, 0);
  }

  /** Takes the middle of a group's mesh in hand, or drops it. */
  grabOrDrop(active: number): void {
    if (this.steering.active) {
      this.steering.drop(pageClock());
      this.say('Dropped');
      return;
    }
    const group = this.frame?.groups[active];
    if (group && this.steering.grab(group.id, pointsOf(group.vertices), pageClock())) {
      this.say('In hand: arrow keys carry it, Enter drops it');
    }
  }

  letGo(): void {
    this.controls.letGoAll(pageClock(), this.frame);
  }

  togglePin(): void {
    const target = this.target();
    if (!target) return;
    this.controls.togglePin(target.group, target.control, pageClock());
    this.say(target.control.pinned ? 'Let go' : 'Pinned');
  }

  removeControl(): void {
    const target = this.target();
    if (!target) return;
    this.controls.remove(target.group, target.control);
    this.say('Removed');
  }

  /** What is dragged, else what lies under the mouse, whoever holds it, else our newest. */
  private target(): OwnControl | null {
    if (!this.frame) return null;
    const ground = this.pointer && this.scene.screenToWorld(this.pointer);
    return this.controls.draggedIn(this.frame) ?? (ground && this.chooser.nearest(ground)) ?? this.controls.newestIn(this.frame);
  }
}
