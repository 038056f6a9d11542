import { beforeEach, describe, expect, it } from 'vitest';
import type { Cuttable } from '../model/cut';
import type { GroundPoint } from '../model/plane';
import type { ContactOwner } from './contact';
import { CutTool } from './cut_tool';
import { contactAt, FakeDesk } from './test_support';

let desk: FakeDesk;
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
  desk = new FakeDesk();
  desk.cuttable = [square(4, 0, 0), square(9, 1, 10)];
  tool = new CutTool(desk);
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
    expect(desk.did).toEqual(['split 4: 15 | 10']);
    expect(desk.cutShown).toBeNull();
  });

  it('shows who would leave', () => {
    const owner = begin({ x: 1.5, y: -4 });
    owner.move([contactAt(1.5, 4)]);
    expect(desk.cutShown!.leaving).toHaveLength(20);
    owner.end(contactAt(1.5, 4), true);
    expect(desk.did).toEqual([]);
  });

  it('cuts the formation that it crosses most of, not the one it only touches', () => {
    stroke({ x: 2, y: 0.5 }, { x: 14, y: 0.5 });
    expect(desk.did).toEqual(['split 9: 10 | 15']);
  });

  it('joins where it leads from one formation to another', () => {
    stroke({ x: 0, y: 0 }, { x: 10, y: 0 });
    expect(desk.did).toEqual(['merge 4 into 9']);
  });

  it('says so where it divides nothing, and a tap does nothing', () => {
    stroke({ x: -6, y: 5 }, { x: 6, y: 5 });
    stroke({ x: 2.2, y: -4 }, { x: 2.2, y: 4 });
    stroke({ x: 0, y: 0 }, { x: 0.02, y: 0 });
    expect(desk.did).toEqual(['missed', 'missed']);
  });

  it('two fingers pulled apart divide it square to the line between them', () => {
    const [a, b] = [begin({ x: -0.5, y: 0 }, 1), begin({ x: 0.5, y: 0 }, 2)];
    a.move([contactAt(-0.7, 0, { pointer: 1 })]);
    expect(desk.cutShown).toBeNull();
    a.move([contactAt(-3, 0, { pointer: 1 })]);
    b.move([contactAt(3.2, 0, { pointer: 2 })]);
    expect(desk.cutShown!.index).toBe(0);
    b.end(contactAt(3.2, 0, { pointer: 2 }), false);
    a.end(contactAt(-3, 0, { pointer: 1 }), false);
    // The middle column lies on the line: it stays.
    expect(desk.did).toEqual(['split 4: 10 | 15']);
  });

  it('two fingers that stay together divide nothing', () => {
    const [a, b] = [begin({ x: -0.5, y: 0 }, 1), begin({ x: 0.5, y: 0 }, 2)];
    a.move([contactAt(-0.6, 0, { pointer: 1 })]);
    a.end(contactAt(-0.6, 0, { pointer: 1 }), false);
    b.end(contactAt(0.5, 0, { pointer: 2 }), false);
    expect(desk.did).toEqual([]);
  });
});
