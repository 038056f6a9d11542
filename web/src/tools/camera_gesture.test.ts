import { beforeEach, describe, expect, it } from 'vitest';
import { CameraGesture, OrbitGesture } from './camera_gesture';
import { contactAt } from './test_support';

let calls: string[];
const at = (p: { x: number; y: number }): string => `${p.x},${p.y}`;
const camera = {
  pan: (from: { x: number; y: number }, to: { x: number; y: number }) => calls.push(`pan ${at(from)} ${at(to)}`),
  panBy: () => undefined,
  pinch: (a: readonly { x: number; y: number }[], b: readonly { x: number; y: number }[]) =>
    calls.push(`pinch ${a.map(at).join(' ')} > ${b.map(at).join(' ')}`),
  zoomAt: () => undefined,
  orbit: (turn: number, tilt: number) => calls.push(`orbit ${turn.toFixed(3)} ${tilt.toFixed(3)}`),
  fit: () => undefined,
};

beforeEach(() => {
  calls = [];
});

describe('CameraGesture', () => {
  it('pans with one finger', () => {
    const gesture = new CameraGesture(camera);
    gesture.begin(contactAt(1, 1));
    gesture.move([contactAt(2, 1), contactAt(3, 1)]);
    gesture.end(contactAt(3, 1));
    gesture.move([contactAt(4, 1)]);
    expect(calls).toEqual(['pan 100,100 300,100']);
  });
  it('pinches with two, whichever moves, and pans again when one lifts', () => {
    const gesture = new CameraGesture(camera);
    gesture.begin(contactAt(0, 0, { pointer: 7 }));
    gesture.begin(contactAt(4, 0, { pointer: 9 }));
    gesture.move([contactAt(5, 0, { pointer: 9 })]);
    gesture.move([contactAt(1, 0, { pointer: 7 })]);
    gesture.end(contactAt(1, 0, { pointer: 7 }));
    gesture.move([contactAt(6, 0, { pointer: 9 })]);
    expect(calls).toEqual(['pinch 0,0 400,0 > 0,0 500,0', 'pinch 0,0 500,0 > 100,0 500,0', 'pan 500,0 600,0']);
  });
  it('tilts with two side by side that go up or down together', () => {
    const gesture = new CameraGesture(camera);
    gesture.begin(contactAt(1, 5, { pointer: 7 }));
    gesture.begin(contactAt(3, 5.2, { pointer: 9 }));
    for (let i = 1; i <= 10; ++i) {
      gesture.move([contactAt(1, 5 - 0.05 * i, { pointer: 7 })]);
      gesture.move([contactAt(3.02, 5.2 - 0.05 * i, { pointer: 9 })]);
    }
    expect(calls.every((call) => call.startsWith('orbit 0.000'))).toBe(true);
    const tilt = calls.reduce((sum, call) => sum + Number(call.split(' ')[2]), 0);
    expect(tilt).toBeCloseTo(-0.0045 * 50, 2);
  });
  it('moves the view with two, one above the other, that go up together', () => {
    const gesture = new CameraGesture(camera);
    gesture.begin(contactAt(1, 5, { pointer: 7 }));
    gesture.begin(contactAt(1.2, 3, { pointer: 9 }));
    for (let i = 1; i <= 4; ++i) {
      gesture.move([contactAt(1, 5 - 0.1 * i, { pointer: 7 })]);
      gesture.move([contactAt(1.2, 3 - 0.1 * i, { pointer: 9 })]);
    }
    expect(calls.length).toBeGreaterThan(0);
    expect(calls.every((call) => call.startsWith('pinch'))).toBe(true);
  });
  it('lets a third finger wait', () => {
    const gesture = new CameraGesture(camera);
    for (const pointer of [1, 2, 3]) gesture.begin(contactAt(pointer, 0, { pointer }));
    gesture.move([contactAt(9, 9, { pointer: 3 })]);
    expect(calls).toEqual([]);
  });
});

it('OrbitGesture turns with x and tilts with y', () => {
  const gesture = new OrbitGesture(camera);
  gesture.begin(contactAt(1, 1));
  gesture.move([contactAt(2, 0.5)]);
  expect(calls).toEqual(['orbit -0.600 -0.200']);
});
