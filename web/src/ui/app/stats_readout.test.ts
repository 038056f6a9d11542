// @vitest-environment jsdom
import { expect, it } from 'vitest';
import type { FromWorker, ToWorker } from '../../link/link_messages';
import { StudioClient, type WorkerPort } from '../../link/studio_client';
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
  const line = readout.root.querySelector('output')!;
  expect(line.textContent).toBe('12 draws · 34,567 triangles · 2.0 ms, 95 % below 2.0 ms');
  readout.show({ ...stats, pictureMs: 9, pictures: 21 });
  expect(line.textContent).toContain('95 % below 8.0 ms');
});

it('asks each server that greets it for the times of stages, and shows them', () => {
  const readout = new StatsReadout();
  const worker: WorkerPort & { readonly posted: ToWorker[] } = {
    onmessage: null,
    posted: [],
    postMessage(message) {
      this.posted.push(message);
    },
  };
  const client = new StudioClient(worker, 0);
  readout.follow(client);
  const say = (message: Extract<FromWorker, { kind: 'message' }>['message']): void =>
    worker.onmessage!({ data: { kind: 'message', message } } as MessageEvent<FromWorker>);
  const ask: ToWorker = { kind: 'send', message: { type: 'WatchStages', on: true } };
  expect(worker.posted).toEqual([]);
  for (const number of [3, 4]) say({ type: 'Welcome', client: number, version: '1', scenarios: [], schemes: [] });
  expect(worker.posted).toEqual([ask, ask]);
  say({ type: 'StageTimes', step: 60, total: 0.5, stages: [{ name: 'orders', about: '', milliseconds: 0.25 }] });
  expect(readout.root.textContent).toContain('Times of a step: 0.50 ms');
  expect(readout.root.textContent).toContain('orders0.250 ms');
});

it('takes shares of lists', () => {
  expect([
    percentile([], 0.5),
    percentile([3], 0.95),
    percentile([4, 1, 3, 2], 0.5),
    percentile([4, 1, 3, 2], 0.95),
  ]).toEqual([0, 3, 2, 4]);
});
