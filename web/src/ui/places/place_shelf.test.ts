// @vitest-environment jsdom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { fileNameOf, freeName, placeTitle } from '../../model/place_files/kept_place';
import type { SceneryModel } from '../../model/place_files/scenery';
import { hasAutosave, kAutosaveAfter, PlaceAutosave } from './place_autosave';
import { MemoryDrawers } from './place_drawers';
import { PlaceShelf } from './place_shelf';

const place = (name: string, more = {}): string =>
  JSON.stringify({
    format: 'muster-scenario',
    version: 1,
    name,
    box: [
      [0, 0],
      [8, 6],
    ],
    groups: [{ count: 9 }],
    ...more,
  });
const storage = (): Storage => window.localStorage;
let now = 1000;
let shelf: PlaceShelf;

beforeEach(() => {
  window.localStorage.clear();
  now = 1000;
  shelf = new PlaceShelf(new MemoryDrawers(), storage, () => now);
});

const names = async (): Promise<string[]> => (await shelf.list()).map(placeTitle);

describe('the shelf of places', () => {
  it('keeps files by name, the newest first, with the name in them', async () => {
    await shelf.save('A', place('X'), null);
    now += 60;
    const kept = await shelf.save('B', place('X'), null);
    expect(await names()).toEqual(['B', 'A']);
    expect(kept.facts).toBe('8 × 6 m · 9 people');
    expect(JSON.parse(await shelf.read(kept.id))).toMatchObject({ name: 'B' });
    now += 60;
    await shelf.save('A', place('A', { seed: 7 }), null);
    expect(await names()).toEqual(['A', 'B']);
    expect(await shelf.read((await shelf.list())[0]!.id)).toBe(place('A', { seed: 7 }));
  });

  it('renames, removes and brings back', async () => {
    const kept = await shelf.save('A', place('A'), null);
    await shelf.rename(kept.id, 'Z');
    expect(await names()).toEqual(['Z']);
    const back = await shelf.remove(kept.id);
    expect(await names()).toEqual([]);
    await expect(shelf.read(kept.id)).rejects.toThrow('The browser has lost this place.');
    await back();
    expect(JSON.parse(await shelf.read(kept.id))).toMatchObject({ name: 'Z' });
  });

  it('keeps one copy of each place that is edited, and five in all', async () => {
    for (let i = 0; i < 8; ++i) {
      now += 60;
      await shelf.autosave(`P${i % 7}`, place(`P${i % 7}`), null);
    }
    const found = (await shelf.list()).map(({ name }) => name);
    expect(found).toEqual(['P0', 'P6', 'P5', 'P4', 'P3']);
    expect((await names())[0]).toMatch(/^Autosaved – P0, \d\d:\d\d$/);
  });

  it('has the models of a place by its name', async () => {
    const model: SceneryModel = {
      name: 'x.obj',
      positions: new Float32Array(9),
      colours: new Uint8Array(3),
      obstacles: [],
    };
    expect(await shelf.scenery('A')).toEqual([]);
    await shelf.keepScenery('A', [model]);
    expect(await shelf.scenery('A')).toEqual([model]);
    await shelf.keepScenery('A', []);
    expect(await shelf.scenery('A')).toEqual([]);
    expect(window.localStorage.getItem('muster.scenery')).toBe('[]');
  });

  it('finds names that are free, and names of files', () => {
    expect(freeName('Town', ['Town', 'Town 2'])).toBe('Town 3');
    expect(freeName('Town', [])).toBe('Town');
    expect(fileNameOf('Alter Markt (Süd)')).toBe('alter-markt-süd.json');
    expect(fileNameOf('???')).toBe('place.json');
  });
});

describe('what is kept while somebody edits', () => {
  let server = place('Yard');
  let autosave: PlaceAutosave;
  const read = vi.fn(async () => server);

  beforeEach(() => {
    vi.useFakeTimers();
    read.mockClear();
    server = place('Yard');
    autosave = new PlaceAutosave({ link: { read }, shelf, picture: async () => null, storage });
  });

  const rest = async (ms: number): Promise<void> => {
    await vi.advanceTimersByTimeAsync(ms);
  };

  it('is what the server has two seconds after the last change', async () => {
    autosave.setEdited(true, 'Yard', true);
    await rest(kAutosaveAfter - 100);
    autosave.changed();
    await rest(kAutosaveAfter - 100);
    expect(read).not.toHaveBeenCalled();
    await rest(200);
    expect(await names()).toHaveLength(1);
    expect(hasAutosave(storage)).toBe(true);
    autosave.setEdited(false, '', false);
    autosave.changed();
    await rest(9000);
    expect(read).toHaveBeenCalledTimes(1);
  });

  it('is kept at once before another place is opened, and not at all where the server is away', async () => {
    autosave.setEdited(true, 'Yard', true);
    await autosave.flush();
    expect(await names()).toHaveLength(1);
    await autosave.flush();
    expect(read).toHaveBeenCalledTimes(1);
    read.mockRejectedValueOnce(new Error('away'));
    autosave.changed();
    await rest(9000);
    expect(autosave.waiting).toBe(false);
  });

  it('is offered where the server has another place, until it was seen', async () => {
    autosave.setEdited(true, 'Yard', true);
    await rest(kAutosaveAfter);
    expect(await autosave.lost('')).toBeNull();
    server = place('Yard', { seed: 2 });
    const found = await autosave.lost('');
    expect(found?.name).toBe('Yard');
    autosave.markSeen(found!);
    expect(await autosave.lost('')).toBeNull();
  });

  it('is not offered where the page was left in the middle of an edit: the server has more', async () => {
    autosave.setEdited(true, 'Yard', true);
    await rest(kAutosaveAfter);
    autosave.changed();
    window.dispatchEvent(new Event('pagehide'));
    server = place('Yard', { seed: 2 });
    expect(await autosave.lost('')).toBeNull();
  });
});
