import { expect, it } from 'vitest';
import { PendingChanges } from './pending';
import { moved, thing, type Thing } from './things';

const box: Thing = thing('obstacle', {
  id: 3,
  name: 'Box',
  polygon: [
    [0, 0],
    [2, 0],
    [2, 2],
  ],
});
const disc = thing('obstacle', { id: 4, centre: [5, 5], radius: 1 });

it('keeps a thing as it was left until the server shows it so', () => {
  const pending = new PendingChanges();
  const [first, second] = [moved(box, 1, 0), moved(box, 2, 0)];
  pending.put([first], 0);
  pending.put([second], 100);
  expect(pending.over([box, disc], 110)).toEqual([second, disc]);
  expect(pending.over([first, disc], 120)).toEqual([second, disc]);
  const shown = moved(second, 1e-9, 0);
  expect(pending.over([shown, disc], 130)).toEqual([shown, disc]);
  expect(pending.over([box, disc], 140)).toEqual([box, disc]);
});

it('takes what the server shows where it does not follow, and where the thing is gone', () => {
  const pending = new PendingChanges();
  pending.put([moved(box, 1, 0)], 0);
  expect(pending.over([box], 1400)).not.toEqual([box]);
  expect(pending.over([box], 1600)).toEqual([box]);
  pending.put([moved(box, 1, 0)], 2000);
  expect(pending.over([disc], 2001)).toEqual([disc]);
  expect(pending.over([box], 2002)).toEqual([box]);
});

it('keeps several at once, and forgets all of them when told', () => {
  const pending = new PendingChanges();
  pending.put([moved(box, 1, 0), moved(disc, 1, 0)], 0);
  pending.put([moved(disc, 2, 0)], 10);
  expect(pending.over([box, disc], 20).map(({ centre }) => centre[0])).toEqual([1, 7]);
  pending.clear();
  expect(pending.over([box, disc], 30)).toEqual([box, disc]);
});
