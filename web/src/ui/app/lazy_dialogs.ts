// Dialogs that few visitors open are loaded when one is opened first.

import type { ShapeActions } from '../../model/shape_actions';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { loadWhen } from '../widgets/lazily';

export function openDialogsLazily(
  page: HTMLElement,
  store: StudioStore,
  actions: StudioActions,
  shapes: ShapeActions,
): void {
  const load = async (): Promise<void> => {
    const { watchShapeDialogs } = await import('../formations/shape_dialogs');
    watchShapeDialogs(page, store, actions, shapes);
  };
  loadWhen(store, ['dialog'], ({ dialog }) => dialog !== 'none', load, { dialog: 'none' });
}
