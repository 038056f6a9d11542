// A finger draws the outline that a formation takes up.

import type { GroundPoint } from '../model/plane';
import type { Contact, ContactOwner } from './contact';

export interface OutlineSink {
  /** What is drawn so far, to show; null at the end. */
  previewOutline(points: readonly GroundPoint[] | null): void;
  /** The whole stroke. */
  outlineDrawn(stroke: readonly GroundPoint[]): void;
}

/** Points nearer than this to the last are left out [m]. */
const kStep = 0.05;

export class OutlineDraw implements ContactOwner {
  private readonly stroke_: GroundPoint[] = [];

  constructor(private readonly sink_: OutlineSink) {}

  begin(contact: Contact): void {
    this.add(contact);
  }

  move(contacts: readonly Contact[]): void {
    for (const contact of contacts) this.add(contact);
    this.sink_.previewOutline(this.stroke_);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.sink_.previewOutline(null);
    if (cancelled) return;
    this.add(contact);
    this.sink_.outlineDrawn(this.stroke_);
  }

  private add({ ground }: Contact): void {
    const last = this.stroke_[this.stroke_.length - 1];
    if (ground && (!last || Math.hypot(ground.x - last.x, ground.y - last.y) >= kStep)) this.stroke_.push(ground);
  }
}

/** A press puts down what is held. */
export class PlacePress implements ContactOwner {
  private at_: GroundPoint | null = null;

  constructor(
    private readonly preview_: (at: GroundPoint | null) => void,
    private readonly placed_: (at: GroundPoint) => void,
  ) {}

  begin({ ground }: Contact): void {
    this.show(ground);
  }

  move(contacts: readonly Contact[]): void {
    this.show(contacts[contacts.length - 1]!.ground);
  }

  end(_contact: Contact, cancelled: boolean): void {
    this.preview_(null);
    if (!cancelled && this.at_) this.placed_(this.at_);
  }

  private show(ground: GroundPoint | null): void {
    if (ground) this.at_ = ground;
    this.preview_(this.at_);
  }
}
