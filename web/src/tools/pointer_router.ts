// From the browser's pointer events to contacts, each owned by one tool from its start to its end.

import { pageClock } from '../engine/latency_meter';
import type { GroundPoint, ScreenPoint } from '../view/camera_types';
import type { Contact, ContactOwner } from './contact';

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

const MOST_TOUCHES = 10;
const TAP_PX = 8;
const TAP_SECONDS = 0.35;
const LINE_PX = 16;

export class PointerRouter {
  private readonly owned = new Map<number, Owned>();

  constructor(
    private readonly surface: HTMLElement,
    private readonly toGround: (at: ScreenPoint) => GroundPoint | null,
    private readonly handlers: RouterHandlers,
  ) {
    surface.addEventListener('pointerdown', (event) => this.down(event));
    surface.addEventListener('pointermove', (event) => this.moved(event));
    surface.addEventListener('pointerrawupdate', (event) => this.rawMoved(event as PointerEvent));
    surface.addEventListener('pointerup', (event) => this.up(event, false));
    surface.addEventListener('pointercancel', (event) => this.up(event, true));
    surface.addEventListener('lostpointercapture', (event) => this.up(event, true));
    surface.addEventListener('dblclick', (event) => this.doubleClick(event));
    surface.addEventListener('wheel', (event) => this.wheeled(event), { passive: false });
    surface.addEventListener('contextmenu', (event) => event.preventDefault());
    surface.addEventListener('mousedown', (event) => {
      if (event.button === 1) event.preventDefault();
    });
  }

  /** Contacts that are down. */
  get count(): number {
    return this.owned.size;
  }

  private down(event: PointerEvent): void {
    const contact = this.contactOf(event);
    if (this.owned.has(event.pointerId) || this.owned.size >= MOST_TOUCHES) return;
    // The scene answers to keys from now on; a ring is for those who came by keyboard.
    const quietly: FocusOptions & { focusVisible: boolean } = { preventScroll: true, focusVisible: false };
    this.surface.focus(quietly);
    try {
      this.surface.setPointerCapture(event.pointerId);
    } catch {
      // The pointer has gone in the meantime: its end will come as an event.
    }
    this.handlers.pointed(contact);
    const owner = this.handlers.choose(contact);
    this.owned.set(event.pointerId, { owner, from: contact, still: true, raw: false });
    owner.begin(contact);
  }

  private moved(event: PointerEvent): void {
    const owned = this.owned.get(event.pointerId);
    if (!owned) {
      this.handlers.pointed(this.contactOf(event));
      return;
    }
    if (!owned.raw) this.follow(owned, event);
  }

  /** Browsers keep pointermove back until just before the next drawn frame; raw updates come at once. */
  private rawMoved(event: PointerEvent): void {
    const owned = this.owned.get(event.pointerId);
    if (!owned) return;
    owned.raw = true;
    this.follow(owned, event);
  }

  private follow(owned: Owned, event: PointerEvent): void {
    const coalesced = event.getCoalescedEvents?.() ?? [];
    const contacts = (coalesced.length > 0 ? coalesced : [event]).map((one) => this.contactOf(one));
    const { screen } = contacts[contacts.length - 1]!;
    const { from } = owned;
    owned.still &&= Math.hypot(screen.x - from.screen.x, screen.y - from.screen.y) <= TAP_PX;
    owned.owner.move(contacts);
  }

  private up(event: PointerEvent, cancelled: boolean): void {
    const owned = this.owned.get(event.pointerId);
    if (!owned) return;
    this.owned.delete(event.pointerId);
    const contact = this.contactOf(event);
    owned.owner.end(contact, cancelled);
    if (!cancelled && owned.still && contact.time - owned.from.time < TAP_SECONDS) this.handlers.tapped(contact);
  }

  private doubleClick(event: MouseEvent): void {
    const { button, shiftKey: shift, altKey: alt } = event;
    const at = this.placeOf(event);
    this.handlers.doubleClicked({ ...at, pointer: -1, kind: 'mouse', time: pageClock(event.timeStamp), button, shift, alt });
  }

  private wheeled(event: WheelEvent): void {
    event.preventDefault();
    const delta = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_PX : 1);
    // A pinch on a touch pad arrives as a wheel with Ctrl and far smaller steps.
    const perPx = event.ctrlKey ? 0.01 : 0.0016;
    this.handlers.wheel(this.placeOf(event).screen, Math.exp(-delta * perPx));
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
    };
  }

  private placeOf(event: MouseEvent): { screen: ScreenPoint; ground: GroundPoint | null } {
    const box = this.surface.getBoundingClientRect();
    const screen = { x: event.clientX - box.left, y: event.clientY - box.top };
    return { screen, ground: this.toGround(screen) };
  }
}
