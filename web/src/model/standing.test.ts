import { expect, it } from 'vitest';
import { Standing } from '../protocol/messages';
import { standingSum } from './standing';

function counts(more: Partial<Record<keyof typeof Standing, number>>): number[] {
  const list = new Array<number>(Object.keys(Standing).length).fill(0);
  for (const [name, number] of Object.entries(more)) list[Standing[name as keyof typeof Standing]] = number;
  return list;
}

it('adds groups up, and names what bars people', () => {
  const sum = standingSum([counts({ InPlace: 30, Outside: 12 }), counts({ InPlace: 5, OnTheWay: 1, Stuck: 1 })]);
  expect(sum).toEqual({ all: 49, there: 35, walk: 1, held: 0, barred: '12 places outside the ground · 1 stuck' });
  expect(standingSum([counts({ InPlace: 3, Outside: 1, Obstacle: 2 })]).barred).toBe(
    '1 place outside the ground · 2 places in obstacles',
  );
  expect(standingSum([])).toEqual({ all: 0, there: 0, walk: 0, held: 0, barred: '' });
});
