import { expect, it } from 'vitest';
import { ServerExport } from './take_exports';
import type { ExportProgress } from '../../link/shelf_link';

const wish = { take: 'a.take', format: 'glb', from: 0, to: 1, fps: 30, speeds: true };

function shelf(reports: readonly ExportProgress[]) {
  const asked: string[] = [];
  let next = 0;
  return {
    asked,
    beginExport: async () => '7',
    exportProgress: async () => reports[Math.min(next++, reports.length - 1)]!,
    cancelExport: async (number: string) => void asked.push(`cancel ${number}`),
  };
}

const report = (state: ExportProgress['state'], share: number): ExportProgress => ({
  state,
  share,
  file: 'a.glb',
  bytes: 5,
});

it('follows an export to its end and saves the file', async () => {
  const saved: string[] = [];
  const shares: number[] = [];
  const run = new ServerExport(
    shelf([report('waiting', 0), report('running', 0.5), report('done', 1)]),
    async () => undefined,
    (address, name) => saved.push(`${address} ${name}`),
  );
  expect((await run.run(wish, (share) => shares.push(share)))?.file).toBe('a.glb');
  expect(shares).toEqual([0, 0.5, 1]);
  expect(saved).toEqual(['exports/7/file a.glb']);
});

it('cancels on the server', async () => {
  const link = shelf([report('running', 0.1)]);
  const run: ServerExport = new ServerExport(link, async () => run.cancel());
  expect(await run.run(wish, () => undefined)).toBeNull();
  expect(link.asked).toEqual(['cancel 7']);
});

it('tells why it failed', async () => {
  const failed = { ...report('failed', 0), problem: 'the disk is full' };
  const run = new ServerExport(shelf([failed]), async () => undefined);
  await expect(run.run(wish, () => undefined)).rejects.toThrow('could not be exported: the disk is full.');
});
