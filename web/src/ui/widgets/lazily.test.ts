// @vitest-environment jsdom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { StudioStore } from '../../model/studio_store';
import { loadWhen, once, openLazily } from './lazily';

let store: StudioStore;
/** Lets what has been promised happen. */
const soon = (): Promise<void> => new Promise((done) => setTimeout(done));

beforeEach(() => {
  store = new StudioStore();
});

it('loads once, and once more after a failure', async () => {
  const load = vi.fn(() => Promise.resolve(7));
  load.mockRejectedValueOnce(new Error('no server'));
  const ready = once(load);
  await expect(ready()).rejects.toThrow('no server');
  expect(await Promise.all([ready(), ready()])).toEqual([7, 7]);
  expect(load).toHaveBeenCalledTimes(2);
});

it('tells of a load that fails, and takes back what asked for it', async () => {
  const load = vi.fn(() => Promise.resolve());
  load.mockRejectedValueOnce(new Error('no server'));
  loadWhen(store, ['sequencing'], ({ sequencing }) => sequencing, load, { sequencing: false });
  store.set({ sequencing: true });
  await soon();
  expect(store.state.sequencing).toBe(false);
  expect(store.state.notice?.text).toBe('The server does not answer: try again.');
  store.set({ sequencing: true });
  await soon();
  expect(load).toHaveBeenCalledTimes(2);
  expect(store.state.sequencing).toBe(true);
});

describe('a panel that a switch opens', () => {
  it('is loaded with the first press, and opened and closed from then on', async () => {
    const setOpen = vi.fn();
    const load = vi.fn(() => Promise.resolve({ setOpen }));
    const panel = openLazily(store, 'measures', load);
    expect(panel()).toBeNull();
    store.set({ measures: true });
    await soon();
    expect(document.documentElement.hasAttribute('data-measures')).toBe(true);
    store.set({ measures: false });
    store.set({ measures: true });
    await soon();
    expect(load).toHaveBeenCalledTimes(1);
    expect(setOpen.mock.calls).toEqual([[true], [false], [true]]);
  });

  it('stays closed where it was closed while it came', async () => {
    const setOpen = vi.fn();
    openLazily(store, 'words', () => Promise.resolve({ setOpen }));
    store.set({ words: true });
    store.set({ words: false });
    await soon();
    expect(setOpen.mock.calls).toEqual([[false]]);
  });
});
