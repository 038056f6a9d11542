import { expect, it } from 'vitest';
import type { ShelvedTake } from '../../model/take_facts';
import { TakeCopies, isCopyOnly, withCopies } from './take_copies';

const take = (name: string, changed: number): ShelvedTake => ({
  name,
  title: name,
  scenario: '',
  characters: 1,
  steps: 60,
  stepTime: 1 / 60,
  from: 0,
  to: 60,
  seconds: 1,
  finished: true,
  recording: false,
  picture: true,
  changed,
  bytes: 9,
  speeds: [],
});

it('lists what only the browser has among the others, the newest first', () => {
  const all = withCopies([take('c', 30), take('a', 10)], [take('a', 10), take('b', 20)]);
  expect(all.map(({ name }) => name)).toEqual(['c', 'b', 'a']);
  expect(all.map(isCopyOnly)).toEqual([false, true, false]);
  expect(all[1]!.picture).toBe(false);
});

it('has no copies where the browser keeps none', async () => {
  const copies = new TakeCopies(undefined);
  await copies.keep(take('a', 1), new Blob(['x']));
  expect(await copies.list()).toEqual([]);
  expect(await copies.read('a')).toBeNull();
});
