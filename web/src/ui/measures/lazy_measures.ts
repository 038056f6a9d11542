// Measuring is loaded when somebody begins with it.

import type { StudioFrame } from '../../model/studio_frame';
import type { Scene } from '../../protocol/messages';
import { openLazily } from '../widgets/lazily';
import { onShiftKey } from '../widgets/shift_key';
import type { MeasureParts } from './measure_controller';

export function openMeasuresLazily(parts: MeasureParts): void {
  const { store, client } = parts;
  let scene: Scene | null = null;
  let last: StudioFrame | null = null;
  let ids: Uint32Array = new Uint32Array();
  store.watch(['build'], ({ build }) => build && store.set({ measures: false }));
  store.watch(['measures'], ({ measures }) => measures && store.set({ build: false }));
  const panel = openLazily(store, 'measures', async () => {
    const module = await import('./measure_controller');
    const controller = new module.MeasureController(parts);
    if (scene) controller.setScene(scene);
    if (last) controller.observe(last, ids);
    return controller;
  });
  client.on('scene', (message) => {
    scene = message;
    panel()?.setScene(message);
  });
  client.on('frame', ({ frame }) => {
    if (frame.ids.length > 0 || frame.x.length === 0) ids = frame.ids;
    last = frame;
    panel()?.observe(frame, ids);
  });
  onShiftKey('M', () => store.set({ measures: !store.state.measures }));
}
