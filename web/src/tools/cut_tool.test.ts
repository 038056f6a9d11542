import { beforeEach, describe, expect, it } from 'vitest';
import type { Cuttable } from '../model/cut';
import type { GroundPoint } from '../model/plane';
import type { ContactOwner } from './contact';
import { CutTool } from './cut_tool';
import { contactAt, FakeController } from './test_support';

let orders: FakeController;
let tool: CutTool;

/** A square of 4 m with a place on each whole metre. */
function square(group: number, index: number, x: number): Cuttable {
  const outline = [
    { x: x - 2.5, y: -2.5 },
    { x: x + 2.5, y: -2.5 },
    { x: x + 2.5, y: 2.5 },
    { x: x - 2.5, y: 2.5 },
  ];
  const places = [-2, -1, 0, 1, 2].flatMap((dx) => [-2, -1, 0, 1, 2].map((dy) => ({ x: x + dx, y: dy })));
  return { group, index, outline, places };
}

beforeEach(() => {
  orders = new FakeController();
  orders.cuttable = [square(4, 0, 0), square(9, 1, 10)];
  tool = new CutTool(orders);
});

function begin(at: GroundPoint, pointer = 1): ContactOwner {
  const owner = tool.owner();
  owner.begin(contactAt(at.x, at.y, { pointer }));
  return owner;
}

function stroke(from: GroundPoint, to: GroundPoint): void {
  const owner = begin(from);
  owner.move([contactAt((from.x + to.x) / 2, (from.y + to.y) / 2), contactAt(to.x, to.y)]);
  owner.end(contactAt(to.x, to.y), false);
}

describe('the cutting tool', () => {
  it('divides by the line of the stroke; those to its left leave', () => {
    stroke({ x: 0.5, y: -4 }, { x: 0.5, y: 4 });
    // Northwards, with the west to its left: the columns -2, -1, 0.
    expect(orders.did).toEqual(['split 4: 15 | 10']);
    expect(orders.cutShown).toBeNull();
  });

  it('shows who would leave', () => {
    const owner = begin({ x: 1.5, y: -4 });
    owner.move([contactAt(1.5, 4)]);
    expect(orders.cutShown!.leaving).toHaveLength(20);
    owner.end(contactAt(1.5, 4), true);
    expect(orders.did).toEqual([]);
  });

  it('cuts the formation that it crosses most of, not the one it only touches', () => {
    stroke({ x: 2, y: 0.5 }, { x: 14, y: 0.5 });
    expect(orders.did).toEqual(['split 9: 10 | 15']);
  });

  it('joins where it leads from one formation to another', () => {
    stroke({ x: 0, y: 0 }, { x: 10, y: 0 });
    expect(orders.did).toEqual(['merge 4 into 9']);
  });

  it('says so where it divides nothing, and a tap does nothing', () => {
    stroke({ x: -6, y: 5 }, { x: 6, y: 5 });
    stroke({ x: 2.2, y: -4 }, { x: 2.2, y: 4 });
    stroke({ x: 0, y: 0 }, { x: 0.02, y: 0 });
    expect(orders.did).toEqual(['missed', 'missed']);
  });

  it('two fingers pulled apart divide it square to the line between them', () => {
    const [a, b] = [begin({ x: -0.5, y: 0 }, 1), begin({ x: 0.5, y: 0 }, 2)];
    a.move([contactAt(-0.7, 0, { pointer: 1 })]);
    expect(orders.cutShown).toBeNull();
    a.move([contactAt(-3, 0, { pointer: 1 })]);
    b.move([contactAt(3.2, 0, { pointer: 2 })]);
    expect(orders.cutShown!.index).toBe(0);
    b.end(contactAt(3.2, 0, { pointer: 2 }), false);
    a.end(contactAt(-3, 0, { pointer: 1 }), false);
    // The middle column lies on the line: it stays.
    expect(orders.did).toEqual(['split 4: 10 | 15']);
  });

  it('two fingers that stay together divide nothing', () => {
    const [a, b] = [begin({ x: -0.5, y: 0 }, 1), begin({ x: 0.5, y: 0 }, 2)];
    a.move([contactAt(-0.6, 0, { pointer: 1 })]);
    a.end(contactAt(-0.6, 0, { pointer: 1 }), false);
    b.end(contactAt(0.5, 0, { pointer: 2 }), false);
    expect(orders.did).toEqual([]);
  });
});
