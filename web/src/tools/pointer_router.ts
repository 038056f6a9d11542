// Turns the browser's pointer events into contacts. One tool owns a contact from its start to its end.

import type { Contact, ContactOwner } from './contact';
import type { GroundPoint, ScreenPoint } from '../model/plane';
import { pageClock } from '../model/page_clock';

export interface RouterHandlers {
  /** Decides who owns a contact that begins. */
  choose(contact: Contact): ContactOwner;
  /** A contact that ended soon and where it began. */
  tapped(contact: Contact): void;
  doubleClicked(contact: Contact): void;
  wheel(at: ScreenPoint, factor: number): void;
  /** The mouse moves without a button, or any contact begins. */
  pointed(contact: Contact): void;
}

interface Owned {
  readonly owner: ContactOwner;
  readonly from: Contact;
  still: boolean;
  /** Its moves come by pointerrawupdate, so that pointermove repeats them. */
  raw: boolean;
}

const kMostTouches = 10;
const kTapPx = 8;
const kTapSeconds = 0.35;
const kLinePx = 16;
/** A contact this wide or high is a palm when it comes down; when it grows so far, it has become one [CSS px]. */
const kPalm = { down: 64, grown: 110 };

/** A hand that rests on the screen is no finger. */
function isPalm({ pointerType, width, height }: PointerEvent, least: number): boolean {
  return pointerType === 'touch' && Math.max(width, height) >= least;
}

export class PointerRouter {
  private readonly owned_ = new Map<number, Owned>();

  constructor(
    private readonly surface_: HTMLElement,
    private readonly toGround_: (at: ScreenPoint) => GroundPoint | null,
    private readonly handlers_: RouterHandlers,
  ) {
    surface_.addEventListener('pointerdown', (event) => this.down(event));
    surface_.addEventListener('pointermove', (event) => this.moved(event));
    surface_.addEventListener('pointerrawupdate', (event) => this.rawMoved(event as PointerEvent));
    surface_.addEventListener('pointerup', (event) => this.up(event, false));
    surface_.addEventListener('pointercancel', (event) => this.up(event, true));
    surface_.addEventListener('lostpointercapture', (event) => this.up(event, true));
    surface_.addEventListener('dblclick', (event) => this.doubleClick(event));
    surface_.addEventListener('wheel', (event) => this.wheeled(event), { passive: false });
    surface_.addEventListener('contextmenu', (event) => event.preventDefault());
    surface_.addEventListener('mousedown', (event) => {
      if (event.button === 1) event.preventDefault();
    });
  }

  /** Contacts that are down. */
  get count(): number {
    return this.owned_.size;
  }

  private down(event: PointerEvent): void {
    if (isPalm(event, kPalm.down)) return;
    const contact = this.contactOf(event);
    if (this.owned_.has(event.pointerId) || this.owned_.size >= kMostTouches) return;
    // The scene takes the focus for its keys, without the focus ring, which is for keyboard users.
    const quietly: FocusOptions & { focusVisible: boolean } = { preventScroll: true, focusVisible: false };
    this.surface_.focus(quietly);
    try {
      this.surface_.setPointerCapture(event.pointerId);
    } catch {
      // The pointer has gone in the meantime: its end will come as an event.
    }
    this.handlers_.pointed(contact);
    const owner = this.handlers_.choose(contact);
    this.owned_.set(event.pointerId, { owner, from: contact, still: true, raw: false });
    owner.begin(contact);
  }

  private moved(event: PointerEvent): void {
    const owned = this.owned_.get(event.pointerId);
    if (!owned) {
      this.handlers_.pointed(this.contactOf(event));
      return;
    }
    if (!owned.raw) this.follow(owned, event);
  }

  /** Browsers hold pointermove back until just before the next picture; raw updates come at once. */
  private rawMoved(event: PointerEvent): void {
    const owned = this.owned_.get(event.pointerId);
    if (!owned) return;
    owned.raw = true;
    this.follow(owned, event);
  }

  private follow(owned: Owned, event: PointerEvent): void {
    if (isPalm(event, kPalm.grown)) {
      this.up(event, true);
      return;
    }
    const coalesced = event.getCoalescedEvents?.() ?? [];
    const contacts = (coalesced.length > 0 ? coalesced : [event]).map((one) => this.contactOf(one));
    const { screen } = contacts[contacts.length - 1]!;
    const { from } = owned;
    owned.still &&= Math.hypot(screen.x - from.screen.x, screen.y - from.screen.y) <= kTapPx;
    owned.owner.move(contacts);
  }

  private up(event: PointerEvent, cancelled: boolean): void {
    const owned = this.owned_.get(event.pointerId);
    if (!owned) return;
    this.owned_.delete(event.pointerId);
    const contact = this.contactOf(event);
    owned.owner.end(contact, cancelled);
    if (!cancelled && owned.still && contact.time - owned.from.time < kTapSeconds) this.handlers_.tapped(contact);
  }

  private doubleClick(event: MouseEvent): void {
    const { button, shiftKey: shift, altKey: alt } = event;
    const at = this.placeOf(event);
    this.handlers_.doubleClicked({
      ...at,
      pointer: -1,
      kind: 'mouse',
      time: pageClock(event.timeStamp),
      button,
      shift,
      alt,
    });
  }

  private wheeled(event: WheelEvent): void {
    event.preventDefault();
    const delta = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? kLinePx : 1);
    // A pinch on a touch pad arrives as a wheel with Ctrl and far smaller steps.
    const perPx = event.ctrlKey ? 0.01 : 0.0016;
    this.handlers_.wheel(this.placeOf(event).screen, Math.exp(-delta * perPx));
  }

  private contactOf(event: PointerEvent): Contact {
    const kind = event.pointerType === 'touch' || event.pointerType === 'pen' ? event.pointerType : 'mouse';
    return {
      ...this.placeOf(event),
      pointer: event.pointerId,
      kind,
      time: pageClock(event.timeStamp),
      button: event.button,
      shift: event.shiftKey,
      alt: event.altKey || event.ctrlKey,
      control: event.ctrlKey || event.metaKey,
    };
  }

  private placeOf(event: MouseEvent): { screen: ScreenPoint; ground: GroundPoint | null } {
    const box = this.surface_.getBoundingClientRect();
    const screen = { x: event.clientX - box.left, y: event.clientY - box.top };
    return { screen, ground: this.toGround_(screen) };
  }
}
