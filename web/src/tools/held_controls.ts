// Controls whose fingers are not real ones: made by rubber band, lasso or keyboard, or taken up again after the
// fingers lifted. Their touches stay down until they are let go.

import { ControlKind, type ControlFrame, type Frame } from '../protocol/messages';
import type { MessageSender } from '../engine/studio_client';
import type { GroundPoint } from '../view/camera_types';
import type { Grab, Grabbable } from './grab';
import type { TouchSender } from './touch_sender';

export interface Held {
  readonly group: number;
  readonly kind: ControlKind;
  readonly fingers: { readonly touch: number; at: GroundPoint }[];
  /** The server's number; 0 until a frame shows it. */
  control: number;
  /** The control that this one took the place of; 0 for none. */
  readonly replaced: number;
  pinned: boolean;
  /** Stays when its drag ends. */
  keep: boolean;
  drags: number;
  readonly bornAtStep: number;
}

export interface NewControl {
  readonly group: number;
  readonly kind: ControlKind;
  readonly positions: readonly GroundPoint[];
  readonly time: number;
  readonly keep: boolean;
  readonly pinned: boolean;
  readonly replaced?: number;
}

/** A control that no frame shows for so many steps was refused. */
const REFUSED_AFTER_STEPS = 60;

export class HeldControls {
  private held: Held[] = [];
  private step = 0;
  private newest: Held | null = null;

  constructor(
    private readonly client: MessageSender,
    private readonly touches: TouchSender,
    private readonly clientId: () => number,
  ) {}

  get all(): readonly Held[] {
    return this.held;
  }

  /** What of a control may be taken hold of: all of ours and of pinned ones, the handles of others that were lifted. */
  grabbable(control: ControlFrame): Grabbable {
    if (this.holderOf(control)) return 'whole';
    if (control.points.some((point) => point.down)) return 'nothing';
    return control.pinned ? 'whole' : 'handles';
  }

  create(made: NewControl): Held {
    const fingers = made.positions.map((at) => ({ touch: this.touches.nextTouch(), at }));
    this.client.send({
      type: 'AddControl',
      group: made.group,
      kind: made.kind,
      touches: Uint32Array.from(fingers, (finger) => finger.touch),
      xs: Float64Array.from(fingers, (finger) => finger.at.x),
      ys: Float64Array.from(fingers, (finger) => finger.at.y),
      time: made.time,
    });
    const { group, kind, pinned, keep, replaced = 0 } = made;
    const held: Held = { group, kind, fingers, control: 0, replaced, pinned, keep, drags: 0, bornAtStep: this.step };
    this.held.push(held);
    this.newest = held;
    return held;
  }

  /** Ours already, or made anew in the place of one whose fingers have lifted. */
  take(grab: Grab, time: number): Held {
    const known = this.holderOf(grab.control);
    if (known) return known;
    const { control, group } = grab;
    this.touches.flush();
    this.client.send({ type: 'RemoveControl', group, control: control.id });
    const positions = control.points.map(({ x, y }) => ({ x, y }));
    const { kind, pinned, id } = control;
    return this.create({ group, kind, positions, time, keep: false, pinned, replaced: id });
  }

  /** Moves one finger. */
  move(held: Held, point: number, at: GroundPoint, time: number): void {
    const finger = held.fingers[point];
    if (!finger) return;
    finger.at = at;
    this.touches.move(finger.touch, at, time);
  }

  /** A drag of it ended: unless it is meant to stay, its fingers lift. */
  release(held: Held, time: number): void {
    held.drags = Math.max(0, held.drags - 1);
    if (held.drags === 0 && !held.keep && !held.pinned) this.letGo(held, time);
  }

  letGo(held: Held, time: number): void {
    this.held = this.held.filter((other) => other !== held);
    for (const finger of held.fingers) this.touches.up(finger.touch, finger.at, time);
  }

  letGoAll(time: number): void {
    for (const held of [...this.held]) this.letGo(held, time);
  }

  /** Ends a control at once. */
  remove(group: number, control: ControlFrame): void {
    const held = this.holderOf(control);
    if (held) this.held = this.held.filter((other) => other !== held);
    this.client.send({ type: 'RemoveControl', group, control: control.id });
  }

  togglePin(group: number, control: ControlFrame, time: number): void {
    const pinned = !control.pinned;
    this.client.send({ type: 'PinControl', group, control: control.id, pinned });
    const held = this.holderOf(control);
    if (!held) return;
    held.pinned = pinned;
    if (pinned) return;
    held.keep = false;
    if (held.drags === 0) this.letGo(held, time);
  }

  /** Our newest control in this frame, for keys without a pointer. */
  newestIn(frame: Frame): { group: number; control: ControlFrame } | null {
    for (const group of frame.groups) {
      const control = group.controls.find((one) => this.newest !== null && this.matches(this.newest, one));
      if (control) return { group: group.id, control };
    }
    return null;
  }

  /** Learns the numbers of new controls, pins those that shall be, forgets those that are gone. */
  observe(frame: Frame): void {
    this.step = frame.step;
    const shown = frame.groups.flatMap((group) => group.controls);
    for (const held of [...this.held]) {
      const control = shown.find((one) => this.matches(held, one));
      if (control && held.control === 0) {
        held.control = control.id;
        if (held.pinned) this.client.send({ type: 'PinControl', group: held.group, control: control.id, pinned: true });
      }
      const refused = held.control === 0 && (frame.step < held.bornAtStep || frame.step - held.bornAtStep > REFUSED_AFTER_STEPS);
      if (!control && (held.control !== 0 || refused)) this.held = this.held.filter((other) => other !== held);
    }
  }

  clear(): void {
    this.held = [];
    this.newest = null;
  }

  private holderOf(control: ControlFrame): Held | undefined {
    return this.held.find((held) => held.replaced === control.id || this.matches(held, control));
  }

  private matches(held: Held, control: ControlFrame): boolean {
    if (control.client !== this.clientId()) return false;
    return control.points.some((point) => held.fingers.some((finger) => finger.touch === point.touch));
  }
}
