import { describe, expect, it } from 'vitest';
import { crossesItself, gripAt, hasCorners, middlesOf, withCorner, withoutCorner } from './corners';
import { thing } from './things';

const square = thing('obstacle', {
  id: 7,
  polygon: [
    [0, 0],
    [4, 0],
    [4, 4],
    [0, 4],
  ],
  centre: [2, 2],
});
const toScreen = ({ x, y }: { x: number; y: number }) => ({ x: 10 * x, y: -10 * y });

describe('corners of what is built', () => {
  it('are taken before the middles of edges, and only from near', () => {
    expect(gripAt(square, { x: 41, y: 2 }, toScreen, 10)).toEqual({ index: 1, isNew: false });
    expect(gripAt(square, { x: 21, y: 2 }, toScreen, 10)).toEqual({ index: 0, isNew: true });
    expect(gripAt(square, { x: 2, y: -21 }, toScreen, 10)).toEqual({ index: 3, isNew: true });
    // Nearer to the middle than to any corner, though corners are in reach.
    expect(gripAt(square, { x: 20, y: 1 }, toScreen, 30)).toEqual({ index: 0, isNew: true });
    // Inside a small outline there is room to take the whole.
    expect(gripAt(square, { x: 14, y: -14 }, toScreen, 30)).toBeNull();
    expect(gripAt(square, { x: -14, y: 14 }, toScreen, 30)).toEqual({ index: 0, isNew: false });
    expect(gripAt(square, { x: 20, y: -20 }, toScreen, 10)).toBeNull();
    expect(gripAt(thing('item', { radius: 1 }), { x: 0, y: 0 }, toScreen, 10)).toBeNull();
  });

  it('move, and the middle with them', () => {
    const changed = withCorner(square, { index: 2, isNew: false }, { x: 8, y: 4 });
    expect(changed.polygon).toEqual([
      [0, 0],
      [4, 0],
      [8, 4],
      [0, 4],
    ]);
    expect(changed.centre).toEqual([3, 2]);
    expect(changed.id).toBe(7);
    expect(square.polygon![2]).toEqual([4, 4]);
  });

  it('come from the middles of edges, also of the last one', () => {
    expect(middlesOf(square)[3]).toEqual({ x: 0, y: 2 });
    const changed = withCorner(square, { index: 3, isNew: true }, { x: -1, y: 2 });
    expect(changed.polygon!.at(-1)).toEqual([-1, 2]);
    expect(changed.polygon).toHaveLength(5);
  });

  it('go, but for three', () => {
    const triangle = withoutCorner(square, 0)!;
    expect(triangle.polygon).toEqual([
      [4, 0],
      [4, 4],
      [0, 4],
    ]);
    expect(withoutCorner(triangle, 0)).toBeNull();
  });

  it('may not make edges cross', () => {
    expect(crossesItself(square)).toBe(false);
    expect(crossesItself(withCorner(square, { index: 0, isNew: false }, { x: 6, y: 2 }))).toBe(true);
    expect(crossesItself(withCorner(square, { index: 0, isNew: false }, { x: 3, y: 3 }))).toBe(false);
    // On an edge.
    expect(crossesItself(withCorner(square, { index: 0, isNew: false }, { x: 4, y: 2 }))).toBe(true);
  });

  it('are those of one thing with few corners', () => {
    expect(hasCorners([square])).toBe(true);
    expect(hasCorners([square, square])).toBe(false);
    expect(hasCorners([])).toBe(false);
    const many = Array.from({ length: 200 }, (_, k) => [Math.cos(k), Math.sin(k)] as const);
    expect(hasCorners([thing('obstacle', { polygon: many })])).toBe(false);
  });
});
