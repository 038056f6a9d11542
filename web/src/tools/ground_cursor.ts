// A cursor on the ground, for keys alone: arrows move it, and Enter begins and ends what a mouse would draw there.

import type { HandMoves } from '../scene/camera/camera_controls';
import { pageClock } from '../model/page_clock';
import type { GroundPoint, ScreenPoint } from '../model/plane';
import type { Contact, ContactOwner } from './contact';
import { groundAxes } from './ground_axes';
import { arrowStep, type ArrowKey } from './keyboard_steering';

export interface CursorHost {
  readonly view: {
    screenToWorld(at: ScreenPoint): GroundPoint | null;
    worldToScreen(at: GroundPoint): ScreenPoint;
  };
  readonly camera: Pick<HandMoves, 'panBy'>;
  /** Null while it is away. */
  show(at: GroundPoint | null): void;
  /** What panels leave free of the picture [CSS px]. */
  room(): { readonly from: ScreenPoint; readonly to: ScreenPoint };
  choose(contact: Contact): ContactOwner;
  /** One Enter is all: the tool takes a spot, no stroke. */
  picks(): boolean;
  /** What is there. */
  words(at: GroundPoint): string;
  /** What would come of what is drawn; empty where that is not known. */
  forecast(): string;
  say(text: string): void;
}

/** No pointer of the browser has this number. */
const kPointer = -2;
/** A forecast is told once the cursor has rested for so long, or, where it has not come by then, once more [ms]. */
const kRest = 900;
/** Near the room is within it [CSS px], and so many moves bring the camera there. */
const kSlack = 12;
const kPans = 4;

export class GroundCursor {
  private at_: GroundPoint | null = null;
  private shown_ = false;
  private stroke_: { readonly owner: ContactOwner; readonly from: Contact } | null = null;
  private rest_ = 0;

  constructor(private readonly host_: CursorHost) {}

  /** Something is being drawn. */
  get draws(): boolean {
    return this.stroke_ !== null;
  }

  show(): void {
    if (this.shown_) return;
    this.shown_ = true;
    if (!this.at_ || !this.isInSight(this.at_)) this.at_ = this.middle();
    this.moved();
  }

  hide(): void {
    this.giveUp();
    this.shown_ = false;
    this.host_.show(null);
  }

  arrow(key: ArrowKey, long: boolean): void {
    this.show();
    if (!this.at_) return;
    const axes = groundAxes((at) => this.host_.view.screenToWorld(at), this.centre());
    const step = arrowStep(key, long, axes);
    const next = { x: this.at_.x + step.x, y: this.at_.y + step.y };
    this.follow(next);
    // The camera keeps to the place: who went on would be out of sight.
    if (this.isInSight(next)) this.at_ = next;
    if (this.stroke_) this.stroke_.owner.move([this.contact()]);
    this.moved();
  }

  /** Enter. */
  press(shift: boolean): void {
    this.show();
    if (!this.at_) return;
    if (this.stroke_) return this.end(shift, false);
    const from = this.contact(shift);
    const owner = this.host_.choose(from);
    this.stroke_ = { owner, from };
    owner.begin(from);
    if (this.host_.picks()) return this.end(shift, false);
    this.host_.say('Begun here: arrows draw, Enter ends, Escape gives up');
    this.tellForecast();
  }

  /** Drops what is being drawn; false where nothing is. */
  giveUp(): boolean {
    if (!this.stroke_) return false;
    this.end(false, true);
    this.host_.say('Given up');
    return true;
  }

  private end(shift: boolean, cancelled: boolean): void {
    const stroke = this.stroke_;
    window.clearTimeout(this.rest_);
    const contact = this.contact(shift);
    this.stroke_ = null;
    stroke?.owner.end(contact, cancelled);
  }

  private moved(): void {
    if (!this.at_) return;
    this.host_.show(this.at_);
    this.host_.say(this.host_.words(this.at_));
    this.tellForecast();
  }

  private tellForecast(again = true): void {
    window.clearTimeout(this.rest_);
    this.rest_ = window.setTimeout(() => {
      const text = this.stroke_ && this.at_ ? this.host_.forecast() : '';
      if (text !== '') this.host_.say(`${this.host_.words(this.at_!)}: ${text}`);
      else if (this.stroke_ && again) this.tellForecast(false);
    }, kRest);
  }

  /** Where a mouse would be, had the camera stood still since the stroke began: tools tell a click from a drag by that. */
  private contact(shift = false): Contact {
    const ground = this.at_!;
    const from = this.stroke_?.from;
    const [now, then] = [ground, from?.ground ?? ground].map((at) => this.host_.view.worldToScreen(at)) as [
      ScreenPoint,
      ScreenPoint,
    ];
    const screen = from ? { x: from.screen.x + now.x - then.x, y: from.screen.y + now.y - then.y } : now;
    return { pointer: kPointer, kind: 'mouse', screen, ground, time: pageClock(), button: 0, shift, alt: false };
  }

  private middle(): GroundPoint | null {
    return this.host_.view.screenToWorld(this.centre());
  }

  /** The middle of the room between the panels. */
  private centre(): ScreenPoint {
    const { from, to } = this.host_.room();
    return { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  }

  private isInSight(at: GroundPoint): boolean {
    const { from, to } = this.host_.room();
    const { x, y } = this.host_.view.worldToScreen(at);
    return x >= from.x - kSlack && x <= to.x + kSlack && y >= from.y - kSlack && y <= to.y + kSlack;
  }

  /** The camera goes with a cursor that leaves the view. */
  private follow(at: GroundPoint): void {
    const { from, to } = this.host_.room();
    const back = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value)) - value;
    // What is far away moves less than the middle of the picture.
    for (let i = 0; i < kPans; ++i) {
      const { x, y } = this.host_.view.worldToScreen(at);
      const [dx, dy] = [back(x, from.x, to.x), back(y, from.y, to.y)];
      if (dx === 0 && dy === 0) return;
      this.host_.camera.panBy(dx, dy);
    }
  }
}
