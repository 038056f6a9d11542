// Tells the server where this page looks, so that it sends whole poses of the characters nearby. A message is sent when
// the view has moved, at most four times a second.

import type { MessageSender } from '../../link/studio_client';
import type { Attention } from '../../scene/studio_scene';

/** Least time between two messages [ms]. */
const kPause = 250;
/** Smaller moves are not reported [m]. */
const kMove = 0.5;

export class AttentionSender {
  private sent_: Attention | null = null;
  private next_ = 0;

  constructor(private readonly client_: MessageSender) {}

  /** After a lost connection the server has to be told anew. */
  forget(): void {
    this.sent_ = null;
    this.next_ = 0;
  }

  /** Once per picture; `now` by performance.now() [ms]. */
  consider(attention: Attention, now: number): void {
    const sent = this.sent_;
    if (now < this.next_) return;
    if (sent && sent.count === attention.count && Math.hypot(sent.x - attention.x, sent.y - attention.y) < kMove)
      return;
    this.sent_ = attention;
    this.next_ = now + kPause;
    this.client_.send({ type: 'Attend', ...attention });
  }
}
