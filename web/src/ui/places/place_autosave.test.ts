// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { KeptPlace } from '../../model/place_files/kept_place';
import { kAutosaveAfter, PlaceAutosave } from './place_autosave';

const kept: string[] = [];
let autosave: PlaceAutosave;

beforeEach(() => {
  vi.useFakeTimers();
  kept.length = 0;
  autosave = new PlaceAutosave({
    link: { read: () => Promise.resolve('{"name":"Yard"}') },
    shelf: {
      autosave: (name) => {
        kept.push(name);
        return Promise.resolve({} as KeptPlace);
      },
      list: () => Promise.resolve([]),
      read: () => Promise.resolve(''),
    },
    picture: () => Promise.resolve(null),
  });
});

afterEach(() => vi.useRealTimers());

it('keeps a copy some time after the last change', async () => {
  autosave.setEdited(true, 'Yard', true);
  await vi.advanceTimersByTimeAsync(kAutosaveAfter - 1);
  expect(kept).toEqual([]);
  await vi.advanceTimersByTimeAsync(1);
  expect(kept).toEqual(['Yard']);
});

it('waits while a pointer is down', async () => {
  autosave.setEdited(true, 'Yard', true);
  window.dispatchEvent(new Event('pointerdown'));
  await vi.advanceTimersByTimeAsync(3 * kAutosaveAfter);
  expect(kept).toEqual([]);
  window.dispatchEvent(new Event('pointerup'));
  await vi.advanceTimersByTimeAsync(kAutosaveAfter);
  expect(kept).toEqual(['Yard']);
});
