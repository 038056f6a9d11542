// Building is loaded when somebody begins with it.

import type { Scene } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { BuildController, BuildParts } from './build_controller';
import { onShiftKey } from '../widgets/shift_key';

export function openBuildLazily(parts: BuildParts): void {
  const { store, client } = parts;
  let controller: BuildController | null = null;
  let scene: Scene | null = null;
  let loading = false;
  onShiftKey('E', () => store.set({ build: !store.state.build }));
  client.on('scene', (message) => {
    scene = message;
    controller?.setScene(message);
  });
  const load = async (): Promise<void> => {
    const module = await import('./build_controller');
    controller = new module.BuildController(parts);
    if (scene) controller.setScene(scene);
    controller.setOpen(store.state.build);
  };
  store.watch(['build'], ({ build }) => {
    document.documentElement.toggleAttribute('data-build', build);
    if (controller) return controller.setOpen(build);
    if (!build || loading) return;
    loading = true;
    load()
      .catch(() => store.set({ build: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  });
}
