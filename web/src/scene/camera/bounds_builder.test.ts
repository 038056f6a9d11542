import { describe, expect, it } from 'vitest';
import { BoundsBuilder } from './bounds_builder';

describe('BoundsBuilder', () => {
  it('holds all points in its outline, with room', () => {
    const box = new BoundsBuilder();
    const points: [number, number][] = [];
    for (let i = 0; i < 200; ++i) points.push([30 * Math.sin(i * 1.7), 12 * Math.cos(i * 2.9)]);
    box.addAll(points.flat());
    const outline = box.outline();
    for (let d = 0; d < 12; ++d) {
      const along = (x: number, y: number): number => x * Math.cos(d / 2) + y * Math.sin(d / 2);
      const most = Math.max(...points.map(([x, y]) => along(x, y)));
      const reach = Math.max(...outline.map((p) => along(p.x, p.y)));
      expect(reach).toBeGreaterThan(most);
      expect(reach).toBeLessThan(most + 3);
    }
  });

  it('keeps a small crowd from filling the window, and ignores what is no number', () => {
    const box = new BoundsBuilder();
    expect(box.outline()).toEqual([]);
    box.add(5, 5);
    box.add(NaN, 1);
    const xs = box.outline().map((p) => p.x);
    expect(Math.max(...xs) - Math.min(...xs)).toBeCloseTo(20, 5);
  });
});
