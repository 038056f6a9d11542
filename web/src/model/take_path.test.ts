import { describe, expect, it } from 'vitest';
import { bendWeight, bent, grabbed, pointAt, timesBeside, wayOf } from './take_path';

const straight = wayOf(Array.from({ length: 41 }, (_, k) => [k * 0.5, 0]).flat(), 15, 1 / 60);
const toScreen = ({ x, y }: { x: number; y: number }): { x: number; y: number } => ({ x: 40 * x, y: 300 - 40 * y });

describe('take path', () => {
  it('bends as the server bends: by (1 - t²)²', () => {
    expect(bendWeight(0, 3)).toBe(1);
    expect(bendWeight(1.5, 3)).toBeCloseTo(0.5625, 12);
    expect(bendWeight(-1.5, 3)).toBe(bendWeight(1.5, 3));
    expect(bendWeight(3, 3)).toBe(0);
    expect(bendWeight(99, 3)).toBe(0);
  });

  it('moves the point that is held by all of the pull, and the ends not at all', () => {
    const points = bent(straight, { at: 20, dx: 1, dy: -2 }, 2);
    expect(points[20]).toEqual({ x: 11, y: -2 });
    expect(points[12]).toEqual({ x: 6, y: 0 });
    expect(points[28]).toEqual({ x: 14, y: 0 });
    // A second of two: (1 - 1/4)².
    expect(points[24]!.y).toBeCloseTo(-2 * 0.5625, 12);
    expect(bent(straight, { at: 20, dx: 0, dy: 0 }, 2)).toEqual(straight.points);
  });

  it('finds the point of a moment, within the path', () => {
    expect(pointAt(straight, 0)).toBe(0);
    expect(pointAt(straight, 157)).toBe(10);
    expect(pointAt(straight, 99999)).toBe(40);
  });

  it('is taken hold of at the nearest point, also between two', () => {
    expect(grabbed(straight, { x: 203, y: 305 }, toScreen, 22, 0)).toBe(10);
    expect(grabbed(straight, { x: 209, y: 318 }, toScreen, 22, 0)).toBe(10);
    expect(grabbed(straight, { x: 203, y: 330 }, toScreen, 22, 0)).toBe(-1);
    const sparse = wayOf([0, 0, 10, 0], 15, 1 / 60);
    expect(grabbed(sparse, { x: 150, y: 302 }, toScreen, 22, 0)).toBe(0);
    expect(grabbed(sparse, { x: 250, y: 302 }, toScreen, 22, 0)).toBe(1);
  });

  it('takes the shown moment where somebody stood', () => {
    const stood = wayOf(Array.from({ length: 30 }, () => [2, 2]).flat(), 15, 1 / 60);
    expect(grabbed(stood, toScreen({ x: 2, y: 2 }), toScreen, 22, 15 * 17)).toBe(17);
  });

  it('writes whole seconds, as far apart as they can be read', () => {
    const screen = straight.points.map(toScreen);
    // A second is 80 px.
    expect(timesBeside(straight, screen, 40)).toEqual([0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40]);
    expect(timesBeside(straight, screen, 100)).toEqual([0, 8, 16, 24, 32, 40]);
  });

  it('survives nothing', () => {
    const none = wayOf([], 15, 1 / 60);
    expect(bent(none, { at: 0, dx: 1, dy: 1 }, 2)).toEqual([]);
    expect(grabbed(none, { x: 0, y: 0 }, toScreen, 22, 0)).toBe(-1);
    expect(timesBeside(none, [], 40)).toEqual([]);
  });
});
