// Building is loaded when somebody begins with it.

import type { Scene } from '../../protocol/messages';
import { openLazily } from '../widgets/lazily';
import { onShiftKey } from '../widgets/shift_key';
import type { BuildParts } from './build_parts';

export function openBuildLazily(parts: BuildParts): void {
  const { store, client } = parts;
  let scene: Scene | null = null;
  const panel = openLazily(store, 'build', async () => {
    const module = await import('./build_controller');
    const controller = new module.BuildController(parts);
    if (scene) controller.setScene(scene);
    return controller;
  });
  client.on('scene', (message) => {
    scene = message;
    panel()?.setScene(message);
  });
  onShiftKey('E', () => store.set({ build: !store.state.build }));
}
