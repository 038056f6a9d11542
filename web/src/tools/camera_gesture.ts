// Contacts on empty ground move the camera: one pans, two pinch and turn.

import type { CameraControls } from '../scene/camera/camera_controls';
import type { Contact, ContactOwner } from './contact';
import type { ScreenPoint } from '../model/plane';

export class CameraGesture implements ContactOwner {
  private readonly fingers_ = new Map<number, ScreenPoint>();

  constructor(private readonly camera_: CameraControls) {}

  begin(contact: Contact): void {
    this.fingers_.set(contact.pointer, contact.screen);
  }

  move(contacts: readonly Contact[]): void {
    const newest = contacts[contacts.length - 1]!;
    const before = this.fingers_.get(newest.pointer);
    if (!before) return;
    this.fingers_.set(newest.pointer, newest.screen);
    // The two fingers that came first lead; a third only waits for one of them to lift.
    const [first, second] = [...this.fingers_.keys()];
    if (second === undefined) {
      this.camera_.pan(before, newest.screen);
    } else if (newest.pointer === first) {
      const other = this.fingers_.get(second)!;
      this.camera_.pinch([before, other], [newest.screen, other]);
    } else if (newest.pointer === second) {
      const other = this.fingers_.get(first!)!;
      this.camera_.pinch([other, before], [other, newest.screen]);
    }
  }

  end(contact: Contact): void {
    this.fingers_.delete(contact.pointer);
  }
}

/** Right drag: turns with sideways movement, tilts with the rest. */
export class OrbitGesture implements ContactOwner {
  private last_: ScreenPoint | null = null;

  constructor(private readonly camera_: CameraControls) {}

  begin(contact: Contact): void {
    this.last_ = contact.screen;
  }

  move(contacts: readonly Contact[]): void {
    const now = contacts[contacts.length - 1]!.screen;
    if (this.last_) this.camera_.orbit((this.last_.x - now.x) * 0.006, (now.y - this.last_.y) * 0.004);
    this.last_ = now;
  }

  end(): void {
    this.last_ = null;
  }
}
