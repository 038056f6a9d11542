// The camera's buttons, and those of what else is looked at: fit, follow, build, measures.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { ToolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';

export class ViewBar {
  readonly root = element('div', { class: 'view-bar panel', role: 'toolbar', 'aria-label': 'View' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['following', 'build', 'measures', 'replaying'], (state) => (
      <>
        <ToolButton
          icon="fit"
          label="Fit"
          shortcut="F"
          tip="Shows the whole crowd and its paths; pressed again, the whole place"
          act={() => actions.fit()}
        />
        <ToolButton
          icon="camera"
          label="Track"
          shortcut="I"
          class="toggle"
          pressed={state.following}
          tip="The camera goes with the crowd"
          act={() => actions.toggleFollow()}
        />
        <ToolButton
          icon="build"
          label="Build"
          shortcut="Shift+E"
          class="toggle"
          hidden={state.replaying}
          pressed={state.build}
          tip="Builds the place: obstacles, patches, items, people"
          act={() => store.set({ build: !state.build })}
        />
        <ToolButton
          icon="measure"
          label="Measures"
          shortcut="Shift+M"
          class="toggle"
          pressed={state.measures}
          tip="Measures flow, density and evacuation"
          act={() => store.set({ measures: !state.measures })}
        />
      </>
    ));
    new ToolbarFocus(this.root, store);
  }
}
