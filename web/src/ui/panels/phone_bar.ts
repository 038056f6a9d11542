// Small windows have two buttons here: one for the layers, one for all that the sheet has no space for.

import { element } from '../widgets/dom';
import { icon, type IconName } from '../widgets/icons';
import { LayerBar } from './layer_bar';
import { Popover } from '../widgets/popover';
import type { StudioActions } from '../../model/studio_actions';
import { toolButton } from '../widgets/tool_button';
import type { StudioStore } from '../../model/studio_store';

export class PhoneBar {
  readonly root = element('div', { class: 'phone-bar panel' });

  /** `openTake` and `openCharacter` let the visitor choose files. */
  constructor(store: StudioStore, actions: StudioActions, openTake: () => void, openCharacter: () => void) {
    const layers = toolButton({ icon: 'layers', label: 'Layers', iconOnly: true });
    const more = toolButton({ icon: 'more', label: 'More', iconOnly: true });
    const layerList = element('div', { class: 'phone-layers panel' }, new LayerBar(store, actions).root);
    const menu = element('div', { class: 'phone-menu panel', role: 'group', 'aria-label': 'More' });
    new Popover(layers, layerList, 'bottom-end');
    const popover = new Popover(more, menu, 'bottom-end');
    const item = (name: IconName, label: string, act: () => void): HTMLButtonElement => {
      const button = element('button', { type: 'button', class: 'menu-item' }, icon(name), label);
      button.addEventListener('click', () => {
        popover.close(true);
        act();
      });
      menu.append(button);
      return button;
    };
    item('restart', 'Restart', () => actions.restart());
    item('empty', 'Fit the view', () => actions.fit());
    item('takes', 'All takes…', () => actions.showShelf(true));
    item('download', 'Download take', () => actions.downloadTake());
    item('open', 'Open take…', openTake);
    item('character', 'Own character…', openCharacter);
    const ours = item('places', 'Our people', () => actions.ourPeople());
    store.watch(['ownCharacter'], ({ ownCharacter }) => (ours.hidden = ownCharacter === ''));
    item('steer', 'Control…', () => actions.showSchemes(true));
    item('moon', 'Light or dark', () => actions.toggleTheme());
    item('help', 'Help', () => actions.showHelp(true));
    this.root.append(layers, more, layerList, menu);
  }
}
