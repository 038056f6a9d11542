import { describe, expect, it } from 'vitest';
import type { FormationDef, Vec2 } from '../protocol/generated/commands';
import type { FormationKindWord } from '../protocol/generated/words';
import { filled } from '../protocol/encoding';
import { dotsOf, dotsOfFormation } from './formation_dots';
import type { GroundPoint } from './plane';
import { targetOf, type QueueOrder } from './queue_order';
import {
  alongWay,
  arranged,
  kJointShare,
  plainLegs,
  stationsOf,
  withStations,
  type Station,
  type WayLeg,
} from './sequence';
import { madeOrder } from './test_frames';

const station = (at: number, kind: FormationKindWord): Station => ({
  at,
  formation: filled<FormationDef>('FormationDef', { kind, spacing: 1 }),
});

/** The legs of a queue from the origin, straight from target to target, by the routes that are drawn. */
function legsOf(orders: readonly QueueOrder[]): WayLeg[] {
  let from: GroundPoint = { x: 0, y: 0 };
  return orders.map((order) => {
    const between = order.route.map(([x, y]) => ({ x, y }));
    const points = [from, ...between, targetOf(order)];
    from = targetOf(order);
    return { order, points };
  });
}

const short = (orders: readonly QueueOrder[]): string[] =>
  orders.map((order) => `${order.target.join()} ${order.formation?.kind ?? '-'}`);

describe('withStations', () => {
  it('makes joints along the way, and reads them again', () => {
    const legs = legsOf([madeOrder(7, { target: [20, 0], facing: 1 })]);
    const orders = withStations(legs, [station(5, 'line'), station(12, 'wedge')]);
    expect(short(orders)).toEqual(['5,0 -', '12,0 line', '20,0 wedge']);
    expect(orders.map(({ share }) => share)).toEqual([kJointShare, kJointShare, 0.95]);
    expect(orders.map(({ facing }) => facing)).toEqual([null, null, 1]);
    const again = legsOf(orders);
    expect(stationsOf(again)).toEqual([station(5, 'line'), station(12, 'wedge')]);
    expect(plainLegs(again).map(({ order }) => order.target)).toEqual([[20, 0]]);
  });

  it('goes back to the plain queue when all are removed', () => {
    const legs = legsOf([madeOrder(7, { target: [20, 0] }), madeOrder(8, { target: [20, 10] })]);
    const orders = withStations(legs, [
      station(0, 'ring'),
      station(9, 'line'),
      station(25, 'wedge'),
      station(30, 'ring'),
    ]);
    expect(short(orders)).toEqual(['9,0 ring', '20,0 line', '20,5 -', '20,10 wedge', '20,10 ring']);
    expect(stationsOf(legsOf(orders)).map(({ at }) => at)).toEqual([0, 9, 25, 30]);
    expect(short(withStations(legsOf(orders), []))).toEqual(['20,0 -', '20,10 -']);
  });

  it('takes a formation up where one order ends and the next begins, without a joint', () => {
    const legs = legsOf([madeOrder(7, { target: [20, 0] }), madeOrder(8, { target: [20, 10] })]);
    const orders = withStations(legs, [station(20, 'wedge')]);
    expect(short(orders)).toEqual(['20,0 -', '20,10 wedge']);
    // The first order is the same: the group does not begin it anew.
    expect(orders[0]).toBe(legs[0]!.order);
  });

  it('leaves a queue alone that has these formations already', () => {
    const legs = legsOf([madeOrder(7, { target: [20, 0] })]);
    expect(withStations(legs, [])).toEqual([legs[0]!.order]);
  });

  it('divides a drawn way at its joints', () => {
    const route = [
      [10, 0],
      [10, 10],
    ] as const;
    const legs = legsOf([madeOrder(7, { target: [20, 10], route })]);
    const orders = withStations(legs, [station(15, 'line')]);
    expect(orders.map((one) => one.route)).toEqual([[[10, 0]], [[10, 10]]]);
    expect(short(orders)).toEqual(['10,5 -', '20,10 line']);
    const back = withStations(legsOf(orders), []);
    expect(back.map((one) => one.route)).toEqual([
      [
        [10, 0],
        [10, 5],
        [10, 10],
      ],
    ]);
  });

  it('drops the width of a front for a shape without ranks', () => {
    const legs = legsOf([madeOrder(7, { target: [20, 0], width: 8 })]);
    const width = (kind: FormationKindWord): number => withStations(legs, [station(0, kind)])[0]!.width;
    expect([width('square'), width('ring')]).toEqual([8, 0]);
  });
});

describe('arranged', () => {
  it('keeps stations in order, apart, and on the way', () => {
    const places = arranged(
      [station(30, 'line'), station(-4, 'ring'), station(9.9, 'wedge'), station(10, 'column')],
      10,
    );
    expect(places.map(({ at, formation }) => `${at} ${formation.kind}`)).toEqual([
      '0 ring',
      '9 wedge',
      '9.5 column',
      '10 line',
    ]);
  });
});

it('finds points along a way', () => {
  const way = [
    { x: 0, y: 0 },
    { x: 4, y: 0 },
    { x: 4, y: 6 },
  ];
  expect(alongWay(way, 2)).toEqual({ x: 2, y: 0, facing: 0 });
  expect(alongWay(way, 7)).toEqual({ x: 4, y: 3, facing: Math.PI / 2 });
  expect(alongWay(way, 99)).toEqual({ x: 4, y: 6, facing: Math.PI / 2 });
});

it('draws shapes of one\u2019s own as dots, ahead up', () => {
  expect(dotsOfFormation({ kind: 'wedge', spacing: 1 })).toBe(dotsOf('wedge'));
  const points = [
    [2, 0],
    [-2, 2],
  ] as const;
  expect(dotsOfFormation({ kind: 'points', spacing: 1, points })).toEqual([
    [23, 5],
    [11, 29],
  ]);
  const many = Array.from({ length: 500 }, (_, i): Vec2 => [Math.cos(i), Math.sin(i)]);
  expect(dotsOfFormation({ kind: 'outline', outline: { outline: many } }).length).toBeLessThanOrEqual(40);
});
