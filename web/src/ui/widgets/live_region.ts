// Speaks what sighted visitors see: controls and formations that change.

import { element, setText } from './dom';

const kSettleMs = 250;

export class LiveRegion {
  readonly root = element('div', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
  private timer_ = 0;

  /** The newest text within a quarter second is spoken: a point that becomes a line is a line. */
  say(text: string): void {
    window.clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => setText(this.root, this.fresh(text)), kSettleMs);
  }

  /** Unchanged text would not be spoken again: an unseen space makes it news. */
  private fresh(text: string): string {
    return this.root.textContent === text ? `${text}\u00a0` : text;
  }
}
