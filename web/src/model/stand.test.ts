import { expect, it } from 'vitest';
import type { PlacesFrame } from '../protocol/messages';
import { standOf, unfitWords } from './stand';

it('counts places that cannot be reached, in all groups together', () => {
  const of = (...unfit: number[]): Uint8Array => Uint8Array.from(unfit);
  expect(unfitWords([])).toEqual({ text: '', warns: false });
  expect(unfitWords([of(0)])).toEqual({ text: 'The spot can be reached', warns: false });
  expect(unfitWords([of(0, 0), of(0)])).toEqual({ text: 'All 3 spots can be reached', warns: false });
  expect(unfitWords([of(0, 5), of(7, 0, 0)])).toEqual({ text: '2 of 5 spots cannot be reached', warns: true });
  expect(unfitWords([of(0, 4), of(4, 0)])).toEqual({ text: '2 of 4 spots lie outside the ground', warns: true });
});

it('has the front ahead of the places, from left to right', () => {
  // Two abreast, facing +y, about (5, 5).
  const answer: PlacesFrame = {
    group: 1,
    places: Float32Array.of(4, 5, 6, 5),
    unfit: Uint8Array.of(0, 1),
    problem: '',
  };
  const { places, front, unfit } = standOf(answer, 3, { x: 5, y: 5, facing: Math.PI / 2 });
  expect(places).toEqual([
    { x: 4, y: 5 },
    { x: 6, y: 5 },
  ]);
  expect(unfit[1]).toBe(1);
  const near = front.map(({ x, y }) => [Math.round(10 * x) / 10, Math.round(10 * y) / 10]);
  expect(near).toEqual([
    [3.5, 5.5],
    [6.5, 5.5],
  ]);
});
