import { expect, it } from 'vitest';
import { StandingGrid } from './standing_grid';

/** The same numbers in every run. */
function* numbers(seed: number): Generator<number> {
  for (let s = seed; ;) {
    s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
    yield s / 2 ** 32;
  }
}

it('finds whom a look at everybody finds', () => {
  const draw = numbers(7);
  const next = (): number => draw.next().value as number;
  const grid = new StandingGrid();
  for (const [count, wide] of [
    [0, 10],
    [1, 10],
    [400, 60],
    [300, 5000],
  ] as const) {
    const places = Float32Array.from({ length: 3 * count }, () => (next() - 0.5) * wide);
    grid.fill(places, 3, count);
    let found = 0;
    for (let k = 0; k < 500; ++k) {
      const [x, y, reach] = [(next() - 0.5) * 1.3 * wide, (next() - 0.5) * 1.3 * wide, 0.02 * wide * next()];
      let near = false;
      for (let i = 0; i < count; ++i)
        near ||= (places[3 * i]! - x) ** 2 + (places[3 * i + 1]! - y) ** 2 < reach * reach;
      expect(grid.someoneNear(x, y, reach)).toBe(near);
      found += near ? 1 : 0;
    }
    if (count >= 300) expect(found).toBeGreaterThan(10);
  }
});
