// A finger, pen or mouse on the scene.

import type { GroundPoint, ScreenPoint } from '../model/plane';

export interface Contact {
  /** The browser's pointer id. */
  readonly pointer: number;
  readonly kind: 'touch' | 'pen' | 'mouse';
  readonly screen: ScreenPoint;
  /** Null above the horizon. */
  readonly ground: GroundPoint | null;
  /** Page clock [s]. */
  readonly time: number;
  readonly button: number;
  readonly shift: boolean;
  /** Alt or Ctrl. */
  readonly alt: boolean;
  /** Ctrl, or the command key. */
  readonly control?: boolean;
}

/** Owns a contact from its start to its end. */
export interface ContactOwner {
  begin(contact: Contact): void;
  /** All positions since the last call, oldest first; never empty. */
  move(contacts: readonly Contact[]): void;
  /** `cancelled`: the browser took the contact away. */
  end(contact: Contact, cancelled: boolean): void;
}
