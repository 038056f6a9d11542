// The button *Takes* and its menu: takes to download and open, and whom the crowd looks like.

import type { VNode } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import { element } from '../widgets/dom';
import { Menu, MenuItem } from '../widgets/menu';

/** Files that may belong to a character. */
const kCharacterFiles = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp';

function fileInput(label: string, accept: string, multiple: boolean): HTMLInputElement {
  return element('input', { type: 'file', accept, multiple, hidden: true, 'aria-label': label, tabindex: -1 });
}

/** Lets the visitor choose takes, and the files of characters. */
export class TakeFiles {
  private readonly take_ = fileInput('Open a take', '.take', false);
  private readonly character_ = fileInput('Open a character', kCharacterFiles, true);
  /** Unseen; they stand outside of the menu, which closes. */
  readonly inputs: readonly HTMLInputElement[] = [this.take_, this.character_];

  constructor(actions: StudioActions) {
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

  chooseTake(): void {
    this.take_.click();
  }

  chooseCharacter(): void {
    this.character_.click();
  }
}

export interface TakeMenuProps {
  readonly actions: StudioActions;
  readonly files: TakeFiles;
  readonly ownCharacter: string;
}

export function TakeMenu({ actions, files, ownCharacter }: TakeMenuProps): VNode {
  return (
    <span class="takes-holder">
      <Menu
        opener={{
          icon: 'takes',
          label: 'Takes',
          iconOnly: true,
          class: 'takes',
          tip: 'Takes, whom the crowd looks like, and the control',
        }}
        class="take-list"
        label="Takes"
        placement="top-end"
      >
        {(close) => (
          <>
            <MenuItem icon="takes" label="All takes…" close={close} act={() => actions.showShelf(true)} />
            <MenuItem icon="download" label="Download take" close={close} act={() => actions.downloadTake()} />
            <MenuItem icon="open" label="Open take…" close={close} act={() => files.chooseTake()} />
            <MenuItem icon="character" label="Own character…" close={close} act={() => files.chooseCharacter()} />
            <MenuItem
              icon="places"
              label="Our people"
              hidden={ownCharacter === ''}
              close={close}
              act={() => actions.ourPeople()}
            />
            <MenuItem icon="steer" label="Control…" close={close} act={() => actions.showSchemes(true)} />
          </>
        )}
      </Menu>
    </span>
  );
}
