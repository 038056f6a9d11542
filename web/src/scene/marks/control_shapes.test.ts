import { describe, expect, it } from 'vitest';
import { pathPoints, smooth, thinned } from './control_shapes';

describe('control shapes', () => {
  it('a smooth path goes through its points and keeps a straight line straight', () => {
    const points = [
      { x: 0, y: 0 },
      { x: 1, y: 2 },
      { x: 3, y: 2 },
      { x: 4, y: 0 },
    ];
    const curve = smooth(points, 5);
    expect(curve).toHaveLength(16);
    points.forEach((point, i) => expect(curve[5 * i]).toEqual(point));
    const straight = smooth(
      [0, 1, 2, 3].map((x) => ({ x, y: 2 * x })),
      4,
    );
    for (const point of straight) expect(point.y).toBeCloseTo(2 * point.x);
  });

  it('a smooth path makes no hook where its last span is short', () => {
    const points = [
      { x: 0, y: 0 },
      { x: 1, y: 0 },
      { x: 2, y: 0 },
      { x: 2, y: 0.02 },
    ];
    for (const point of smooth(points, 8)) expect(point.x).toBeLessThan(2.02);
    const again = [
      { x: 0, y: 0 },
      { x: 1, y: 0 },
      { x: 1, y: 0 },
      { x: 2, y: 0 },
    ];
    for (const point of smooth(again, 4)) expect(Number.isFinite(point.x) && Math.abs(point.y) < 1e-9).toBe(true);
  });

  it('thins checkpoints to a spacing, counted from the far end, without the ends', () => {
    const points = Array.from({ length: 42 }, (_, i) => ({ x: 0.5 * i, y: 0 }));
    const kept = thinned(points, 2);
    expect(kept[kept.length - 1]).toBe(37);
    for (let i = 1; i < kept.length; ++i) expect((kept[i] ?? 0) - (kept[i - 1] ?? 0)).toBe(4);
    expect(kept).not.toContain(0);
    expect(thinned(points.slice(0, 2), 1)).toEqual([]);
  });

  it('keeps checkpoints where they were while the path is walked at one end and drawn at the other', () => {
    const all = Array.from({ length: 80 }, (_, i) => ({ x: 0.25 * i, y: Math.sin(0.1 * i) }));
    let shown: { x: number; y: number }[] = [];
    for (let round = 0; round < 40; ++round) {
      // The handle has walked on, the finger is ahead of the last checkpoint.
      const walked = { x: 0.2 * round, y: Math.sin(0.08 * round) };
      const ahead = all.slice(0, 40 + round).filter((p) => p.x > walked.x);
      const points = [walked, ...ahead, { x: (ahead[ahead.length - 1]?.x ?? 0) + 0.1, y: 0 }];
      const next = thinned(points, 1.4, shown).map((i) => points[i]!);
      const still = shown.filter((p) => p.x > walked.x);
      expect(next.filter((p) => still.includes(p))).toEqual(still);
      expect(next.length).toBeGreaterThan(3);
      shown = next;
    }
  });

  it('starts a path at its handle', () => {
    expect(pathPoints({ x: 1, y: 2 }, [3, 4, 5, 6])).toEqual([
      { x: 1, y: 2 },
      { x: 3, y: 4 },
      { x: 5, y: 6 },
    ]);
  });
});
