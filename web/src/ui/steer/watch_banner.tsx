// Tells that the scenario's own touches steer the crowd, and ends that.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Banner } from '../widgets/banner';
import { Button } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

export class WatchBanner {
  readonly root = element('section', { class: 'banner watch-banner panel', 'aria-label': 'Demonstration' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['demonstrating'], ({ demonstrating }) => {
      this.root.hidden = !demonstrating;
      if (!demonstrating) return null;
      return (
        <Banner icon="watch" title="Demonstration" text="Other hands steer the crowd">
          <Button act={() => actions.toggleDemonstration()}>Stop</Button>
        </Banner>
      );
    });
  }
}
