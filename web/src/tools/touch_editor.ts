// Owns contacts that begin on a formation. Each is sent as a finger, from which the server makes controls.

import type { Contact, ContactOwner } from './contact';
import { kNoDrafts, type DraftBook } from './drafts';
import type { FormationHit } from './formation_hit_test';
import type { TouchSender } from './touch_sender';
import type { GroundPoint } from '../model/plane';

/** The ring under a finger, drawn in the very next picture; its id is the touch, or negative. */
export interface TouchMarks {
  touchMark(id: number, world: GroundPoint | null, groupIndex: number): void;
}

interface Finger {
  readonly touch: number;
  readonly index: number;
  readonly group: number;
  readonly from: Contact;
  last: GroundPoint;
  moved: boolean;
}

const kStillPx = 4;

export class TouchEditor {
  private readonly fingers_ = new Map<number, Finger>();

  constructor(
    private readonly sender_: TouchSender,
    private readonly marks_: TouchMarks,
    private readonly drafts_: DraftBook = kNoDrafts,
  ) {}

  /** Fingers that are down. */
  get count(): number {
    return this.fingers_.size;
  }

  /** The owner of a contact that began on this formation. */
  ownerFor(hit: FormationHit): ContactOwner {
    return {
      begin: (contact) => this.begin(contact, hit),
      move: (contacts) => this.move(contacts),
      end: (contact, cancelled) => this.end(contact, cancelled),
    };
  }

  private begin(contact: Contact, hit: FormationHit): void {
    if (!contact.ground) return;
    const touch = this.sender_.nextTouch();
    this.fingers_.set(contact.pointer, {
      touch,
      index: hit.index,
      group: hit.group,
      from: contact,
      last: contact.ground,
      moved: false,
    });
    this.marks_.touchMark(touch, contact.ground, hit.index);
    this.sender_.down(touch, contact.ground, contact.time, hit.group);
    this.drafts_.add(touch, hit.group, contact.ground, contact.time);
  }

  private move(contacts: readonly Contact[]): void {
    for (const contact of contacts) {
      const finger = this.fingers_.get(contact.pointer);
      if (!finger || !contact.ground) continue;
      const dx = contact.screen.x - finger.from.screen.x;
      const dy = contact.screen.y - finger.from.screen.y;
      finger.moved ||= Math.hypot(dx, dy) > kStillPx;
      finger.last = contact.ground;
      this.sender_.move(finger.touch, contact.ground, contact.time);
      this.marks_.touchMark(finger.touch, contact.ground, finger.index);
      this.drafts_.add(finger.touch, finger.group, contact.ground, contact.time);
    }
    this.sender_.moved();
  }

  private end(contact: Contact, cancelled: boolean): void {
    const finger = this.fingers_.get(contact.pointer);
    if (!finger) return;
    this.fingers_.delete(contact.pointer);
    this.marks_.touchMark(finger.touch, null, finger.index);
    // A click that drew nothing must leave no control behind, as that would catch the second click of a double click.
    const dropped = cancelled || (contact.kind === 'mouse' && !finger.moved);
    if (dropped) this.drafts_.drop(finger.touch);
    if (dropped) this.sender_.cancel(finger.touch, finger.last, contact.time);
    else this.sender_.up(finger.touch, contact.ground ?? finger.last, contact.time);
  }
}
