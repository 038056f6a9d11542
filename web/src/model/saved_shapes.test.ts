import { beforeEach, describe, expect, it } from 'vitest';
import { removeShape, savedShapes, saveShape } from './saved_shapes';

let kept: Record<string, string> = {};
const storage = () => ({
  getItem: (key: string) => kept[key] ?? null,
  setItem: (key: string, value: string) => {
    kept[key] = value;
  },
});
const full = () => ({
  getItem: () => null,
  setItem: () => {
    throw new Error('no room');
  },
});
const arrow = {
  name: 'Arrow',
  spacing: 1.25,
  places: [
    { x: 0, y: 0 },
    { x: -1, y: 0.5 },
  ],
};

beforeEach(() => {
  kept = {};
});

describe('saved formations', () => {
  it('come back as they were saved, also for another page', () => {
    expect(saveShape(storage, arrow)).toBe(true);
    expect(savedShapes(storage)).toEqual([arrow]);
  });

  it('replace one of the same name, and are removed by name', () => {
    saveShape(storage, arrow);
    saveShape(storage, { ...arrow, name: 'Other' });
    saveShape(storage, { ...arrow, spacing: 2 });
    expect(savedShapes(storage).map(({ name, spacing }) => [name, spacing])).toEqual([
      ['Other', 1.25],
      ['Arrow', 2],
    ]);
    removeShape(storage, 'Other');
    expect(savedShapes(storage).map(({ name }) => name)).toEqual(['Arrow']);
  });

  it('are at most 40: the oldest go', () => {
    for (let i = 0; i < 45; ++i) saveShape(storage, { ...arrow, name: `N${i}` });
    const names = savedShapes(storage).map(({ name }) => name);
    expect(names).toHaveLength(40);
    expect(names[0]).toBe('N5');
  });

  it('survive what is no formation', () => {
    const bad = [
      null,
      5,
      { name: '' },
      { name: 'x', spacing: -1, places: [[0, 0]] },
      { name: 'x', spacing: 1, places: [[0]] },
    ];
    kept['muster.formations'] = JSON.stringify([...bad, { name: 'Good', spacing: 1, places: [[1, 2]] }]);
    expect(savedShapes(storage).map(({ name }) => name)).toEqual(['Good']);
    kept['muster.formations'] = '{';
    expect(savedShapes(storage)).toEqual([]);
  });

  it('are refused where there is no room', () => {
    expect(saveShape(full, arrow)).toBe(false);
    expect(
      savedShapes(() => {
        throw new Error('forbidden');
      }),
    ).toEqual([]);
  });
});
