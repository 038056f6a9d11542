// Tells that the scenario's own touches steer the crowd, and ends that.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

export class WatchBanner {
  readonly root = element('section', { class: 'banner watch-banner panel', 'aria-label': 'Demonstration' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['demonstrating'], ({ demonstrating }) => {
      this.root.hidden = !demonstrating;
      if (!demonstrating) return null;
      return (
        <>
          <Icon name="watch" size={24} />
          <div class="banner-words">
            <strong>Demonstration</strong>
            <span class="secondary">Other hands steer the crowd</span>
          </div>
          <button type="button" class="soft" onClick={() => actions.toggleDemonstration()}>
            Stop
          </button>
        </>
      );
    });
  }
}
