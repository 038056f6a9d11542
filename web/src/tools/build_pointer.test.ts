// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import { BuildPointer, type BuildStrokes } from './build_pointer';

const strokes = {
  begin: vi.fn(),
  move: vi.fn(),
  end: vi.fn(),
  cancel: vi.fn(),
  doubleTap: vi.fn(),
  threeFingers: vi.fn(),
} satisfies BuildStrokes;
const camera = { pan: vi.fn(), pinch: vi.fn(), zoomAt: vi.fn(), orbit: vi.fn() };
let surface: SVGSVGElement;

function fire(type: string, id: number, x: number, y: number, more: Record<string, unknown> = {}): void {
  const event = new MouseEvent(type, { clientX: x, clientY: y, bubbles: true, ...more });
  Object.defineProperties(event, {
    pointerId: { value: id },
    pointerType: { value: more['pointerType'] ?? 'touch' },
    timeStamp: { value: more['time'] ?? 0 },
  });
  surface.dispatchEvent(event);
}

beforeEach(() => {
  for (const one of [...Object.values(strokes), ...Object.values(camera)]) one.mockClear();
  surface = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  new BuildPointer(
    strokes,
    camera,
    ({ x, y }) => (y < 0 ? null : { x: x / 10, y: y / 10 }),
    () => undefined,
  ).listen(surface);
});

it('tells a stroke from a tap', () => {
  fire('pointerdown', 1, 100, 100);
  fire('pointermove', 1, 103, 100);
  fire('pointermove', 1, 140, 100);
  fire('pointermove', 1, 102, 100);
  fire('pointerup', 1, 140, 100);
  expect(strokes.move.mock.calls.map((call: readonly unknown[]) => call[1])).toEqual([true, false, false]);
  expect(strokes.begin).toHaveBeenCalledWith(expect.objectContaining({ ground: { x: 10, y: 10 } }));
  expect(strokes.end.mock.calls[0]![1]).toBe(false);
  fire('pointerdown', 2, 50, 50);
  fire('pointerup', 2, 52, 50);
  expect(strokes.end.mock.calls[1]![1]).toBe(true);
});

it('leaves the drawing to move the camera with two fingers', () => {
  fire('pointerdown', 1, 100, 100);
  fire('pointerdown', 2, 200, 100);
  expect(strokes.cancel).toHaveBeenCalledTimes(1);
  fire('pointermove', 2, 240, 100);
  expect(camera.pinch).toHaveBeenCalledWith(
    [
      { x: 100, y: 100 },
      { x: 200, y: 100 },
    ],
    [
      { x: 100, y: 100 },
      { x: 240, y: 100 },
    ],
  );
  fire('pointerup', 1, 100, 100);
  fire('pointerup', 2, 240, 100);
  expect(strokes.end).not.toHaveBeenCalled();
  expect(strokes.threeFingers).not.toHaveBeenCalled();
});

it('takes three fingers that tap for the way back, not three that move or rest', () => {
  const tap = (time: number, dx: number): void => {
    for (const id of [1, 2, 3]) fire('pointerdown', id, 100 * id, 100, { time: 0 });
    if (dx > 0) fire('pointermove', 2, 200 + dx, 100, { time: 10 });
    for (const id of [1, 2, 3]) fire('pointerup', id, 100 * id, 100, { time });
  };
  tap(120, 0);
  expect(strokes.threeFingers).toHaveBeenCalledTimes(1);
  tap(120, 40);
  tap(900, 0);
  expect(strokes.threeFingers).toHaveBeenCalledTimes(1);
});

it('pans by the right button, turns by the middle one and zooms by the wheel', () => {
  fire('pointerdown', 1, 100, 100, { button: 2, pointerType: 'mouse' });
  fire('pointermove', 1, 120, 100, { pointerType: 'mouse' });
  fire('pointerup', 1, 120, 100, { pointerType: 'mouse' });
  fire('pointerdown', 1, 100, 100, { button: 1, pointerType: 'mouse' });
  fire('pointermove', 1, 120, 100, { pointerType: 'mouse' });
  fire('pointerup', 1, 120, 100, { pointerType: 'mouse' });
  surface.dispatchEvent(new WheelEvent('wheel', { deltaY: -100 }));
  expect([camera.pan, camera.orbit, camera.zoomAt].map((one) => one.mock.calls.length)).toEqual([1, 1, 1]);
  expect(strokes.begin).not.toHaveBeenCalled();
});

it('drops a stroke that ends above the horizon, or that the browser takes away', () => {
  fire('pointerdown', 1, 100, 100);
  fire('pointercancel', 1, 100, 100);
  fire('pointerdown', 1, 100, 100);
  fire('pointerup', 1, 100, -5);
  expect(strokes.cancel).toHaveBeenCalledTimes(2);
  expect(strokes.end).not.toHaveBeenCalled();
});
