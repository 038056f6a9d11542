import { describe, expect, it } from 'vitest';
import { pathPoints, roundOrder, smooth, thinned } from './control_shapes';

describe('control shapes', () => {
  it('a smooth path goes through its points and keeps a straight line straight', () => {
    const points = [{ x: 0, y: 0 }, { x: 1, y: 2 }, { x: 3, y: 2 }, { x: 4, y: 0 }];
    const curve = smooth(points, 5);
    expect(curve).toHaveLength(16);
    points.forEach((point, i) => expect(curve[5 * i]).toEqual(point));
    const straight = smooth([0, 1, 2, 3].map((x) => ({ x, y: 2 * x })), 4);
    for (const point of straight) expect(point.y).toBeCloseTo(2 * point.x);
  });

  it('thins checkpoints to a spacing, without the ends', () => {
    const points = Array.from({ length: 41 }, (_, i) => ({ x: 0.5 * i, y: 0 }));
    const kept = thinned(points, 2);
    expect(kept[0]).toBe(4);
    for (let i = 1; i < kept.length; ++i) expect((kept[i] ?? 0) - (kept[i - 1] ?? 0)).toBe(4);
    expect(kept).not.toContain(40);
    expect(thinned(points.slice(0, 2), 1)).toEqual([]);
  });

  it('puts corners in an order that does not cross', () => {
    const corners = [{ x: 0, y: 0 }, { x: 1, y: 1 }, { x: 1, y: 0 }, { x: 0, y: 1 }];
    const order = roundOrder(corners);
    expect([...order].sort()).toEqual([0, 1, 2, 3]);
    for (let i = 0; i < 4; ++i) {
      const a = corners[order[i] ?? 0];
      const b = corners[order[(i + 1) % 4] ?? 0];
      expect(Math.hypot((a?.x ?? 0) - (b?.x ?? 0), (a?.y ?? 0) - (b?.y ?? 0))).toBe(1);
    }
  });

  it('starts a path at its handle', () => {
    expect(pathPoints({ x: 1, y: 2 }, [3, 4, 5, 6])).toEqual([{ x: 1, y: 2 }, { x: 3, y: 4 }, { x: 5, y: 6 }]);
  });
});
