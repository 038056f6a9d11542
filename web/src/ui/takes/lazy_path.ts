// Changing paths of a take is loaded when somebody begins with it.

import type { TakeEdits, TakeState } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { Members, PathController, PathParts } from './path/path_controller';
import { onShiftKey } from '../widgets/shift_key';

export function openPathsLazily(parts: PathParts): void {
  const { store, client } = parts;
  let controller: PathController | null = null;
  let take: TakeState | null = null;
  let edits: TakeEdits | null = null;
  let loading = false;
  const members: Members = { ids: new Uint32Array(), group: new Uint16Array() };
  client.on('frame', ({ frame: { ids, group } }) => {
    if (ids.length > 0) Object.assign(members, { ids, group });
  });
  onShiftKey(
    'P',
    () => store.set({ paths: !store.state.paths }),
    () => Boolean(take?.open && !take.stored),
  );
  client.on('takeState', (state) => {
    take = state;
    controller?.setTake(state);
  });
  client.on('takeEdits', (told) => {
    edits = told;
    controller?.setEdits(told);
  });
  const load = async (): Promise<void> => {
    const module = await import('./path/path_controller');
    controller = new module.PathController(parts, members);
    if (take) controller.setTake(take);
    if (edits) controller.setEdits(edits);
    controller.setOpen(store.state.paths);
  };
  store.watch(['paths'], ({ paths }) => {
    document.documentElement.toggleAttribute('data-paths', paths);
    if (controller) return controller.setOpen(paths);
    if (!paths || loading) return;
    loading = true;
    load()
      .catch(() => store.set({ paths: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  });
}
