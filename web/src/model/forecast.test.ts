import { describe, expect, it } from 'vitest';
import { formatSpan, queueAsks, secondsUntil, standAfter, type Asker, type Forecast } from './forecast';
import { madeOrder } from './test_frames';

function forecast(order: number, more: Partial<Forecast> = {}): [number, Forecast] {
  return [order, { group: 1, order, arrives: true, seconds: 10, end: { x: 0, y: 0 }, way: [], ...more }];
}

const group: Asker = {
  id: 1,
  x: 0,
  y: 0,
  facing: 0.25,
  patrols: false,
  orders: [
    madeOrder(7, { target: [10, 0] }),
    madeOrder(8, { target: [10, 5], facing: 1 }),
    madeOrder(9, { kind: 'face', facing: 2 }),
  ],
};

describe('standAfter', () => {
  it('is where and how the order before ends', () => {
    expect(standAfter(group, 0, new Map())).toEqual({ x: 0, y: 0, facing: 0.25 });
    expect(standAfter(group, 1, new Map())).toEqual({ x: 10, y: 0, facing: 0 });
    expect(standAfter(group, 2, new Map())).toEqual({ x: 10, y: 5, facing: 1 });
    expect(standAfter(group, 3, new Map())).toEqual({ x: 10, y: 5, facing: 2 });
  });

  it('follows the way that is known, and passes over what cannot be reached', () => {
    const way = [
      { x: 0, y: 0 },
      { x: 10, y: -3 },
      { x: 10, y: 0 },
    ];
    expect(standAfter(group, 1, new Map([forecast(7, { way })])).facing).toBeCloseTo(Math.PI / 2);
    expect(standAfter(group, 1, new Map([forecast(7, { arrives: false })]))).toEqual({ x: 0, y: 0, facing: 0.25 });
  });
});

it('times add up, and are not known before all are', () => {
  expect(secondsUntil(group, 2, new Map([forecast(7)]))).toBeNull();
  const known = new Map([forecast(7), forecast(8, { arrives: false, seconds: Infinity }), forecast(9, { seconds: 2 })]);
  expect(secondsUntil(group, 3, known)).toBe(12);
  const follows: Asker = { ...group, orders: [madeOrder(7, { kind: 'follow' })] };
  expect(secondsUntil(follows, 1, known)).toBe(Infinity);
});

it('asks about each order from where the one before ends, but not about followers', () => {
  const orders = [...group.orders, madeOrder(10, { kind: 'follow' })];
  const asks = queueAsks({ ...group, orders }, new Map());
  expect(asks.map(({ order, placed, x, y }) => [order, placed, x, y])).toEqual([
    [7, false, 0, 0],
    [8, true, 10, 0],
    [9, true, 10, 5],
  ]);
});

it('spells times as clocks do', () => {
  expect([0, 9.6, 61, 725, -3, Infinity].map(formatSpan)).toEqual(['0:00', '0:10', '1:01', '12:05', '0:00', '–']);
});
