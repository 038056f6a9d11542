// Small windows have these buttons: Undo, the layers, and all that the sheet has no space for.

import type { VNode } from 'preact';
import type { OrderActions } from '../../model/order_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { ToolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { Held } from '../widgets/held';
import { Menu, MenuItem } from '../widgets/menu';
import { drawPanel } from '../widgets/panel';
import { LayerBar } from '../steer/layer_bar';

interface MoreProps {
  readonly close: () => void;
  readonly ownCharacter: string;
  readonly replaying: boolean;
  readonly actions: StudioActions;
  readonly openTake: () => void;
  readonly openCharacter: () => void;
}

function More({ close, ownCharacter, replaying, actions, openTake, openCharacter }: MoreProps): VNode {
  return (
    <>
      <MenuItem icon="restart" label="Restart" close={close} act={() => actions.restart()} />
      <MenuItem
        icon="plus"
        label="Add a group…"
        hidden={replaying}
        close={close}
        act={() => actions.openDialog('group')}
      />
      <MenuItem icon="empty" label="Fit the view" close={close} act={() => actions.fit()} />
      <MenuItem icon="takes" label="All takes…" close={close} act={() => actions.showShelf(true)} />
      <MenuItem icon="download" label="Download take" close={close} act={() => actions.downloadTake()} />
      <MenuItem icon="open" label="Open take…" close={close} act={openTake} />
      <MenuItem icon="character" label="Own character…" close={close} act={openCharacter} />
      <MenuItem
        icon="places"
        label="Our people"
        hidden={ownCharacter === ''}
        close={close}
        act={() => actions.ourPeople()}
      />
      <MenuItem icon="steer" label="Control…" close={close} act={() => actions.showSchemes(true)} />
      <MenuItem icon="moon" label="Light or dark" close={close} act={() => actions.toggleTheme()} />
      <MenuItem icon="help" label="Help" close={close} act={() => actions.showHelp(true)} />
    </>
  );
}

export class PhoneBar {
  readonly root = element('div', { class: 'phone-bar panel' });

  /** `openTake` and `openCharacter` let the visitor choose files. */
  constructor(
    store: StudioStore,
    actions: StudioActions,
    orders: OrderActions,
    openTake: () => void,
    openCharacter: () => void,
  ) {
    const layers = new LayerBar(store, actions).root;
    drawPanel(this.root, store, ['ownCharacter', 'history', 'replaying'], ({ ownCharacter, history, replaying }) => (
      <>
        <ToolButton
          icon="undo"
          label="Undo"
          iconOnly
          class="phone-undo"
          hidden={history.undo === 0}
          tip={`Takes back: ${history.undoLabel}`}
          act={() => orders.undo()}
        />
        <Menu
          opener={{ icon: 'layers', label: 'Layers', iconOnly: true }}
          class="phone-layers"
          label="What is shown"
          placement="bottom-end"
        >
          {() => <Held make={() => layers} />}
        </Menu>
        <Menu
          opener={{ icon: 'more', label: 'More', iconOnly: true }}
          class="phone-menu"
          label="More"
          placement="bottom-end"
        >
          {(close) => <More close={close} {...{ ownCharacter, replaying, actions, openTake, openCharacter }} />}
        </Menu>
      </>
    ));
  }
}
