// Changing paths of a take is loaded when somebody begins with it.

import type { TakeEdits, TakeState } from '../../protocol/messages';
import { openLazily } from '../widgets/lazily';
import { onShiftKey } from '../widgets/shift_key';
import type { Members, PathParts } from './path/path_controller';

export function openPathsLazily(parts: PathParts): void {
  const { store, client } = parts;
  let take: TakeState | null = null;
  let edits: TakeEdits | null = null;
  const members: Members = { ids: new Uint32Array(), group: new Uint16Array() };
  const panel = openLazily(store, 'paths', async () => {
    const module = await import('./path/path_controller');
    const controller = new module.PathController(parts, members);
    if (take) controller.setTake(take);
    if (edits) controller.setEdits(edits);
    return controller;
  });
  client.on('frame', ({ frame: { ids, group } }) => {
    if (ids.length > 0) Object.assign(members, { ids, group });
  });
  client.on('takeState', (state) => {
    take = state;
    panel()?.setTake(state);
  });
  client.on('takeEdits', (told) => {
    edits = told;
    panel()?.setEdits(told);
  });
  onShiftKey(
    'P',
    () => store.set({ paths: !store.state.paths }),
    () => Boolean(take?.open && !take.stored),
  );
}
