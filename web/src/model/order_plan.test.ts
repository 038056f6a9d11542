import { describe, expect, it } from 'vitest';
import { moveCommand } from './commands';
import { placed, widened, widthOf, type GroupShape } from './group_shapes';
import { planLine, planPoint, planRoute, type OrderedGroup } from './order_plan';

/** Ranks and files a metre apart, facing x. */
function block(ranks: number, files: number): GroupShape {
  const places = Array.from({ length: ranks * files }, (_, i) => ({
    x: (ranks - 1) / 2 - Math.floor(i / files),
    y: (files - 1) / 2 - (i % files),
  }));
  return { formation: 'square', spacing: 1, places };
}

function group(id: number, x: number, y: number, shape = block(3, 4)): OrderedGroup {
  return { id, index: id, at: { x, y }, facing: 0, shape };
}

describe('planLine', () => {
  it('shares the front by numbers and from left to right as they stand', () => {
    const [small, large] = [group(1, 9, 0, block(2, 5)), group(2, -9, 0, block(4, 5))];
    const plan = planLine([small, large], { x: -15.75, y: 20 }, { x: 15.75, y: 20 });
    expect(plan.map((one) => one.group)).toEqual([2, 1]);
    // 31.5 m less a gap of 1.5 m: 20 m for 20, 10 m for 10.
    expect(plan.map(({ width }) => width)).toEqual([20, 10].map((width): unknown => expect.closeTo(width, 9)));
    for (const one of plan) {
      expect(Math.max(...one.places.map(({ y }) => y))).toBeCloseTo(20);
      expect(one.facing).toBeCloseTo(Math.PI / 2);
    }
    const [left, right] = plan;
    expect(Math.max(...left!.places.map(({ x }) => x))).toBeLessThan(Math.min(...right!.places.map(({ x }) => x)));
  });

  it('faces to the left-hand side of the line, whichever way it is drawn', () => {
    const [plan] = planLine([group(1, 0, 0)], { x: 5, y: 5 }, { x: 5, y: -5 });
    expect(plan!.facing).toBeCloseTo(0);
  });
});

describe('planPoint and planRoute', () => {
  it('keep how groups stand to each other', () => {
    const groups = [group(1, 0, -3), group(2, 0, 3)];
    const targets = planPoint(groups, { x: 10, y: 10 }).map(({ target }) => target);
    expect(targets).toEqual([
      { x: 10, y: 7 },
      { x: 10, y: 13 },
    ]);
    const ways = planRoute(groups, [
      { x: 0, y: 0 },
      { x: 5, y: 0 },
      { x: 5, y: 6 },
    ]);
    expect(ways.map(({ target }) => target)).toEqual([
      { x: 5, y: 3 },
      { x: 5, y: 9 },
    ]);
    expect(planRoute(groups, [{ x: 0, y: 0 }])).toEqual([]);
  });
});

describe('shapes', () => {
  it('other ranks have everybody, within the width', () => {
    const wide = widened(block(3, 4), 7);
    expect(wide).toHaveLength(12);
    expect(widthOf(wide)).toBe(7);
    expect(widened(block(3, 4), 0)).toHaveLength(12);
    expect(widthOf(widened(block(3, 4), 0.1))).toBe(0);
  });
  it('other shapes stay as they are, and are asked for no width', () => {
    const wedge = { ...block(3, 4), formation: 'wedge' };
    expect(widened(wedge, 6)).toBe(wedge.places);
    const [plan] = planLine([group(1, 0, 0, wedge)], { x: 0, y: 9 }, { x: 6, y: 9 });
    expect([plan!.width, plan!.formation]).toEqual([0, null]);
  });
  it('lines, and places without an order of their own, become ranks', () => {
    const line = { ...block(2, 6), formation: 'line', spacing: 1 };
    const [plan] = planLine([group(1, 0, 0, line)], { x: 0, y: 9 }, { x: 3, y: 9 });
    expect([plan!.width, plan!.formation]).toEqual([3, { kind: 'square', spacing: 1 }]);
    expect(widthOf(plan!.places.map(({ x, y }) => ({ x: y, y: x })))).toBeCloseTo(3);
  });
  it('have their mean at the centre, also with a last rank that is not full', () => {
    // Seven in ranks of five: 5 and 2.
    const seven = { ...block(1, 7), formation: 'square' };
    const places = widened(seven, 4);
    expect(places.reduce((sum, { x }) => sum + x, 0)).toBeCloseTo(0);
    expect(places.filter(({ x }) => Math.abs(x - 2 / 7) < 1e-9)).toHaveLength(5);
    expect(places.slice(5).map(({ y }) => y)).toEqual([0.5, -0.5]);
  });
  it('are put on the ground by centre and heading', () => {
    const [front] = placed([{ x: 2, y: 0 }], { x: 10, y: 10 }, Math.PI / 2);
    expect(front).toEqual({ x: expect.closeTo(10, 9) as number, y: expect.closeTo(12, 9) as number });
  });
});

it('a command says what was drawn, to the millimetre', () => {
  const style = { manner: 'march', turn: 'wheel', mode: 'append' } as const;
  expect(
    moveCommand(3, { target: { x: 1.23456, y: 2 }, facing: null, width: 0, route: [], formation: null }, style),
  ).toEqual({
    kind: 'order',
    group: 3,
    mode: 'append',
    order: {
      target: [1.235, 2],
      facing: null,
      width: 0,
      route: [],
      formation: null,
      manner: 'march',
      turn: 'wheel',
    },
  });
});
