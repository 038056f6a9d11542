// Forwards pointers and keys as they come: a control scheme at the server judges them.

import { InputKind, PointerButton, PointerDevice, TouchPhase, type RawInput } from '../protocol/messages';
import type { MessageSender } from '../link/studio_client';
import { pageClock } from '../model/page_clock';
import type { SeenGround } from '../scene/camera/camera_controls';
import type { Contact, ContactOwner } from './contact';

/** A pixel of a display of 96 dpi. */
export const kUsualPixel = 25.4 / 96;
/** Least time between two messages with moves [ms]. */
const kSpacing = 8;
const kDevices = { touch: PointerDevice.Touch, pen: PointerDevice.Pen, mouse: PointerDevice.Mouse } as const;
const kButtons = [PointerButton.Left, PointerButton.Middle, PointerButton.Right] as const;
const kEscape = 27;
const kDelete = 127;

const kNoInput: RawInput = {
  kind: InputKind.Pointer,
  phase: TouchPhase.Move,
  device: PointerDevice.Mouse,
  button: PointerButton.Left,
  pointer: 0,
  key: 0,
  x: 0,
  y: 0,
  time: 0,
  shift: false,
  control: false,
  alt: false,
};

/** The number of a key as control schemes know it; 0 for others. */
export function keyNumber(event: Pick<KeyboardEvent, 'key' | 'code'>): number {
  if (event.key === 'Escape') return kEscape;
  if (event.key === 'Delete') return kDelete;
  // With Shift a digit gives another character.
  const digit = /^(?:Digit|Numpad)([0-9])$/.exec(event.code);
  if (digit) return digit[1]!.charCodeAt(0);
  return /^[a-z]$/i.test(event.key) ? event.key.toUpperCase().charCodeAt(0) : 0;
}

/** True for the keys that a control scheme knows; all others keep what they mean on the page. */
export function isKeyOf(scheme: string, event: Pick<KeyboardEvent, 'key' | 'code' | 'ctrlKey' | 'metaKey'>): boolean {
  const key = keyNumber(event);
  if (key === 0) return false;
  const letter = String.fromCharCode(key);
  if (scheme === 'mouse-mesh') return key === kEscape || key === kDelete || letter === 'P';
  if (!scheme.startsWith('mouse-full')) return false;
  if (letter === 'A') return event.ctrlKey || event.metaKey;
  return key === kEscape || letter === 'S' || /[0-9]/.test(letter);
}

export class RawInputs implements ContactOwner {
  /** Size of a pixel of the display [mm]. */
  mmPerPixel = kUsualPixel;
  private queue_: RawInput[] = [];
  private lastSent_ = -Infinity;
  private sentView_ = '';
  /** The button that each pointer came down with. */
  private readonly buttons_ = new Map<number, PointerButton>();

  /** `sent` hears the time of every move and press that leaves, for the measurement of latency. */
  constructor(
    private readonly client_: MessageSender,
    private readonly seen_: () => SeenGround,
    private readonly sent_: (time: number) => void = () => undefined,
    private readonly now_: () => number = () => performance.now(),
  ) {}

  /** After a lost connection, or with a new scheme, the server has to be told anew. */
  forget(): void {
    this.queue_ = [];
    this.buttons_.clear();
    this.sentView_ = '';
  }

  begin(contact: Contact): void {
    this.buttons_.set(contact.pointer, kButtons[contact.button] ?? PointerButton.Left);
    this.push(contact, TouchPhase.Down);
    this.flush();
  }

  move(contacts: readonly Contact[]): void {
    for (const contact of contacts) this.push(contact, TouchPhase.Move);
    if (this.now_() - this.lastSent_ >= kSpacing) this.flush();
  }

  end(contact: Contact, cancelled: boolean): void {
    this.push(contact, cancelled ? TouchPhase.Cancel : TouchPhase.Up);
    this.buttons_.delete(contact.pointer);
    this.flush();
  }

  /** False for a key that no scheme knows. */
  key(event: KeyboardEvent): boolean {
    const key = keyNumber(event);
    if (key === 0) return false;
    const { shiftKey: shift, altKey: alt } = event;
    const control = event.ctrlKey || event.metaKey;
    const time = pageClock(event.timeStamp);
    this.queue_.push({ ...kNoInput, kind: InputKind.Key, key, time, shift, control, alt });
    this.flush();
    return true;
  }

  /** Tells how the scene is seen, where that changed. */
  look(): void {
    const { matrix, width, height } = this.seen_();
    const view = [...matrix, width, height, this.mmPerPixel].join();
    if (view === this.sentView_) return;
    this.sentView_ = view;
    const { mmPerPixel } = this;
    this.client_.send({ type: 'SetView', matrix: Float64Array.from(matrix), width, height, mmPerPixel });
  }

  /** Sends what waits; once per picture. */
  flush(): void {
    if (this.queue_.length === 0) return;
    this.look();
    const events = this.queue_;
    this.queue_ = [];
    this.lastSent_ = this.now_();
    this.client_.send({ type: 'Inputs', events });
    for (const event of events) if (event.phase <= TouchPhase.Move) this.sent_(event.time);
  }

  private push(contact: Contact, phase: TouchPhase): void {
    const { pointer, kind, screen, time, shift, alt, control } = contact;
    this.queue_.push({
      ...kNoInput,
      phase,
      device: kDevices[kind],
      button: this.buttons_.get(pointer) ?? PointerButton.Left,
      pointer: pointer >>> 0,
      x: screen.x,
      y: screen.y,
      time,
      shift,
      control: control ?? false,
      // `alt` of a contact stands for Ctrl as well.
      alt: alt && !(control ?? false),
    });
  }
}
