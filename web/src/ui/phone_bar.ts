// On small windows: two buttons, for the layers and for all that the sheet has no room for.

import { element } from './dom';
import { icon, type IconName } from './icons';
import { LayerBar } from './layer_bar';
import { Popup } from './popup';
import type { StudioActions } from './studio_actions';
import type { StudioStore } from './studio_state';
import { toolButton } from './tool_button';

export class PhoneBar {
  readonly root = element('div', { class: 'phone-bar panel' });

  /** `openTake` and `openCharacter` let the visitor choose files. */
  constructor(store: StudioStore, actions: StudioActions, openTake: () => void, openCharacter: () => void) {
    const layers = toolButton({ icon: 'layers', label: 'Layers', iconOnly: true });
    const more = toolButton({ icon: 'more', label: 'More', iconOnly: true });
    const layerList = element('div', { class: 'phone-layers panel' }, new LayerBar(store, actions).root);
    const menu = element('div', { class: 'phone-menu panel', role: 'group', 'aria-label': 'More' });
    new Popup(layers, layerList);
    const popup = new Popup(more, menu);
    const item = (name: IconName, label: string, act: () => void): HTMLButtonElement => {
      const button = element('button', { type: 'button', class: 'menu-item' }, icon(name), label);
      button.addEventListener('click', () => {
        popup.close(true);
        act();
      });
      menu.append(button);
      return button;
    };
    item('restart', 'Restart', () => actions.restart());
    item('empty', 'Fit the view', () => actions.fit());
    item('download', 'Download take', () => actions.downloadTake());
    item('open', 'Open take…', openTake);
    item('character', 'Own character…', openCharacter);
    const ours = item('places', 'Our people', () => actions.ourPeople());
    store.watch(['ownCharacter'], ({ ownCharacter }) => (ours.hidden = ownCharacter === ''));
    item('moon', 'Light or dark', () => actions.toggleTheme());
    item('help', 'Help', () => actions.showHelp(true));
    this.root.append(layers, more, layerList, menu);
  }
}
