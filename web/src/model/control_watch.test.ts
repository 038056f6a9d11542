import { expect, it } from 'vitest';
import { ControlKind, type ControlFrame } from '../protocol/messages';
import type { StudioFrame } from './studio_frame';
import { ControlWatch } from './control_watch';

function frameWith(...controls: Partial<ControlFrame>[]): StudioFrame {
  const group = { id: 1, controls: controls.map((one) => ({ client: 5, points: [], ...one })) };
  return { type: 'Frame', groups: [group] } as unknown as StudioFrame;
}

it('tells of controls that begin and of those that change their kind, once', () => {
  const watch = new ControlWatch();
  expect(watch.observe(frameWith())).toEqual([]);
  const began = frameWith({ id: 3, kind: ControlKind.Point });
  expect(watch.observe(began)).toEqual([{ index: 0, control: 3, client: 5, kind: ControlKind.Point }]);
  expect(watch.observe(began)).toEqual([]);
  expect(watch.observe(frameWith({ id: 3, kind: ControlKind.Line }))).toHaveLength(1);
  expect(watch.observe(frameWith())).toEqual([]);
  expect(watch.observe(began)).toHaveLength(1);
});
