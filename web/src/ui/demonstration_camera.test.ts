import { beforeEach, expect, it, vi } from 'vitest';
import { DemonstrationCamera, type WatchedFrame } from './demonstration_camera';

const panBy = vi.fn();
const fit = vi.fn();
const padding = () => ({ left: 100, right: 100, top: 0, bottom: 0 });
let camera: DemonstrationCamera;

/** One character; a metre is a pixel. */
const frame = (step: number, x: number, demonstrating = true): WatchedFrame => ({
  step,
  demonstrating,
  x: [x - 1, x + 1],
  y: [200, 200],
});
const observe = (one: WatchedFrame) => camera.observe(one, 1000, 400, padding);

beforeEach(() => {
  vi.clearAllMocks();
  camera = new DemonstrationCamera({ camera: { panBy }, worldToScreen: (point) => point }, fit);
});

it('stands while the crowd is in the middle, then moves it back softly', () => {
  observe(frame(1, 500));
  observe(frame(2, 610));
  expect(panBy).not.toHaveBeenCalled();
  observe(frame(3, 800));
  expect(panBy.mock.calls[0]![0]).toBeCloseTo(-14.4);
  expect(panBy.mock.calls[0]![1]).toBeCloseTo(0);
  observe(frame(4, 200));
  expect(panBy.mock.calls[1]![0]).toBeCloseTo(14.4);
});

it('leaves the camera alone without a demonstration, and once somebody uses the scene', () => {
  observe(frame(1, 900, false));
  observe(frame(2, 500));
  camera.release();
  observe(frame(3, 900));
  observe(frame(1, 900));
  expect(panBy).not.toHaveBeenCalled();
  expect(fit).not.toHaveBeenCalled();
  observe(frame(2, 900, false));
  observe(frame(1, 900));
  expect(panBy).toHaveBeenCalledTimes(1);
});

it('comes back where it went along and all stand at the start again, but not in another world', () => {
  observe(frame(5, 900));
  observe(frame(0, 500, false));
  expect(fit).toHaveBeenCalledTimes(1);
  observe(frame(5, 900));
  camera.forget();
  observe(frame(0, 500, false));
  expect(fit).toHaveBeenCalledTimes(1);
});
