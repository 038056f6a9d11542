// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { GroupView } from '../../model/frame_view';
import type { QueueOrder } from '../../model/queue_order';
import { madeGroup, madeOrder, quietOrders } from '../../model/test_frames';
import type { Given, Order } from '../../protocol/generated/commands';
import { CameraController } from '../camera/camera_controller';
import { paletteOf } from '../drawing/palette';
import { MarkPainter } from './mark_painter';
import { legsOf, OrderMarks, type OrderScene } from './order_marks';

const camera = new CameraController();
const pen = new Proxy({}, { get: () => () => undefined, set: () => true });
let badges: string[];
let marks: OrderMarks;

beforeEach(() => {
  camera.resize(1280, 800);
  camera.setPose({ targetX: 0, targetY: 0, distance: 60, turn: 0, pitch: 0.9 });
  badges = [];
  vi.spyOn(MarkPainter.prototype, 'badge').mockImplementation((_at, text) => void badges.push(text));
  marks = new OrderMarks(new MarkPainter(pen as never));
});

afterEach(() => vi.restoreAllMocks());

function order(id: number, x: number, y: number, more: Given<Order> = {}): QueueOrder {
  return madeOrder(id, { target: [x, y], ...more });
}

function draw(groups: readonly GroupView[], queues = true, more: Partial<OrderScene> = {}): void {
  const scene: OrderScene = {
    camera,
    palette: paletteOf('light'),
    colours: groups.map((_, i) => i),
    ...quietOrders(),
    groups,
    selected: new Set([1]),
    queues,
    ...more,
  };
  marks.draw(scene);
}

it('a queue leads from where the group stands, along its way, from target to target', () => {
  const group = madeGroup(1, [], {
    way: [3, 4],
    orders: [order(1, 6, 4), order(2, 6, 9, { route: [[8, 4]] }), order(3, 0, 0, { kind: 'face', facing: 2 })],
  });
  const legs = legsOf(group, [group]);
  expect(legs[0]!.points).toEqual([
    { x: 0, y: 0 },
    { x: 3, y: 4 },
    { x: 6, y: 4 },
  ]);
  expect(legs[0]!.facing).toBeCloseTo(0);
  expect(legs[1]!.points).toEqual([
    { x: 6, y: 4 },
    { x: 8, y: 4 },
    { x: 6, y: 9 },
  ]);
  // Turning happens where the leg before ended.
  expect(legs[2]!.points).toEqual([{ x: 6, y: 9 }]);
  expect(legs[2]!.facing).toBe(2);
});

it('who follows is led to the group that it follows, wherever that is now', () => {
  const leader = madeGroup(2, [], { x: 7, y: -3 });
  const group = madeGroup(1, [], { orders: [order(1, 0, 0, { kind: 'follow', group: 2 })] });
  const [leg] = legsOf(group, [group, leader]);
  expect(leg!.points[1]).toEqual({ x: 7, y: -3 });
});

it('numbers the orders; those at one place share a badge, and a single one has none', () => {
  draw([madeGroup(1, [], { orders: [order(1, 5, 0), order(2, 9, 0), order(3, 9, 0, { kind: 'face' })] })]);
  expect(badges).toEqual(['1', '2–3']);
  badges = [];
  draw([madeGroup(1, [], { orders: [order(1, 5, 0)] })]);
  expect(badges).toEqual([]);
});

it('draws no queues where they are switched off', () => {
  draw([madeGroup(1, [], { orders: [order(1, 5, 0), order(2, 9, 0)] })], false);
  expect(badges).toEqual([]);
});

it('orders that wait are drawn by the ways that are known', () => {
  const group = madeGroup(1, [], { orders: [order(1, 6, 0), order(2, 0, 8)] });
  const way = [
    { x: 6, y: 0 },
    { x: 9, y: 4 },
    { x: 0, y: 8 },
  ];
  const legs = legsOf(group, [group], new Map([[2, way]]));
  expect(legs[1]!.points).toEqual(way);
  expect(legsOf(group, [group])[1]!.points).toEqual([way[0], way[2]]);
});

it('a drawn order has its way and a label; a way that leads nowhere ends in a cross', () => {
  const labels: string[] = [];
  let crosses = 0;
  vi.spyOn(MarkPainter.prototype, 'label').mockImplementation((_at, text) => void labels.push(text));
  vi.spyOn(MarkPainter.prototype, 'cross').mockImplementation(() => void ++crosses);
  const way = [
    { x: 0, y: 0 },
    { x: 4, y: 4 },
  ];
  const drawn = { moves: [], rectangle: [], route: [] };
  const group = madeGroup(1, []);
  draw([group], true, { drawn, forecasts: [{ index: 0, way, arrives: true, text: 'in 0:05' }] });
  expect([labels, crosses]).toEqual([['in 0:05'], 0]);
  draw([group], true, { drawn, forecasts: [{ index: 0, way, arrives: false, text: 'Cannot be reached' }] });
  expect([labels.length, crosses]).toEqual([2, 1]);
});
