import { describe, expect, it } from 'vitest';
import { MarkExtent, type MarkBounds } from './mark_extent';

function frameOf(points: readonly (readonly [number, number])[], kept: MarkBounds | null = null): MarkBounds | null {
  const extent = new MarkExtent();
  for (const [x, y] of points) extent.add({ x, y });
  return extent.bounds(1280, 800, kept);
}

describe('MarkExtent', () => {
  it('needs nothing without points', () => {
    expect(frameOf([])).toBeNull();
    expect(frameOf([[Number.NaN, 3]])).toBeNull();
  });
  it('holds every point with room for a ring, and little else', () => {
    const frame = frameOf([
      [300, 200],
      [420, 260],
    ])!;
    expect(frame.x).toBeLessThanOrEqual(300 - 30);
    expect(frame.y).toBeLessThanOrEqual(200 - 30);
    expect(frame.x + frame.width).toBeGreaterThanOrEqual(420 + 30);
    expect(frame.y + frame.height).toBeGreaterThanOrEqual(260 + 30);
    expect(frame.width * frame.height).toBeLessThan(0.2 * 1280 * 800);
  });
  it('stays on the screen, and is gone with what lies beyond it', () => {
    expect(
      frameOf([
        [-500, -500],
        [5000, 5000],
      ]),
    ).toEqual({ x: 0, y: 0, width: 1280, height: 800 });
    expect(frameOf([[-300, 100]])).toBeNull();
  });
  it('is kept while it serves, and given up when it is far too large', () => {
    const wide = frameOf([
      [100, 100],
      [500, 400],
    ])!;
    expect(
      frameOf(
        [
          [120, 130],
          [470, 380],
        ],
        wide,
      ),
    ).toBe(wide);
    expect(
      frameOf(
        [
          [120, 130],
          [140, 150],
        ],
        wide,
      ),
    ).not.toBe(wide);
    expect(
      frameOf(
        [
          [120, 130],
          [900, 380],
        ],
        wide,
      )!.width,
    ).toBeGreaterThan(wide.width);
  });
  it('is not kept where the screen has shrunk', () => {
    const kept = { x: 0, y: 0, width: 1280, height: 800 };
    const extent = new MarkExtent();
    extent.add({ x: 10, y: 10 });
    extent.add({ x: 900, y: 500 });
    expect(extent.bounds(1024, 600, kept)).toEqual({ x: 0, y: 0, width: 960, height: 576 });
  });
});
