// Dialogs that few visitors open are loaded when one is opened first.

import type { ShapeActions } from '../../model/shape_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { problem } from '../../protocol/problem';

export function openDialogsLazily(
  page: HTMLElement,
  store: StudioStore,
  actions: StudioActions,
  shapes: ShapeActions,
): void {
  let asked = false;
  store.watch(['dialog'], ({ dialog }) => {
    if (dialog === 'none' || asked) return;
    asked = true;
    import('../formations/shape_dialogs').then(
      ({ watchShapeDialogs }) => watchShapeDialogs(page, store, actions, shapes),
      () => {
        asked = false;
        store.set({ dialog: 'none', notice: problem('page', 'The server does not answer: try again.') });
      },
    );
  });
}
