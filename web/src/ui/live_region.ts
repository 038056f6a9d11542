// Speaks what sighted visitors see: controls and formations that change.

import { element, setText } from './dom';

const SETTLE_MS = 250;

export class LiveRegion {
  readonly root = element('div', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
  private timer = 0;

  /** The newest text within a quarter second is spoken: a point that becomes a line is a line. */
  say(text: string): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => setText(this.root, this.fresh(text)), SETTLE_MS);
  }

  /** Unchanged text would not be spoken again: an unseen space makes it news. */
  private fresh(text: string): string {
    return this.root.textContent === text ? `${text}\u00a0` : text;
  }
}
