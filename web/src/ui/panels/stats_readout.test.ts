// @vitest-environment jsdom
import { expect, it } from 'vitest';
import { percentile, StatsReadout, wantsStats } from './stats_readout';

it('is asked for by the address', () => {
  expect([wantsStats('?stats'), wantsStats('?quality=full&stats=1'), wantsStats('?quality=full')]).toEqual([
    true,
    true,
    false,
  ]);
});

it('tells draws, triangles and the time of pictures, each picture once', () => {
  const readout = new StatsReadout();
  const stats = {
    drawCalls: 12,
    triangles: 34567,
    pictureMs: 2,
    framesTakenMs: 0,
    framesTaken: 0,
    pictures: 1,
    shownFrame: 0,
  };
  readout.show(stats);
  readout.show({ ...stats, pictureMs: 99 });
  for (let i = 2; i <= 20; ++i) readout.show({ ...stats, pictureMs: i === 20 ? 8 : 2, pictures: i });
  expect(readout.root.textContent).toBe('12 draws · 34,567 triangles · 2.0 ms, 95 % below 2.0 ms');
  readout.show({ ...stats, pictureMs: 9, pictures: 21 });
  expect(readout.root.textContent).toContain('95 % below 8.0 ms');
});

it('takes shares of lists', () => {
  expect([
    percentile([], 0.5),
    percentile([3], 0.95),
    percentile([4, 1, 3, 2], 0.5),
    percentile([4, 1, 3, 2], 0.95),
  ]).toEqual([0, 3, 2, 4]);
});
