import { describe, expect, it } from 'vitest';
import { areaOf } from '../outline';
import { insidePolygon, type GroundPoint } from '../plane';
import { withoutCourtyards } from './courtyards';
import { isSimple, mendedRing, type Ring } from './rings';
import { wallsAlong } from './walls';

const ring = (...xy: readonly number[]): GroundPoint[] =>
  Array.from({ length: xy.length / 2 }, (_, i) => ({ x: xy[2 * i]!, y: xy[2 * i + 1]! }));
const areas = (rings: readonly Ring[] | string | null): number =>
  typeof rings === 'string' || !rings ? NaN : rings.reduce((sum, one) => sum + areaOf(one), 0);

describe('a ring from a file', () => {
  it('loses repeated corners, spikes and corners on a line, and turns counter-clockwise', () => {
    const found = mendedRing(ring(0, 0, 0, 4, 0, 4, 2, 4, 4, 4, 4, 2, 9, 2, 4, 2, 4, 0, 2, 0, 0, 0));
    expect(found).toHaveLength(1);
    expect((found as Ring[])[0]).toHaveLength(4);
    expect(areas(found)).toBeCloseTo(16, 9);
  });

  it('is two rings where it comes back to a corner', () => {
    const found = mendedRing(ring(0, 0, 2, 0, 2, 2, 4, 2, 4, 4, 2, 4, 2, 2, 0, 2));
    expect(found).toHaveLength(2);
    expect(areas(found)).toBeCloseTo(8, 9);
  });

  it('is mended where it crosses itself by a little, and refused where by much', () => {
    expect(areas(mendedRing(ring(0, 0, 10, 0, 10, 10, 5.02, 10, 5, 10.02, 5.03, 9.99, 0, 10)))).toBeCloseTo(100, 0);
    expect(mendedRing(ring(0, 0, 10, 10, 10, 0, 0, 10))).toBe('crosses');
  });

  it('tells what it lacks', () => {
    expect(mendedRing(ring(0, 0, 1, NaN, 1, 1))).toBe('numbers');
    expect(mendedRing(ring(0, 0, 5, 0, 9, 0))).toBe('flat');
    expect(mendedRing(ring(0, 0, 1, 1))).toBe('flat');
    expect(mendedRing([])).toBe('flat');
  });

  it('with thousands of corners takes no time', () => {
    const many = Array.from({ length: 6000 }, (_, i) => {
      const a = (2 * Math.PI * i) / 6000;
      return { x: (500 + 20 * Math.sin(90 * a)) * Math.cos(a), y: (500 + 20 * Math.sin(90 * a)) * Math.sin(a) };
    });
    const start = performance.now();
    expect(mendedRing(many)).toHaveLength(1);
    expect(performance.now() - start).toBeLessThan(3000);
  });
});

describe('courtyards', () => {
  const outer = ring(0, 0, 30, 0, 30, 20, 0, 20);

  it('are cut out, and the pieces are simple and side by side', () => {
    const yards = [ring(2, 2, 12, 2, 12, 18, 2, 18), ring(16, 5, 24, 6, 23, 14, 15, 13)];
    const pieces = withoutCourtyards(outer, yards)!;
    expect(pieces.length).toBeGreaterThan(1);
    expect(areas(pieces)).toBeCloseTo(600 - 160 - Math.abs(areaOf(yards[1]!)), 2);
    expect(pieces.every(isSimple)).toBe(true);
    const covered = (x: number, y: number): number => pieces.filter((one) => insidePolygon({ x, y }, one)).length;
    expect([covered(7, 10), covered(20, 10), covered(1, 10), covered(28, 3), covered(14, 10)]).toEqual([0, 0, 1, 1, 1]);
  });

  it('are filled where they are small', () => {
    const pieces = withoutCourtyards(outer, [ring(5, 5, 6, 5, 6, 6, 5, 6)])!;
    expect(areas(pieces)).toBeCloseTo(600, 9);
  });

  it('of any number are cut', () => {
    const yards = Array.from({ length: 12 }, (_, i) => {
      const [x, y] = [2 + 7 * (i % 4), 1.5 + 6 * Math.floor(i / 4)];
      return ring(x, y, x + 3, y, x + 3, y + 3, x, y + 3);
    });
    const pieces = withoutCourtyards(outer, yards)!;
    expect(areas(pieces)).toBeCloseTo(600 - 12 * 9, 1);
    expect(pieces.every(isSimple)).toBe(true);
  });
});

describe('walls', () => {
  it('have the length and width of their line', () => {
    const [only, ...more] = wallsAlong(ring(0, 0, 10, 0, 10, 6), 0.4);
    expect(more).toHaveLength(0);
    // The mitre adds at the outer corner what it takes at the inner one.
    expect(areaOf(only!)).toBeCloseTo(16 * 0.4, 6);
    expect(insidePolygon({ x: 10.15, y: -0.15 }, only!)).toBe(true);
  });

  it('close round a closed line, and break up where one outline would cross itself', () => {
    const closed = wallsAlong(ring(0, 0, 8, 0, 8, 8, 0, 8, 0, 0), 0.5);
    expect(areas(closed)).toBeCloseTo(32 * 0.5, 0);
    expect(closed.every((one) => !insidePolygon({ x: 4, y: 4 }, one))).toBe(true);
    const knot = wallsAlong(ring(0, 0, 10, 0, 10, 5, 5, 5, 5, -5), 0.5);
    expect(knot).toHaveLength(4);
    expect(knot.every(isSimple)).toBe(true);
    expect(wallsAlong(ring(1, 1, 1, 1), 0.5)).toEqual([]);
  });
});
