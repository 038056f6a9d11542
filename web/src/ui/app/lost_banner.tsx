// Tells of a lost connection, and up to when the visitor's take is safe.

import { render } from 'preact';
import { formatClock } from '../../model/formatters';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { Banner } from '../widgets/banner';
import { Button } from '../widgets/buttons';
import { element } from '../widgets/dom';

/** What a lost connection means for the visitor. */
export function lostText(recorded: number, secondsToRetry: number): string {
  const safe = recorded >= 0 ? ` Your take is safe up to ${formatClock(recorded)}.` : '';
  const again = secondsToRetry > 0 ? `Trying again in ${secondsToRetry} s.` : 'Trying again now.';
  return `The crowd waits.${safe} ${again}`;
}

/** The time of a retry is counted down [ms]. */
const kEvery = 500;

function wordsOf({ link, loaded, recorded }: StudioState): string {
  const seconds = link.phase === 'lost' ? Math.max(0, Math.ceil((link.retryAt - Date.now()) / 1000)) : 0;
  if (loaded) return lostText(recorded, seconds);
  return `The studio’s server does not answer. Trying again in ${seconds} s.`;
}

export class LostBanner {
  readonly root = element('section', { class: 'banner panel', role: 'alert' });

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    store.watch(['link', 'recorded', 'standby', 'loaded'], (state) => this.show(state));
    window.setInterval(() => store.state.link.phase === 'lost' && this.show(store.state), kEvery);
  }

  private show(state: StudioState): void {
    const { phase } = state.link;
    // While an attempt runs after a loss the banner stays, or it would blink.
    if (phase !== 'connecting' || !state.loaded) this.root.hidden = phase !== 'lost';
    if (this.root.hidden) return;
    render(
      <Banner icon="lost" title={state.loaded ? 'Connection lost' : 'No server'} text={wordsOf(state)}>
        <div class="banner-buttons">
          <button
            type="button"
            hidden={state.standby === 'none'}
            disabled={state.standby === 'wanted'}
            onClick={() => this.actions_.goOnAlone()}
          >
            Go on without server
          </button>
          <Button class="solid" act={() => this.actions_.retry()}>
            Try now
          </Button>
        </div>
      </Banner>,
      this.root,
    );
  }
}
