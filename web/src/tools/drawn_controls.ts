// Owners of contacts that draw a whole control (rubber band, lasso) or drag one that stands.

import { ControlKind } from '../protocol/messages';
import type { GroundPoint } from '../view/camera_types';
import type { Contact, ContactOwner } from './contact';
import type { Grab } from './grab';
import { distance } from '../geometry/plane';
import type { Held, HeldControls, HeldFinger } from './held_controls';
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

const SHORTEST_LINE = 0.5;

/** Press at one end, release at the other. */
export class RubberBand implements ContactOwner {
  private from: GroundPoint | null = null;
  private to: GroundPoint | null = null;

  constructor(
    private readonly target: DrawTarget,
    private readonly controls: HeldControls,
    private readonly preview: ControlPreview,
  ) {}

  begin(contact: Contact): void {
    this.from = contact.ground;
    this.to = contact.ground;
  }

  move(contacts: readonly Contact[]): void {
    this.to = contacts[contacts.length - 1]!.ground ?? this.to;
    if (this.from && this.to) this.preview.previewControl(this.target.index, [this.from, this.to], false);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.preview.previewControl(this.target.index, null, false);
    const { from, to } = this;
    if (cancelled || !from || !to || distance(from, to) < SHORTEST_LINE) return;
    const { group } = this.target;
    this.controls.create({
      group, kind: ControlKind.Line, positions: [from, to], time: contact.time, keep: true, pinned: false,
    });
  }
}

/** A loop drawn round a part of the mesh; its hull becomes an area. */
export class Lasso implements ContactOwner {
  private readonly loop: GroundPoint[] = [];

  /** `targetOf` picks the formation once the loop is known. */
  constructor(
    private readonly targetOf: (corners: readonly GroundPoint[]) => DrawTarget | null,
    private readonly shownFor: number,
    private readonly controls: HeldControls,
    private readonly preview: ControlPreview,
  ) {}

  begin(contact: Contact): void {
    if (contact.ground) this.loop.push(contact.ground);
  }

  move(contacts: readonly Contact[]): void {
    for (const { ground } of contacts) if (ground) this.loop.push(ground);
    this.preview.previewControl(this.shownFor, this.loop, true);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.preview.previewControl(this.shownFor, null, true);
    const positions = cancelled ? [] : lassoCorners(this.loop);
    const target = positions.length >= 3 ? this.targetOf(positions) : null;
    if (!target) return;
    const { group } = target;
    this.controls.create({ group, kind: ControlKind.Area, positions, time: contact.time, keep: true, pinned: false });
  }
}

/** Drags an end, a bar or an area that stands. */
export class ControlDrag implements ContactOwner {
  private held: Held | null = null;
  private start: GroundPoint | null = null;
  private fingers: readonly { readonly finger: HeldFinger; readonly from: GroundPoint }[] = [];

  constructor(
    private readonly grab: Grab,
    private readonly controls: HeldControls,
    private readonly marks: TouchMarks,
  ) {}

  begin(contact: Contact): void {
    if (!contact.ground) return;
    const held = this.controls.take(this.grab, contact.time);
    held.drags += 1;
    this.held = held;
    this.start = contact.ground;
    this.fingers = this.controls.fingersOf(held, this.grab).map((finger) => ({ finger, from: finger.at }));
    this.mark(contact, contact.ground);
  }

  move(contacts: readonly Contact[]): void {
    const { held, start } = this;
    if (!held || !start) return;
    for (const contact of contacts) {
      const { ground, time } = contact;
      if (!ground) continue;
      for (const { finger, from } of this.fingers) {
        const at = { x: from.x + ground.x - start.x, y: from.y + ground.y - start.y };
        this.controls.move(held, finger, at, time);
      }
      this.mark(contact, ground);
    }
  }

  end(contact: Contact): void {
    this.mark(contact, null);
    if (this.held) this.controls.release(this.held, contact.time);
    this.held = null;
  }

  /** Rings of fingers are known by their touch, which is positive; this one is at no end of a path. */
  private mark({ pointer }: Contact, at: GroundPoint | null): void {
    this.marks.touchMark(-1 - pointer, at, this.grab.index);
  }
}
