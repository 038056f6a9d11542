import { expect, it } from 'vitest';
import { tagLeft } from './tag_layer';

const patch = (x: number) => ({ kind: 'patch', at: { x, y: 0 } }) as const;

it('centres a tag above what it names', () => {
  expect(tagLeft(patch(300), 60, 1000)).toBe(240);
  expect(tagLeft(patch(300.4), 60, Infinity)).toBe(240);
});

it('moves the name of a patch out from below the panels', () => {
  expect(tagLeft(patch(950), 60, 1000)).toBe(1000 - 8 - 120);
  // It stays above its patch.
  expect(tagLeft(patch(999), 60, 1000)).toBe(999 - 120);
});

it('leaves what lies below the panels there', () => {
  expect(tagLeft(patch(1040), 60, 1000)).toBe(980);
});

it('leaves other tags where they are', () => {
  expect(tagLeft({ kind: 'chip', at: { x: 990, y: 0 } }, 60, 1000)).toBe(930);
});
