// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { ThreeFingerTap } from './three_finger_tap';

let taps = 0;
let target: HTMLElement;

function point(type: string, pointerId: number, at: { x?: number; time?: number; kind?: string } = {}): void {
  const event = new Event(type);
  Object.assign(event, { pointerId, pointerType: at.kind ?? 'touch', clientX: at.x ?? 0, clientY: 0 });
  Object.defineProperty(event, 'timeStamp', { value: at.time ?? 0 });
  target.dispatchEvent(event);
}

function tap(ids: readonly number[], time = 200): void {
  for (const id of ids) point('pointerdown', id);
  for (const id of ids) point('pointerup', id, { time });
}

beforeEach(() => {
  taps = 0;
  target = document.createElement('div');
  new ThreeFingerTap(target, () => (taps += 1));
});

it('knows three fingers, and not two or four', () => {
  tap([1, 2]);
  tap([1, 2, 3, 4]);
  expect(taps).toBe(0);
  tap([1, 2, 3]);
  expect(taps).toBe(1);
});

it('is no tap where it lasts, moves or is broken off', () => {
  tap([1, 2, 3], 900);
  for (const id of [1, 2, 3]) point('pointerdown', id);
  point('pointermove', 2, { x: 30 });
  for (const id of [1, 2, 3]) point('pointerup', id);
  for (const id of [1, 2, 3]) point('pointerdown', id);
  point('pointercancel', 1);
  for (const id of [2, 3]) point('pointerup', id);
  expect(taps).toBe(0);
  tap([5, 6, 7]);
  expect(taps).toBe(1);
});

it('leaves the mouse alone', () => {
  for (const id of [1, 2, 3]) point('pointerdown', id, { kind: 'mouse' });
  for (const id of [1, 2, 3]) point('pointerup', id, { kind: 'mouse' });
  expect(taps).toBe(0);
});
