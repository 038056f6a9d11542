// A reminder of the control scheme that is in use.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Banner } from '../widgets/banner';
import { Button } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

/** Tells which scheme is in use, and ends it. */
export class SchemeBanner {
  readonly root = element('section', { class: 'banner scheme-banner panel', 'aria-label': 'Control in use' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['scheme', 'schemes'], ({ scheme, schemes }) => {
      const info = schemes.find(({ name }) => name === scheme);
      this.root.hidden = info === undefined;
      if (!info) return null;
      return (
        <Banner icon="steer" title={info.title} text={info.description}>
          <Button act={() => actions.chooseScheme('')}>Leave</Button>
        </Banner>
      );
    });
  }
}
