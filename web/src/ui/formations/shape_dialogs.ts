// Dialogs for words, shapes of one's own, codes, and new groups. This file is loaded when the first of them is opened.

import { h } from 'preact';
import { PanelLayout } from '../widgets/panel_layout';
import type { ShapeActions } from '../../model/shape_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import type { ShapeDialogProps } from './dialog_ends';
import { GroupDialog } from './group_dialog';
import { OwnShapeDialog } from './own_shape_dialog';
import { PlacingBar } from './placing_bar';
import { QrDialog } from './qr_dialog';
import { TextDialog } from './text_dialog';
import { TryBar } from './try_bar';

const kDialogs = { text: TextDialog, shape: OwnShapeDialog, qr: QrDialog, group: GroupDialog } as const;

/** Draws the dialog that the state names. */
export function watchShapeDialogs(
  page: HTMLElement,
  store: StudioStore,
  actions: StudioActions,
  shapes: ShapeActions,
): void {
  const root = element('div', { class: 'shape-dialogs' });
  page.append(root);
  PanelLayout.of(page).add('try', new TryBar(store, shapes).root);
  PanelLayout.of(page).add('placing', new PlacingBar(store).root);
  drawPanel(root, store, ['dialog', 'groups', 'active', 'stand'], (state) => {
    if (state.dialog === 'none') return null;
    return h<ShapeDialogProps>(kDialogs[state.dialog], { key: state.dialog, state, shapes, actions });
  });
}
