// Tells of a lost connection, and up to when the visitor's take is safe.

import { element, setText } from '../widgets/dom';
import { formatClock } from '../../model/formatters';
import { icon } from '../widgets/icons';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';

/** What a lost connection means for the visitor. */
export function lostText(recorded: number, secondsToRetry: number): string {
  const safe = recorded >= 0 ? ` Your take is safe up to ${formatClock(recorded)}.` : '';
  const again = secondsToRetry > 0 ? `Trying again in ${secondsToRetry} s.` : 'Trying again now.';
  return `The crowd waits.${safe} ${again}`;
}

export class LostBanner {
  private readonly title_ = element('strong', {}, 'Connection lost');
  private readonly text_ = element('span', { class: 'secondary' });
  private readonly retry_ = element('button', { type: 'button', class: 'solid' }, 'Try now');
  private readonly goOn_ = element('button', { type: 'button', hidden: true }, 'Go on without server');
  readonly root = element(
    'section',
    { class: 'banner panel', role: 'alert' },
    icon('lost', 24),
    element('div', { class: 'banner-words' }, this.title_, this.text_),
    element('div', { class: 'banner-buttons' }, this.goOn_, this.retry_),
  );

  constructor(
    private readonly store_: StudioStore,
    actions: StudioActions,
  ) {
    this.retry_.addEventListener('click', () => actions.retry());
    this.goOn_.addEventListener('click', () => actions.goOnAlone());
    store_.watch(['standby'], ({ standby }) => {
      this.goOn_.hidden = standby === 'none';
      this.goOn_.disabled = standby === 'wanted';
    });
    store_.watch(['link', 'recorded'], (state) => this.show(state));
    window.setInterval(() => this.show(store_.state), 500);
  }

  private show(state: StudioState): void {
    const { link } = state;
    // While an attempt runs after a loss the banner stays, or it would blink.
    if (link.phase === 'connecting' && state.loaded) {
      setText(this.text_, lostText(this.store_.state.recorded, 0));
      return;
    }
    this.root.hidden = link.phase !== 'lost';
    if (link.phase !== 'lost') return;
    setText(this.title_, state.loaded ? 'Connection lost' : 'No server');
    const seconds = Math.max(0, Math.ceil((link.retryAt - Date.now()) / 1000));
    setText(
      this.text_,
      state.loaded
        ? lostText(state.recorded, seconds)
        : `The studio’s server does not answer. Trying again in ${seconds} s.`,
    );
  }
}
