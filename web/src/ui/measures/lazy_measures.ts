// Measuring is loaded when somebody begins with it.

import type { StudioFrame } from '../../model/studio_frame';
import type { Scene } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { MeasureController, MeasureParts } from './measure_controller';
import { onShiftKey } from '../widgets/shift_key';

export function openMeasuresLazily(parts: MeasureParts): void {
  const { store, client } = parts;
  let controller: MeasureController | null = null;
  let scene: Scene | null = null;
  let last: StudioFrame | null = null;
  let ids: Uint32Array = new Uint32Array();
  let loading = false;
  client.on('scene', (message) => {
    scene = message;
    controller?.setScene(message);
  });
  client.on('frame', ({ frame }) => {
    if (frame.ids.length > 0 || frame.x.length === 0) ids = frame.ids;
    last = frame;
    controller?.observe(frame, ids);
  });
  onShiftKey('M', () => store.set({ measures: !store.state.measures }));
  const load = async (): Promise<void> => {
    const module = await import('./measure_controller');
    controller = new module.MeasureController(parts);
    if (scene) controller.setScene(scene);
    if (last) controller.observe(last, ids);
    controller.setOpen(store.state.measures);
  };
  store.watch(['build'], ({ build }) => build && store.set({ measures: false }));
  store.watch(['measures'], ({ measures }) => {
    document.documentElement.toggleAttribute('data-measures', measures);
    if (measures) store.set({ build: false });
    if (controller) return controller.setOpen(measures);
    if (!measures || loading) return;
    loading = true;
    load()
      .catch(() => store.set({ measures: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  });
}
