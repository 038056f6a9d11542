import { expect, it } from 'vitest';
import { TakeBlockKind, type TakeBlock } from '../protocol/messages';
import {
  edited,
  fitted,
  foundAgain,
  linesOf,
  panned,
  rowsOf,
  snapped,
  stepAt,
  ticksOf,
  xOf,
  zoomed,
} from './take_tracks';

const kDt = 1 / 60;
const whole = { from: 0, to: 1200 };

function block(id: number, group: number, begin: number, end: number, label = 'Move'): TakeBlock {
  const kind = TakeBlockKind.Order;
  return { id, group, kind, begin, begun: begin, end, label, moves: true, stretches: true };
}

it('keeps a step in place while it zooms, within the take and not nearer than two seconds', () => {
  const near = zoomed(whole, 1200, kDt, 2, 300);
  expect(near).toEqual({ from: 150, to: 750 });
  expect(xOf(near, 600, 300)).toBe(xOf(whole, 600, 300));
  expect(stepAt(near, 600, xOf(near, 600, 412))).toBeCloseTo(412);
  expect(zoomed(whole, 1200, kDt, 1000, 0)).toEqual({ from: 0, to: 120 });
  expect(zoomed(near, 1200, kDt, 0.01, 300)).toEqual(whole);
  expect(panned(near, 1200, 1e9)).toEqual({ from: 600, to: 1200 });
});

it('goes on to show all of a take that has become longer', () => {
  expect(fitted(whole, 1200, 1500)).toEqual({ from: 0, to: 1500 });
  expect(fitted({ from: 100, to: 400 }, 1200, 300)).toEqual({ from: 0, to: 300 });
});

it('has lines of the ruler at even times, not too near to each other', () => {
  const { steps, every } = ticksOf(whole, 600, { from: 0, stepTime: kDt });
  expect(every).toBe(5);
  expect(steps).toEqual([0, 300, 600, 900, 1200]);
  expect(ticksOf({ from: 0, to: 120 }, 600, { from: 0, stepTime: kDt }).every).toBe(0.5);
});

it('snaps to the playhead and to seconds, whichever is nearer', () => {
  expect(snapped(118, 500, kDt, 6)).toBe(120);
  expect(snapped(118, 116.6, kDt, 6)).toBe(117);
  expect(snapped(90.4, 500, kDt, 6)).toBe(90);
});

it('has a row for each group, and one for what concerns nobody', () => {
  const tracks = [
    { group: 1, name: 'North', from: 0, to: 1200 },
    { group: 2, name: '', from: 0, to: 1200 },
  ];
  const rows = rowsOf({ tracks, blocks: [block(0, 1, 0, 10), block(1, 0, 5, 5), block(2, 1, 20, 30)] }, 1200);
  expect(rows.map(({ track, blocks }) => [track.group, blocks.map(({ id }) => id)])).toEqual([
    [1, [0, 2]],
    [2, []],
    [0, [1]],
  ]);
});

it('puts blocks that overlap on lines of their own', () => {
  expect(linesOf([block(0, 1, 0, 100), block(1, 1, 50, 60), block(2, 1, 100, 120)], 10)).toEqual([0, 1, 0]);
  // A short one takes the room that a finger needs.
  expect(linesOf([block(0, 1, 0, 0), block(1, 1, 5, 5)], 10)).toEqual([0, 1]);
});

it('shows what an edit would make', () => {
  const one = block(3, 1, 60, 120);
  expect(edited(one, { edit: 'move', id: 3, step: 90 })).toEqual({ begin: 90, end: 150 });
  expect(edited(one, { edit: 'stretch', id: 3, step: 300 })).toEqual({ begin: 60, end: 300 });
  expect(edited(one, { edit: 'move', id: 4, step: 90 })).toEqual({ begin: 60, end: 120 });
});

it('finds a block again in the changed take', () => {
  const blocks = [block(0, 1, 0, 10), block(1, 1, 300, 310), block(2, 2, 299, 310), block(3, 1, 299, 310, 'Turn')];
  expect(foundAgain(blocks, { group: 1, label: 'Move', begin: 290 })?.id).toBe(1);
  expect(foundAgain(blocks, { group: 4, label: 'Move', begin: 290 })).toBeNull();
});

it('counts the ruler from the beginning of the part', () => {
  const { steps, every } = ticksOf({ from: 690, to: 1290 }, 600, { from: 730, stepTime: kDt });
  expect(every).toBe(2);
  expect(steps.slice(0, 2)).toEqual([730, 850]);
});
