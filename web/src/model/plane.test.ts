import { describe, expect, it } from 'vitest';
import { middleOf, convexHull, distanceToSegment, insidePolygon, insideTriangle, pointsOf, turn } from './plane';

const a = { x: 0, y: 0 };
const b = { x: 4, y: 0 };
const c = { x: 0, y: 3 };

describe('distanceToSegment', () => {
  it('measures to the line between the ends and to the ends beyond them', () => {
    expect(distanceToSegment({ x: 2, y: 1.5 }, a, b)).toBeCloseTo(1.5);
    expect(distanceToSegment({ x: 7, y: 4 }, a, b)).toBeCloseTo(5);
  });
  it('takes a segment without length for a point', () => {
    expect(distanceToSegment({ x: 3, y: 4 }, a, a)).toBeCloseTo(5);
  });
});

describe('insideTriangle', () => {
  it('knows inside, outside and edges, whichever way the corners turn', () => {
    expect(insideTriangle({ x: 1, y: 1 }, a, b, c)).toBe(true);
    expect(insideTriangle({ x: 1, y: 1 }, a, c, b)).toBe(true);
    expect(insideTriangle({ x: 3, y: 3 }, a, b, c)).toBe(false);
    expect(insideTriangle({ x: 2, y: 0 }, a, b, c)).toBe(true);
  });
});

describe('insidePolygon', () => {
  it('respects a dent', () => {
    const dented = [a, b, { x: 4, y: 4 }, { x: 2, y: 1 }, { x: 0, y: 4 }];
    expect(insidePolygon({ x: 2, y: 0.5 }, dented)).toBe(true);
    expect(insidePolygon({ x: 2, y: 3 }, dented)).toBe(false);
  });
});

describe('convexHull', () => {
  it('keeps the corners of a filled square, counter-clockwise', () => {
    const points = [];
    for (let x = 0; x <= 4; ++x) for (let y = 0; y <= 4; ++y) points.push({ x, y });
    const hull = convexHull(points);
    expect(hull).toHaveLength(4);
    hull.forEach((p, i) => expect(turn(p, hull[(i + 1) % 4]!, hull[(i + 2) % 4]!)).toBeGreaterThan(0));
  });
  it('gives two ends for points on one line', () => {
    expect(convexHull([a, b, { x: 2, y: 0 }])).toHaveLength(2);
  });
});

describe('middleOf and pointsOf', () => {
  it('read pairs and average them', () => {
    expect(pointsOf([1, 2, 3, 4])).toEqual([
      { x: 1, y: 2 },
      { x: 3, y: 4 },
    ]);
    expect(middleOf(pointsOf([0, 0, 4, 0, 4, 2, 0, 2]))).toEqual({ x: 2, y: 1 });
  });
});
