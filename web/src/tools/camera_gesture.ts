// Contacts on empty ground move the camera: one pans, two pinch and turn.

import type { CameraControls, ScreenPoint } from '../view/camera_types';
import type { Contact, ContactOwner } from './contact';

export class CameraGesture implements ContactOwner {
  private readonly fingers = new Map<number, ScreenPoint>();

  constructor(private readonly camera: CameraControls) {}

  begin(contact: Contact): void {
    this.fingers.set(contact.pointer, contact.screen);
  }

  move(contacts: readonly Contact[]): void {
    const newest = contacts[contacts.length - 1]!;
    const before = this.fingers.get(newest.pointer);
    if (!before) return;
    this.fingers.set(newest.pointer, newest.screen);
    // The two fingers that came first lead; a third only waits for one of them to lift.
    const [first, second] = [...this.fingers.keys()];
    if (second === undefined) {
      this.camera.pan(before, newest.screen);
    } else if (newest.pointer === first) {
      const other = this.fingers.get(second)!;
      this.camera.pinch([before, other], [newest.screen, other]);
    } else if (newest.pointer === second) {
      const other = this.fingers.get(first!)!;
      this.camera.pinch([other, before], [other, newest.screen]);
    }
  }

  end(contact: Contact): void {
    this.fingers.delete(contact.pointer);
  }
}

/** Right drag: turns with sideways movement, tilts with the rest. */
export class OrbitGesture implements ContactOwner {
  private last: ScreenPoint | null = null;

  constructor(private readonly camera: CameraControls) {}

  begin(contact: Contact): void {
    this.last = contact.screen;
  }

  move(contacts: readonly Contact[]): void {
    const now = contacts[contacts.length - 1]!.screen;
    if (this.last) this.camera.orbit((this.last.x - now.x) * 0.006, (now.y - this.last.y) * 0.004);
    this.last = now;
  }

  end(): void {
    this.last = null;
  }
}
