// A new group is in hand: what the next press does, how its places are, and the way to give it up.

import type { StudioStore } from '../../model/studio_store';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

export class PlacingBar {
  readonly root = element('section', { class: 'try-bar placing-bar panel', 'aria-label': 'A new group' });

  constructor(store: StudioStore) {
    drawPanel(this.root, store, ['placing', 'stand', 'input'], ({ placing, stand, input }) => {
      this.root.hidden = placing === '';
      if (placing === '') return null;
      const gives = input === 'touch' ? 'A finger that moves shows where' : 'Escape gives it up';
      return (
        <>
          <div class="try-said">
            <span class="try-title">The next press puts {placing} on the ground</span>
            <span class={stand?.warns ? 'try-words warns' : 'try-words'}>{stand?.text ?? 'Shown where you point'}</span>
            <span class="try-words secondary">{gives}</span>
          </div>
          <button
            type="button"
            class="try-drop"
            aria-label="Give it up"
            data-tip="Give it up"
            data-key="Esc"
            onClick={() => store.set({ tool: 'steer' })}
          >
            <Icon name="close" />
          </button>
        </>
      );
    });
  }
}
