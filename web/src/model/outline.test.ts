import { describe, expect, it } from 'vitest';
import { areaOf, centreOf, outlineFrom } from './outline';
import type { GroundPoint } from './plane';

function corners(stroke: readonly GroundPoint[]): readonly GroundPoint[] {
  const found = outlineFrom(stroke);
  if ('why' in found) throw new Error(found.why);
  return found.corners;
}

const circle = (n: number, turns: number, radius = 5): GroundPoint[] =>
  Array.from({ length: n }, (_, i) => ({
    x: 3 + radius * Math.cos((turns * 2 * Math.PI * i) / (n - 1)),
    y: -2 - radius * Math.sin((turns * 2 * Math.PI * i) / (n - 1)),
  }));

describe('outlineFrom', () => {
  it('keeps shape, turns counter-clockwise, and needs few corners', () => {
    const found = corners(circle(400, 0.98));
    expect(found.length).toBeLessThan(40);
    expect(areaOf(found)).toBeGreaterThan(0.97 * Math.PI * 25);
    expect(centreOf(found).x).toBeCloseTo(3, 1);
    expect(centreOf(found).y).toBeCloseTo(-2, 1);
  });
  it('cuts off ends that hang over', () => {
    const stroke = [
      { x: -3, y: 0 },
      ...[0, 1, 2, 3, 4].map((i) => ({ x: 2 * i, y: 0 })),
      { x: 8, y: 8 },
      { x: 0, y: 8 },
      { x: 0, y: 4 },
      { x: 0, y: -3 },
    ];
    const found = corners(stroke);
    expect(areaOf(found)).toBeCloseTo(64, 6);
    expect(found.length).toBe(4);
  });
  it('says why a stroke is no outline', () => {
    expect(outlineFrom(circle(40, 1, 0.3))).toEqual({ why: expect.stringContaining('too small') as string });
    const eight = Array.from({ length: 100 }, (_, i) => ({
      x: 6 * Math.sin((2 * Math.PI * i) / 100 + 0.3),
      y: 8 * Math.sin((4 * Math.PI * i) / 100 + 0.6) + 0.05 * i,
    }));
    const found = outlineFrom(eight);
    expect('why' in found).toBe(true);
    expect(outlineFrom([])).toHaveProperty('why');
  });
});
