// Building is loaded when somebody begins with it.

import type { Scene } from '../protocol/messages';
import { problem } from '../protocol/problem';
import type { BuildDesk, BuildParts } from './build/build_desk';
import { onShiftKey } from './shift_key';

export function openBuildLazily(parts: BuildParts): void {
  const { store, client } = parts;
  let desk: BuildDesk | null = null;
  let scene: Scene | null = null;
  let loading = false;
  onShiftKey('E', () => store.set({ build: !store.state.build }));
  client.on('scene', (message) => {
    scene = message;
    desk?.setScene(message);
  });
  const load = async (): Promise<void> => {
    const module = await import('./build/build_desk');
    desk = new module.BuildDesk(parts);
    if (scene) desk.setScene(scene);
    desk.setOpen(store.state.build);
  };
  store.watch(['build'], ({ build }) => {
    document.documentElement.toggleAttribute('data-build', build);
    if (desk) return desk.setOpen(build);
    if (!build || loading) return;
    loading = true;
    load()
      .catch(() => store.set({ build: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  });
}
