import { describe, expect, it } from 'vitest';
import {
  editedPoints,
  editOf,
  fasterFrom,
  laterFrom,
  longerPart,
  movedPin,
  ownTime,
  pinOffset,
  pinWeight,
  placeAt,
  runs,
  takeTime,
  withPart,
  withPin,
} from './people_edit';
import { wayOf } from './take_path';

const straight = wayOf(Array.from({ length: 41 }, (_, k) => [k * 0.5, 0]).flat(), 15, 1 / 60);

describe('edits of people', () => {
  it('moves a path by its pins as the server does: each is met', () => {
    const pins = [
      { time: 2, x: 1, y: 0.5, seconds: 3 },
      { time: 3, x: -1, y: 2, seconds: 0.5 },
    ];
    expect(pinWeight(0.5)).toBe(0.5);
    for (const { time, x, y } of pins) expect(pinOffset(pins, time)).toEqual({ x, y });
    expect(pinOffset(pins, 9)).toEqual({ x: 0, y: 0 });
    expect(pinOffset(pins, 0.5).y).toBeCloseTo(0.25, 12);
    const points = editedPoints(straight, pins);
    expect(points[8]).toEqual({ x: 5, y: 0.5 });
    expect(points[40]).toEqual({ x: 20, y: 0 });
    expect(placeAt(straight, pins, 2.125)!.x).toBeCloseTo(4.25 + pinOffset(pins, 2.125).x, 12);
    expect(placeAt(wayOf([], 15, 1 / 60), [], 1)).toBeNull();
  });

  it('puts a new pin where the path is, and takes the one that is there', () => {
    const one = withPin([{ time: 2, x: 0, y: 2, seconds: 2 }], 3, 2);
    expect(one.at).toBe(1);
    expect(one.pins[1]).toEqual({ time: 3, x: 0, y: 1, seconds: 2 });
    expect(withPin(one.pins, 3.05, 2)).toEqual({ pins: one.pins, at: 1 });
    expect(movedPin(one.pins, 1, { x: 1, y: 1 })[1]).toEqual({ time: 3, x: 1, y: 1, seconds: 2 });
  });

  it('shows later what comes after a moment, and runs faster for a while', () => {
    const later = laterFrom([], 6, 1);
    expect(later).toEqual([
      { time: 3, own: 3 },
      { time: 6, own: 5 },
    ]);
    expect(ownTime(later, 2)).toBe(2);
    expect(ownTime(later, 9)).toBe(8);
    expect(takeTime(later, ownTime(later, 4.2))).toBeCloseTo(4.2, 6);
    expect(runs(later)).toBe(true);
    expect(runs(laterFrom(laterFrom(later, 6, 1), 6, 1))).toBe(false);
    const faster = fasterFrom([], 4, 1.5, 2);
    expect(ownTime(faster, 6)).toBe(7);
    expect(ownTime(faster, 8)).toBe(9);
    expect(takeTime(faster, 9)).toBe(8);
    expect(runs(faster)).toBe(true);
  });

  it('keeps parts apart', () => {
    const clip = { name: 'jog', from: 0, to: 0 };
    const one = withPart([], clip, 4)!;
    expect(one).toEqual([{ name: 'jog', from: 4, to: 7 }]);
    expect(withPart(one, clip, 5)).toBeNull();
    expect(withPart(one, clip, 2)![0]).toEqual({ name: 'jog', from: 2, to: 4 });
    expect(longerPart(one, 0, -9)[0]!.to).toBe(4.5);
  });

  it('finds the edit that all the chosen share', () => {
    const pins = [{ time: 1, x: 1, y: 0, seconds: 2 }];
    const edits = [{ people: Uint32Array.of(2, 5), pins, clock: [], clips: [], looks: [] }];
    expect(editOf(edits, [5]).pins).toEqual(pins);
    expect([...editOf(edits, [5, 2]).people]).toEqual([2, 5]);
    expect(editOf(edits, [5, 6]).pins).toEqual([]);
  });
});
