import { expect, it } from 'vitest';
import { EventKind } from '../protocol/messages';
import { ArrivalWatch } from './arrival_watch';

const arrived = { kind: EventKind.Arrived, subject: 7, value: 9, x: 0, y: 0 };

function frame(time: number, standings: number[], events = [] as (typeof arrived)[]) {
  return { time, events, groups: [{ id: 7, standings, x: 1, y: 2 }] };
}

it('tells of a group that is in place as a whole, and how long it was on the way', () => {
  const watch = new ArrivalWatch();
  expect(watch.observe(frame(1, [9, 0, 0]))).toEqual([]);
  expect(watch.observe(frame(2, [0, 9, 0]))).toEqual([]);
  expect(watch.observe(frame(9, [5, 4, 0]))).toEqual([]);
  expect(watch.observe(frame(14, [9, 0, 0], [arrived]))).toEqual([{ id: 7, index: 0, seconds: 12, x: 1, y: 2 }]);
});

it('says nothing of an arrival of only some', () => {
  const watch = new ArrivalWatch();
  watch.observe(frame(2, [0, 9, 0]));
  expect(watch.observe(frame(14, [7, 0, 0, 0, 2], [arrived]))).toEqual([]);
});
