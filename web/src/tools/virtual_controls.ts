// Controls with virtual fingers: made by rubber band, lasso or keyboard, or grabbed again after the real fingers
// lifted. Their touches stay down until they are released.

import type { Command, Vec2 } from '../protocol/generated/commands';
import { kControlKindWords } from '../protocol/generated/words';
import { type ControlKind, type ControlFrame } from '../protocol/messages';
import type { StudioFrame, StudioGroup } from '../model/studio_frame';
import type { MessageSender } from '../link/studio_client';
import { kNoDrafts, type DraftBook } from './drafts';
import type { Grab, Grabbable } from './grab';
import type { TouchSender } from './touch_sender';
import type { GroundPoint } from '../model/plane';

export interface VirtualFinger {
  readonly touch: number;
  /** The touch whose point it took over; 0 for none. */
  readonly replacedTouch: number;
  at: GroundPoint;
}

export interface VirtualControl {
  readonly group: number;
  readonly kind: ControlKind;
  readonly fingers: readonly VirtualFinger[];
  /** The server's number; 0 until a frame shows it. */
  control: number;
  /** The control that this one replaced; 0 for none. */
  readonly replaced: number;
  pinned: boolean;
  /** Stays after its drag has ended. */
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
  /** The control that it replaces, and the touches of that control's points. */
  readonly replaced?: number;
  readonly replacedTouches?: readonly number[];
}

/** A control of ours in a frame. */
export interface OwnControl {
  readonly group: number;
  readonly control: ControlFrame;
}

/** A control that no frame shows for so many steps was refused. */
const kRefusedAfterSteps = 60;

export class VirtualControls {
  private controls_: VirtualControl[] = [];
  private step_ = 0;

  constructor(
    private readonly client_: MessageSender,
    private readonly touches_: TouchSender,
    private readonly clientId_: () => number,
    private readonly drafts_: DraftBook = kNoDrafts,
  ) {}

  get all(): readonly VirtualControl[] {
    return this.controls_;
  }

  /** Those that no frame has shown yet. */
  get pending(): readonly VirtualControl[] {
    return this.controls_.filter((virtual) => virtual.control === 0);
  }

  /**
   * The part of a control that may be grabbed: all of ours and of pinned ones, the handles of others whose fingers
   * lifted.
   */
  grabbable(control: ControlFrame, group: number): Grabbable {
    if (this.holderOf(control, group)) return 'whole';
    if (control.points.some((point) => point.down)) return 'nothing';
    return control.pinned ? 'whole' : 'handles';
  }

  create(made: NewControl): VirtualControl {
    const fingers = made.positions.map((at, i) => ({
      touch: this.touches_.nextTouch(),
      replacedTouch: made.replacedTouches?.[i] ?? 0,
      at,
    }));
    this.tell({
      kind: 'control',
      group: made.group,
      control: kControlKindWords[made.kind],
      touches: fingers.map(({ touch }) => touch),
      positions: fingers.map(({ at }): Vec2 => [at.x, at.y]),
      time: made.time,
    });
    const { group, kind, pinned, keep, replaced = 0 } = made;
    const virtual: VirtualControl = {
      group,
      kind,
      fingers,
      control: 0,
      replaced,
      pinned,
      keep,
      drags: 0,
      bornAtStep: this.step_,
    };
    this.controls_.push(virtual);
    this.drafts_.changed();
    return virtual;
  }

  /** Returns the control where it is ours; else replaces it, as its fingers have lifted. */
  take(grab: Grab, time: number): VirtualControl {
    const known = this.holderOf(grab.control, grab.group);
    if (known) return known;
    const { control, group } = grab;
    this.touches_.flush();
    this.tell({ kind: 'editControl', group, control: control.id, edit: 'remove' });
    const positions = control.points.map(({ x, y }) => ({ x, y }));
    const was = control.points.map(({ touch }) => touch);
    const { kind, pinned, id } = control;
    return this.create({ group, kind, positions, time, keep: false, pinned, replaced: id, replacedTouches: was });
  }

  /** The fingers that hold what was grabbed: the server may show fewer points than there are fingers. */
  fingersOf(virtual: VirtualControl, { control, touches }: Grab): readonly VirtualFinger[] {
    const old = virtual.replaced === control.id;
    return virtual.fingers.filter((finger) => touches.includes(old ? finger.replacedTouch : finger.touch));
  }

  /** Moves one finger. */
  move(virtual: VirtualControl, finger: VirtualFinger, at: GroundPoint, time: number): void {
    finger.at = at;
    this.touches_.move(finger.touch, at, time);
    this.drafts_.add(finger.touch, virtual.group, at, time);
  }

  /** Ends a drag. The fingers lift unless the control stays. */
  release(virtual: VirtualControl, time: number): void {
    virtual.drags = Math.max(0, virtual.drags - 1);
    if (virtual.drags === 0 && !virtual.keep && !virtual.pinned) this.letGo(virtual, time);
  }

  letGo(virtual: VirtualControl, time: number): void {
    this.controls_ = this.controls_.filter((other) => other !== virtual);
    for (const finger of virtual.fingers) this.touches_.up(finger.touch, finger.at, time);
    this.drafts_.changed();
  }

  /** Removes all our controls, pinned or not. Fingers of controls that no frame shows yet lift. */
  letGoAll(time: number, frame: StudioFrame | null): void {
    for (const { touch } of this.controls_.flatMap((virtual) => virtual.fingers)) this.drafts_.drop(touch);
    for (const virtual of this.pending) this.letGo(virtual, time);
    this.controls_ = [];
    this.touches_.flush();
    for (const { group, control } of this.ownIn(frame)) {
      this.tell({ kind: 'editControl', group, control: control.id, edit: 'remove' });
    }
    this.drafts_.changed();
  }

  /** Ends a control at once. */
  remove(group: number, control: ControlFrame): void {
    const virtual = this.holderOf(control, group);
    if (virtual) this.controls_ = this.controls_.filter((other) => other !== virtual);
    this.tell({ kind: 'editControl', group, control: control.id, edit: 'remove' });
  }

  togglePin(group: number, control: ControlFrame, time: number): void {
    const pinned = !control.pinned;
    this.tell({ kind: 'editControl', group, control: control.id, edit: pinned ? 'pin' : 'release' });
    const virtual = this.holderOf(control, group);
    if (!virtual) return;
    virtual.pinned = pinned;
    if (pinned) return;
    virtual.keep = false;
    if (virtual.drags === 0) this.letGo(virtual, time);
  }

  /** Our newest control in this frame, for keys without a pointer: touches count on, ids only within a group. */
  newestIn(frame: StudioFrame): OwnControl | null {
    const age = ({ control }: OwnControl): number => Math.max(...control.points.map(({ touch }) => touch));
    return this.ownIn(frame).reduce<OwnControl | null>(
      (best, own) => (best && age(best) >= age(own) ? best : own),
      null,
    );
  }

  /** The control in this frame that a drag holds. */
  draggedIn(frame: StudioFrame): OwnControl | null {
    const dragged = this.controls_.filter((virtual) => virtual.drags > 0);
    return (
      this.ownIn(frame).find(({ group, control }) =>
        dragged.some((virtual) => this.matches(virtual, control, group)),
      ) ?? null
    );
  }

  /** Learns the numbers of new controls, pins those that shall be, forgets those that are gone. */
  observe(frame: StudioFrame): void {
    this.step_ = frame.step;
    const shown = this.ownIn(frame);
    for (const virtual of [...this.controls_]) {
      const control = shown.find((own) => this.matches(virtual, own.control, own.group))?.control;
      if (control && virtual.control === 0) {
        virtual.control = control.id;
        if (virtual.pinned) this.tell({ kind: 'editControl', group: virtual.group, control: control.id, edit: 'pin' });
      }
      const refused =
        virtual.control === 0 &&
        (frame.step < virtual.bornAtStep || frame.step - virtual.bornAtStep > kRefusedAfterSteps);
      if (!control && (virtual.control !== 0 || refused))
        this.controls_ = this.controls_.filter((other) => other !== virtual);
    }
  }

  clear(): void {
    this.controls_ = [];
  }

  private tell(command: Command): void {
    this.client_.send({ type: 'Commands', commands: [command] });
  }

  private ownIn(frame: StudioFrame | null): OwnControl[] {
    const me = this.clientId_();
    const own = ({ id, controls }: StudioGroup): OwnControl[] =>
      controls.filter((control) => control.client === me).map((control) => ({ group: id, control }));
    return frame?.groups.flatMap(own) ?? [];
  }

  private holderOf(control: ControlFrame, group: number): VirtualControl | undefined {
    return this.controls_.find(
      (virtual) =>
        (virtual.group === group && virtual.replaced === control.id) || this.matches(virtual, control, group),
    );
  }

  private matches(virtual: VirtualControl, control: ControlFrame, group: number): boolean {
    if (virtual.group !== group || control.client !== this.clientId_()) return false;
    return control.points.some((point) => virtual.fingers.some((finger) => finger.touch === point.touch));
  }
}
