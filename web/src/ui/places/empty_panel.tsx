// A world without groups, or none yet.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Button } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

/** So many scenarios are offered. */
const kOffered = 3;

export class EmptyPanel {
  readonly root = element('section', { class: 'empty panel' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['groups', 'areas', 'loaded', 'scenarios', 'link'], (state) => {
      const waiting = !state.loaded;
      // Where there are areas people have left, or come.
      const used = state.groups.length > 0 || state.areas.length > 0;
      this.root.hidden = used || (waiting && state.link.phase === 'lost');
      if (this.root.hidden) return null;
      return (
        <>
          <h2>{waiting ? 'Opening the studio' : 'Nobody is here yet'}</h2>
          <p class="secondary">
            {waiting ? 'Waiting for the server.' : 'Add a group, or open one of these scenarios.'}
          </p>
          {!waiting && (
            <div class="empty-choices">
              <Button icon="plus" act={() => actions.openDialog('group')}>
                Add a group
              </Button>
              {state.scenarios.slice(0, kOffered).map(({ name, title }) => (
                <Button key={name} act={() => actions.loadScenario(name)}>
                  {title || name}
                </Button>
              ))}
            </div>
          )}
        </>
      );
    });
  }
}
