// Contacts on empty ground move the camera: one pans, two pinch and turn, or tilt where both go up or down side by side.

import type { HandMoves } from '../scene/camera/camera_controls';
import type { Contact, ContactOwner } from './contact';
import type { ScreenPoint } from '../model/plane';

/** What two fingers do becomes clear after these ways of both, or of one alone [CSS px]. */
const kClear = { both: 9, alone: 20 };
/** Fingers that tilt go this much more up or down than to a side, and stand this much more beside each other. */
const kUpright = 1.8;
/** [rad per CSS px] */
const kTilt = 0.0045;

/** What two fingers do, from where they began. */
interface Pair {
  readonly from: readonly [ScreenPoint, ScreenPoint];
  does: 'unclear' | 'pinch' | 'tilt';
}

export class CameraGesture implements ContactOwner {
  private readonly fingers_ = new Map<number, ScreenPoint>();
  private pair_: Pair | null = null;

  constructor(private readonly camera_: HandMoves) {}

  begin(contact: Contact): void {
    this.fingers_.set(contact.pointer, contact.screen);
    if (this.fingers_.size === 2) this.pair_ = { from: this.leading(), does: 'unclear' };
  }

  move(contacts: readonly Contact[]): void {
    const newest = contacts[contacts.length - 1]!;
    const before = this.fingers_.get(newest.pointer);
    if (!before) return;
    this.fingers_.set(newest.pointer, newest.screen);
    if (this.fingers_.size === 1) {
      this.camera_.pan(before, newest.screen);
      return;
    }
    // The two fingers that came first lead; a third only waits for one of them to lift.
    const [first, second] = [...this.fingers_.keys()];
    if (newest.pointer !== first && newest.pointer !== second) return;
    const now = this.leading();
    this.moveTwo(newest.pointer === first ? [before, now[1]] : [now[0], before], now);
  }

  end(contact: Contact): void {
    this.fingers_.delete(contact.pointer);
    this.pair_ = this.fingers_.size < 2 ? null : { from: this.leading(), does: 'pinch' };
  }

  private leading(): [ScreenPoint, ScreenPoint] {
    const [first, second] = [...this.fingers_.values()];
    return [first!, second!];
  }

  private moveTwo(before: readonly [ScreenPoint, ScreenPoint], now: readonly [ScreenPoint, ScreenPoint]): void {
    const pair = (this.pair_ ??= { from: before, does: 'pinch' });
    const unclear = pair.does === 'unclear';
    if (unclear) pair.does = whatTwoDo(pair.from, now);
    // The way up to here was not shown yet.
    const from = unclear ? pair.from : before;
    if (pair.does === 'pinch') this.camera_.pinch(from, now);
    if (pair.does === 'tilt') this.camera_.orbit(0, (kTilt * (now[0].y + now[1].y - from[0].y - from[1].y)) / 2);
  }
}

/** By how two fingers have moved since they came down. */
function whatTwoDo(from: readonly [ScreenPoint, ScreenPoint], now: readonly [ScreenPoint, ScreenPoint]): Pair['does'] {
  const ways = now.map((at, i) => ({ x: at.x - from[i]!.x, y: at.y - from[i]!.y })) as [ScreenPoint, ScreenPoint];
  const lengths = ways.map(({ x, y }) => Math.hypot(x, y)) as [number, number];
  if (Math.min(...lengths) < kClear.both) return Math.max(...lengths) > kClear.alone ? 'pinch' : 'unclear';
  const upright = ways.every(({ x, y }) => Math.abs(y) > kUpright * Math.abs(x));
  const together = ways[0].y * ways[1].y > 0 && Math.max(...lengths) < 2.5 * Math.min(...lengths);
  const beside = Math.abs(from[1].x - from[0].x) > kUpright * Math.abs(from[1].y - from[0].y);
  return upright && together && beside ? 'tilt' : 'pinch';
}

/** Right drag: turns with sideways movement, tilts with the rest. */
export class OrbitGesture implements ContactOwner {
  private last_: ScreenPoint | null = null;

  constructor(private readonly camera_: HandMoves) {}

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
