import { describe, expect, it } from 'vitest';
import { spreadOver, type Mask } from './spread';

/** A disc of radius 20 in a picture of 60 by 50. */
const disc: Mask = {
  width: 60,
  height: 50,
  cells: Uint8Array.from({ length: 3000 }, (_, i) => (Math.hypot((i % 60) - 30, Math.floor(i / 60) - 25) < 20 ? 1 : 0)),
};

describe('spreadOver', () => {
  it('gives exactly as many places, all on the dark, well apart', () => {
    const { places, gap } = spreadOver(disc, 37);
    expect(places.length).toBe(37);
    for (const { x, y } of places) expect(Math.hypot(x, y)).toBeLessThan(21.5);
    let least = Infinity;
    places.forEach((a, i) =>
      places.slice(i + 1).forEach((b) => (least = Math.min(least, Math.hypot(a.x - b.x, a.y - b.y)))),
    );
    expect(least).toBeCloseTo(gap, 9);
    // A perfect packing of 37 circles would have some 6.3.
    expect(gap).toBeGreaterThan(4.2);
    expect(spreadOver(disc, 37)).toEqual({ places, gap });
  });
  it('is empty where nothing is dark, and takes every cell where there are too few', () => {
    expect(spreadOver({ width: 3, height: 3, cells: new Uint8Array(9) }, 5).places).toEqual([]);
    expect(spreadOver({ width: 2, height: 1, cells: Uint8Array.of(1, 1) }, 5).places.length).toBe(2);
  });
});
