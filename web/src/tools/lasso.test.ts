import { describe, expect, it } from 'vitest';
import { insidePolygon } from '../model/plane';
import { lassoCorners } from './lasso';

function circle(count: number, radius: number) {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
  });
}

describe('lassoCorners', () => {
  it('makes at most six corners of a round loop and keeps its middle', () => {
    const corners = lassoCorners(circle(60, 3));
    expect(corners.length).toBeGreaterThanOrEqual(3);
    expect(corners.length).toBeLessThanOrEqual(6);
    expect(insidePolygon({ x: 0, y: 0 }, corners)).toBe(true);
  });
  it('keeps the four corners of a drawn square', () => {
    const loop = [];
    for (let i = 0; i < 10; ++i) loop.push({ x: i, y: 0 });
    for (let i = 0; i < 10; ++i) loop.push({ x: 10, y: i });
    for (let i = 10; i > 0; --i) loop.push({ x: i, y: 10 });
    for (let i = 10; i > 0; --i) loop.push({ x: 0, y: i });
    expect(lassoCorners(loop)).toHaveLength(4);
  });
  it('keeps a triangle', () => {
    expect(
      lassoCorners([
        { x: 0, y: 0 },
        { x: 6, y: 0 },
        { x: 3, y: 5 },
      ]),
    ).toHaveLength(3);
  });
  it('refuses loops that hold nothing', () => {
    expect(lassoCorners([])).toEqual([]);
    expect(
      lassoCorners([
        { x: 0, y: 0 },
        { x: 5, y: 0 },
        { x: 9, y: 0 },
      ]),
    ).toEqual([]);
    expect(lassoCorners(circle(20, 0.1))).toEqual([]);
  });
});
