import { expect, it } from 'vitest';
import { tagCorner, uncrowded } from './tag_layer';

const patch = (x: number, y = 200) => ({ kind: 'patch', at: { x, y } }) as const;
const kRoom = { left: 150, right: 1000, top: 70 };
const corner = (x: number, y = 200) => tagCorner(patch(x, y), 60, kRoom);

it('centres a tag above what it names', () => {
  expect(corner(300.4)).toEqual({ x: 240, y: 187 });
});

it('moves the name of a patch out from below the panels, as long as it stays above its patch', () => {
  expect(corner(950)).toEqual({ x: 1000 - 8 - 120, y: 187 });
  expect(corner(180)).toEqual({ x: 158, y: 187 });
  expect(corner(300, 60)).toEqual({ x: 240, y: 78 });
});

it('leaves out what lies below the panels', () => {
  expect([corner(1040), corner(60), corner(300, 20)]).toEqual([null, null, null]);
});

it('leaves other tags where they are', () => {
  expect(tagCorner({ kind: 'chip', at: { x: 990, y: 20 } }, 60, kRoom)).toEqual({ x: 930, y: 7 });
});

it('shows no two names over each other: the nearest stays', () => {
  const one = (key: string, x: number, y: number, kind: 'patch' | 'chip' = 'patch') => ({
    tag: { key, kind, text: key, at: { x: x + 50, y } },
    box: { x, y, width: 100 },
  });
  const kept = uncrowded([one('a', 0, 100), one('b', 60, 110), one('c', 180, 100), one('d', 0, 100, 'chip')]);
  expect(kept.map(({ tag }) => tag.key)).toEqual(['b', 'c', 'd']);
});
