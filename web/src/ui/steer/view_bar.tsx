// The camera's buttons, and those of what else is looked at: fit, follow, build, measures.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { toolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';

export class ViewBar {
  readonly root = element('div', { class: 'view-bar panel', role: 'toolbar', 'aria-label': 'View' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['following', 'build', 'measures', 'replaying'], (state) => (
      <>
        {toolButton('fit', 'Fit', () => actions.fit(), {
          shortcut: 'F',
          tip: 'Shows the whole crowd and its paths; pressed again, the whole place',
        })}
        {toolButton('camera', 'Track', () => actions.toggleFollow(), {
          shortcut: 'I',
          class: 'toggle',
          pressed: state.following,
          tip: 'The camera goes with the crowd',
        })}
        {toolButton('build', 'Build', () => store.set({ build: !state.build }), {
          shortcut: 'Shift+E',
          class: 'toggle',
          hidden: state.replaying,
          pressed: state.build,
          tip: 'Builds the place: obstacles, patches, items, people',
        })}
        {toolButton('measure', 'Measures', () => store.set({ measures: !state.measures }), {
          shortcut: 'Shift+M',
          class: 'toggle',
          pressed: state.measures,
          tip: 'Measures flow, density and evacuation',
        })}
      </>
    ));
    new ToolbarFocus(this.root, store);
  }
}
