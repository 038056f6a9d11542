// Tells the server where this page looks, so that whole poses of those nearby come: when that changed, and not often.

import type { MessageSender } from '../link/studio_client';
import type { Attention } from '../scene/studio_scene';

/** Between two tellings [ms]. */
const kPause = 250;
/** A smaller move is no news [m]. */
const kMove = 0.5;

export class AttentionSender {
  private sent_: Attention | null = null;
  private next_ = 0;

  constructor(private readonly client_: MessageSender) {}

  /** A server that was found again knows nothing. */
  forget(): void {
    this.sent_ = null;
    this.next_ = 0;
  }

  /** Once per picture; `now` by performance.now() [ms]. */
  consider(attention: Attention, now: number): void {
    const told = this.sent_;
    if (now < this.next_) return;
    if (told && told.count === attention.count && Math.hypot(told.x - attention.x, told.y - attention.y) < kMove)
      return;
    this.sent_ = attention;
    this.next_ = now + kPause;
    this.client_.send({ type: 'Attend', ...attention });
  }
}
