// A reminder of the control scheme that is in use.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Icon } from '../widgets/buttons';
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
        <>
          <Icon name="steer" size={24} />
          <div class="banner-words">
            <strong>{info.title}</strong>
            <span class="secondary">{info.description}</span>
          </div>
          <button type="button" class="soft" onClick={() => actions.chooseScheme('')}>
            Leave
          </button>
        </>
      );
    });
  }
}
