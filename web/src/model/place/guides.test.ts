import { describe, expect, it } from 'vitest';
import { aligned } from './guides';
import { thing } from './things';

const box = (x: number, y: number, w: number, h: number) =>
  thing('obstacle', {
    polygon: [
      [x, y],
      [x + w, y],
      [x + w, y + h],
      [x, y + h],
    ],
    centre: [x + w / 2, y + h / 2],
  });

describe('guides', () => {
  it('line edges up with the nearest edge of another, each axis by itself', () => {
    const { dx, dy, guides } = aligned([box(0, 0, 2, 2)], [box(10, 5, 2, 3)], 9.85, 1, 0.3);
    expect(dx).toBeCloseTo(10, 12);
    expect(dy).toBe(1);
    expect(guides).toEqual([{ from: { x: 10, y: 1 }, to: { x: 10, y: 8 } }]);
  });

  it('line middles up', () => {
    const { dx, dy, guides } = aligned([box(0, 0, 2, 2)], [box(-1, 6, 4, 4)], 0.1, 0, 0.3);
    // The middles at x = 1.
    expect(dx).toBeCloseTo(0, 12);
    expect(dy).toBe(0);
    expect(guides).toHaveLength(1);
    expect(guides[0]!.from.x).toBeCloseTo(1, 12);
  });

  it('line both axes up with different others', () => {
    const others = [box(20, 0, 1, 1), box(0, 20, 3, 1)];
    const { dx, dy, guides } = aligned([box(0, 0, 2, 2)], others, 0.05, -0.05, 0.2);
    expect([dx, dy]).toEqual([0, 0]);
    expect(guides).toHaveLength(2);
  });

  it('leave alone what is far, and what has no others', () => {
    expect(aligned([box(0, 0, 2, 2)], [box(10, 10, 2, 2)], 1.1, 1.2, 0.3)).toEqual({ dx: 1.1, dy: 1.2, guides: [] });
    expect(aligned([box(0, 0, 2, 2)], [], 1.1, 1.2, 0.3)).toEqual({ dx: 1.1, dy: 1.2, guides: [] });
  });
});
