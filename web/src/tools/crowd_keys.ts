// Keys that act on camera and controls.

import type { StudioFrame } from '../model/studio_frame';
import type { HandMoves } from '../scene/camera/camera_controls';
import { pointsOf, type GroundPoint, type ScreenPoint } from '../model/plane';
import type { VirtualControls, OwnControl } from './virtual_controls';
import { groundAxes } from './ground_axes';
import { KeyboardSteering, type ArrowKey } from './keyboard_steering';
import type { ToolChooser } from './tool_chooser';
import { pageClock } from '../model/page_clock';

export interface KeyScene {
  readonly camera: HandMoves;
  screenToWorld(at: ScreenPoint): GroundPoint | null;
}

export type PointerFacts = Pick<PointerEvent, 'type' | 'pointerType' | 'buttons' | 'clientX' | 'clientY'>;

const kPanPx = 60;
const kPanFarPx = 240;

export class CrowdKeys {
  private readonly steering_: KeyboardSteering;
  private frame_: StudioFrame | null = null;
  /** Where the mouse is over the scene; null while it drags. */
  private pointer_: ScreenPoint | null = null;

  constructor(
    private readonly scene_: KeyScene,
    private readonly controls_: VirtualControls,
    private readonly chooser_: ToolChooser,
    private readonly middle_: () => ScreenPoint,
    private readonly say_: (text: string) => void,
  ) {
    this.steering_ = new KeyboardSteering(controls_);
  }

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
  }

  /** A pointer event over the scene. During a drag keys act on the dragged control, so the pointer is forgotten. */
  pointed({ type, pointerType, buttons, clientX, clientY }: PointerFacts): void {
    if (pointerType === 'touch') return;
    this.pointer_ = type !== 'pointerleave' && buttons === 0 ? { x: clientX, y: clientY } : null;
  }

  arrow(key: ArrowKey, long: boolean): void {
    if (this.steering_.active) {
      const axes = groundAxes((at) => this.scene_.screenToWorld(at), this.middle_());
      this.steering_.move(key, long, axes, pageClock());
      return;
    }
    const px = long ? kPanFarPx : kPanPx;
    const x = key === 'ArrowLeft' ? px : key === 'ArrowRight' ? -px : 0;
    const y = key === 'ArrowUp' ? px : key === 'ArrowDown' ? -px : 0;
    this.scene_.camera.panBy(x, y);
  }

  zoom(factor: number): void {
    this.scene_.camera.zoomAt(this.middle_(), factor);
  }

  turn(radians: number): void {
    this.scene_.camera.orbit(radians, 0);
  }

  /** Takes the middle of a group's mesh in hand, or drops it. */
  grabOrDrop(active: number): void {
    if (this.steering_.active) {
      this.steering_.drop(pageClock());
      this.say_('Dropped');
      return;
    }
    const group = this.frame_?.groups[active];
    if (group && this.steering_.grab(group.id, pointsOf(group.vertices), pageClock())) {
      this.say_('In hand: arrow keys carry it, Enter drops it');
    }
  }

  letGo(): void {
    this.controls_.letGoAll(pageClock(), this.frame_);
  }

  togglePin(): void {
    const target = this.target();
    if (!target) return;
    this.controls_.togglePin(target.group, target.control, pageClock());
    this.say_(target.control.pinned ? 'Let go' : 'Pinned');
  }

  removeControl(): void {
    const target = this.target();
    if (!target) return;
    this.controls_.remove(target.group, target.control);
    this.say_('Removed');
  }

  /** The dragged control, else the one under the mouse, whoever holds it, else our newest. */
  private target(): OwnControl | null {
    if (!this.frame_) return null;
    const ground = this.pointer_ && this.scene_.screenToWorld(this.pointer_);
    return (
      this.controls_.draggedIn(this.frame_) ??
      (ground && this.chooser_.nearest(ground)) ??
      this.controls_.newestIn(this.frame_)
    );
  }
}
