// A box drawn with Shift on empty ground chooses the groups in it.

import type { GroundPoint, ScreenPoint } from '../model/plane';
import type { Contact, ContactOwner } from './contact';

export interface BoxSink {
  /** The corners on the ground, to show; null at the end. */
  previewBox(corners: readonly GroundPoint[] | null): void;
  chooseWithin(from: ScreenPoint, to: ScreenPoint): void;
}

export class BoxSelect implements ContactOwner {
  private from_: ScreenPoint | null = null;

  constructor(
    private readonly sink_: BoxSink,
    private readonly toGround_: (at: ScreenPoint) => GroundPoint | null,
  ) {}

  begin(contact: Contact): void {
    this.from_ = contact.screen;
  }

  move(contacts: readonly Contact[]): void {
    const { from_: from } = this;
    const to = contacts[contacts.length - 1]!.screen;
    if (!from) return;
    const corners = [from, { x: to.x, y: from.y }, to, { x: from.x, y: to.y }].map(this.toGround_);
    this.sink_.previewBox(corners.filter((corner) => corner !== null));
  }

  end(contact: Contact, cancelled: boolean): void {
    this.sink_.previewBox(null);
    if (!cancelled && this.from_) this.sink_.chooseWithin(this.from_, contact.screen);
    this.from_ = null;
  }
}
