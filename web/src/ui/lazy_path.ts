// Changing paths of a take is loaded when somebody begins with it.

import type { TakeState } from '../protocol/messages';
import { problem } from '../protocol/problem';
import type { Members, PathDesk, PathParts } from './path/path_desk';
import { onShiftKey } from './shift_key';

export function openPathsLazily(parts: PathParts): void {
  const { store, client } = parts;
  let desk: PathDesk | null = null;
  let take: TakeState | null = null;
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
    desk?.setTake(state);
  });
  const load = async (): Promise<void> => {
    const module = await import('./path/path_desk');
    desk = new module.PathDesk(parts, members);
    if (take) desk.setTake(take);
    desk.setOpen(store.state.paths);
  };
  store.watch(['paths'], ({ paths }) => {
    document.documentElement.toggleAttribute('data-paths', paths);
    if (desk) return desk.setOpen(paths);
    if (!paths || loading) return;
    loading = true;
    load()
      .catch(() => store.set({ paths: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  });
}
