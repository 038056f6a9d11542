// The button *Takes* and its menu: takes to download and open, and whom the crowd looks like.

import type { VNode } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import { fileInput } from '../widgets/file_input';
import { Menu, MenuItem } from '../widgets/menu';

/** Files that may belong to a character. */
const kCharacterFiles = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp';

/** Lets the visitor choose takes, and the files of characters. */
export class TakeFiles {
  private readonly take_: HTMLInputElement;
  private readonly character_: HTMLInputElement;
  /** Unseen; they stand outside of the menu, which closes. */
  readonly inputs: readonly HTMLInputElement[];

  constructor(actions: StudioActions) {
    this.take_ = fileInput({ label: 'Open a take', accept: '.take', chosen: ([file]) => actions.openTake(file!) });
    this.character_ = fileInput({
      label: 'Open a character',
      accept: kCharacterFiles,
      multiple: true,
      chosen: (files) => actions.openCharacter(files),
    });
    this.inputs = [this.take_, this.character_];
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
