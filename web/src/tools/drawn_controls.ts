// Owners of contacts that draw a whole control (rubber band, lasso) or drag one that stands.

import { ControlKind } from '../protocol/messages';
import type { Contact, ContactOwner } from './contact';
import type { Grab } from './grab';
import { distance, type GroundPoint } from '../model/plane';
import type { VirtualControl, VirtualControls, VirtualFinger } from './virtual_controls';
import { lassoCorners } from './lasso';
import type { TouchMarks } from './touch_editor';

/** Shows a control while it is being drawn. */
export interface ControlPreview {
  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void;
}

export interface DrawTarget {
  readonly index: number;
  readonly group: number;
}

export interface AreaTarget extends DrawTarget {
  readonly corners: readonly GroundPoint[];
}

const kShortestLine = 0.5;

/** Press at one end, release at the other. */
export class RubberBand implements ContactOwner {
  private from_: GroundPoint | null = null;
  private to_: GroundPoint | null = null;

  constructor(
    private readonly target_: DrawTarget,
    private readonly controls_: VirtualControls,
    private readonly preview_: ControlPreview,
  ) {}

  begin(contact: Contact): void {
    this.from_ = contact.ground;
    this.to_ = contact.ground;
  }

  move(contacts: readonly Contact[]): void {
    this.to_ = contacts[contacts.length - 1]!.ground ?? this.to_;
    if (this.from_ && this.to_) this.preview_.previewControl(this.target_.index, [this.from_, this.to_], false);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.preview_.previewControl(this.target_.index, null, false);
    const { from_: from, to_: to } = this;
    if (cancelled || !from || !to || distance(from, to) < kShortestLine) return;
    const { group } = this.target_;
    this.controls_.create({
      group,
      kind: ControlKind.Line,
      positions: [from, to],
      time: contact.time,
      keep: true,
      pinned: false,
    });
  }
}

/** A loop drawn round a part of the mesh; its hull becomes an area. */
export class Lasso implements ContactOwner {
  private readonly loop_: GroundPoint[] = [];

  /** `targetOf` picks the formation once the loop is known, and which of its corners hold a point of the mesh each. */
  constructor(
    private readonly targetOf_: (corners: readonly GroundPoint[]) => AreaTarget | null,
    private readonly shownFor_: number,
    private readonly controls_: VirtualControls,
    private readonly preview_: ControlPreview,
  ) {}

  begin(contact: Contact): void {
    if (contact.ground) this.loop_.push(contact.ground);
  }

  move(contacts: readonly Contact[]): void {
    for (const { ground } of contacts) if (ground) this.loop_.push(ground);
    this.preview_.previewControl(this.shownFor_, this.loop_, true);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.preview_.previewControl(this.shownFor_, null, true);
    const target = cancelled || this.loop_.length < 3 ? null : this.targetOf_(lassoCorners(this.loop_));
    if (!target) return;
    const { group, corners: positions } = target;
    this.controls_.create({ group, kind: ControlKind.Area, positions, time: contact.time, keep: true, pinned: false });
  }
}

/** Drags an end, a bar or an area that stands. */
export class ControlDrag implements ContactOwner {
  private control_: VirtualControl | null = null;
  private start_: GroundPoint | null = null;
  private fingers_: readonly { readonly finger: VirtualFinger; readonly from: GroundPoint }[] = [];

  constructor(
    private readonly grab_: Grab,
    private readonly controls_: VirtualControls,
    private readonly marks_: TouchMarks,
  ) {}

  begin(contact: Contact): void {
    if (!contact.ground) return;
    const virtual = this.controls_.take(this.grab_, contact.time);
    virtual.drags += 1;
    this.control_ = virtual;
    this.start_ = contact.ground;
    this.fingers_ = this.controls_.fingersOf(virtual, this.grab_).map((finger) => ({ finger, from: finger.at }));
    this.mark(contact, contact.ground);
  }

  move(contacts: readonly Contact[]): void {
    const { control_: control, start_: start } = this;
    if (!control || !start) return;
    for (const contact of contacts) {
      const { ground, time } = contact;
      if (!ground) continue;
      for (const { finger, from } of this.fingers_) {
        const at = { x: from.x + ground.x - start.x, y: from.y + ground.y - start.y };
        this.controls_.move(control, finger, at, time);
      }
      this.mark(contact, ground);
    }
  }

  end(contact: Contact): void {
    this.mark(contact, null);
    if (this.control_) this.controls_.release(this.control_, contact.time);
    this.control_ = null;
  }

  /** Rings of fingers have the touch as id, which is positive; this ring belongs to no path. */
  private mark({ pointer }: Contact, at: GroundPoint | null): void {
    this.marks_.touchMark(-1 - pointer, at, this.grab_.index);
  }
}
