// The button *Takes* and its menu: takes to download and open, and whom the crowd looks like.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { element } from '../widgets/dom';
import { icon, type IconName } from '../widgets/icons';
import { Popover } from '../widgets/popover';
import { toolButton } from '../widgets/tool_button';

/** Files that may belong to a character. */
const kCharacterFiles = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp';

function fileInput(label: string, accept: string, multiple: boolean): HTMLInputElement {
  return element('input', { type: 'file', accept, multiple, hidden: true, 'aria-label': label, tabindex: -1 });
}

export class TakeMenu {
  private readonly button_ = toolButton({
    icon: 'takes',
    label: 'Takes',
    iconOnly: true,
    className: 'takes',
    tip: 'Takes, whom the crowd looks like, and the control',
  });
  private readonly list_ = element('div', { class: 'take-list panel', role: 'group', 'aria-label': 'Takes' });
  private readonly take_ = fileInput('Open a take', '.take', false);
  private readonly character_ = fileInput('Open a character', kCharacterFiles, true);
  private readonly popover_ = new Popover(this.button_, this.list_, 'top-end');
  readonly root = element('span', { class: 'takes-holder' }, this.button_, this.list_);
  /** Unseen; they stand outside of the menu, which closes. */
  readonly inputs: readonly HTMLInputElement[] = [this.take_, this.character_];

  constructor(store: StudioStore, actions: StudioActions) {
    const ours = this.item('places', 'Our people', () => actions.ourPeople());
    this.list_.append(
      this.item('takes', 'All takes…', () => actions.showShelf(true)),
      this.item('download', 'Download take', () => actions.downloadTake()),
      this.item('open', 'Open take…', () => this.chooseFile()),
      this.item('character', 'Own character…', () => this.chooseCharacter()),
      ours,
      this.item('steer', 'Control…', () => actions.showSchemes(true)),
    );
    store.watch(['ownCharacter'], ({ ownCharacter }) => (ours.hidden = ownCharacter === ''));
    this.take_.addEventListener('change', () => {
      const chosen = this.take_.files?.[0];
      if (chosen) actions.openTake(chosen);
      this.take_.value = '';
    });
    this.character_.addEventListener('change', () => {
      actions.openCharacter([...(this.character_.files ?? [])]);
      this.character_.value = '';
    });
  }

  /** Lets the visitor choose a take to open. */
  chooseFile(): void {
    this.take_.click();
  }

  /** Lets the visitor choose the files of a character. */
  chooseCharacter(): void {
    this.character_.click();
  }

  private item(name: IconName, label: string, act: () => void): HTMLButtonElement {
    const button = element('button', { type: 'button', class: 'menu-item' }, icon(name), label);
    button.addEventListener('click', () => {
      this.popover_.close(true);
      act();
    });
    return button;
  }
}
