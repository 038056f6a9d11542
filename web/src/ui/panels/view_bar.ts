// The camera's buttons: fit, follow, from above, and a clean picture.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { element, setPressed } from '../widgets/dom';
import { toolButton } from '../widgets/tool_button';
import { ToolbarFocus } from '../widgets/toolbar_focus';

export class ViewBar {
  readonly root = element('div', { class: 'view-bar panel', role: 'toolbar', 'aria-label': 'View' });

  constructor(store: StudioStore, actions: StudioActions) {
    const fit = toolButton({
      icon: 'fit',
      label: 'Fit',
      key: 'F',
      tip: 'Fits crowd and paths',
      act: () => actions.fit(),
    });
    const follow = toolButton({
      icon: 'camera',
      label: 'Follow',
      key: 'I',
      pressed: false,
      className: 'toggle',
      tip: 'The camera follows the crowd',
      act: () => actions.toggleFollow(),
    });
    store.watch(['following'], ({ following }) => setPressed(follow, following));

    const build = toolButton({
      icon: 'build',
      label: 'Build',
      key: 'Shift+E',
      pressed: false,
      className: 'toggle',
      tip: 'Builds the place: obstacles, patches, items, people',
      act: () => store.set({ build: !store.state.build }),
    });
    store.watch(['build'], ({ build: on }) => setPressed(build, on));
    store.watch(['replaying'], ({ replaying }) => (build.hidden = replaying));
    const measures = toolButton({
      icon: 'measure',
      label: 'Measures',
      key: 'Shift+M',
      pressed: false,
      className: 'toggle',
      tip: 'Measures flow, density and evacuation',
      act: () => store.set({ measures: !store.state.measures }),
    });
    store.watch(['measures'], ({ measures: on }) => setPressed(measures, on));
    this.root.append(fit, follow, build, measures);
    new ToolbarFocus(this.root, store);
  }
}
