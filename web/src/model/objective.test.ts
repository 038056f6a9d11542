import { describe, expect, it } from 'vitest';
import type { StudioGroup } from './studio_frame';
import { objectiveOf, objectiveParameters, objectivesFor, objectiveText, walksOf } from './objective';

const parameter = (name: string, value: number) => ({ name, value });

/** Values of ours that the engine takes. */
const kTaken = new Map([
  ['plan.objective', [0, 1]],
  ['plan.exponent', [1, 2]],
]);

describe('objectives', () => {
  it('are told for all groups together', () => {
    const groups = [
      { walkSum: 10, walkSquares: 60, walkLongest: 7 },
      { walkSum: 5, walkSquares: 13, walkLongest: 3 },
    ] as StudioGroup[];
    const walks = walksOf({ groups });
    expect(walks).toEqual({ sum: 15, squares: 73, longest: 7 });
    expect([0, 1, 2].map((index) => objectiveText(index, walks))).toEqual([
      'Least walking: 15.0\u2009m',
      'Even walks: 73.0\u2009m²',
      'Nobody far: 7.00\u2009m',
    ]);
    expect(objectiveText(1, { ...walks, squares: 31204.4 })).toBe('Even walks: 31\u2009204\u2009m²');
  });

  it('are the power objective by its exponent, and the longest walk', () => {
    const world = (objective: number, exponent: number) => [
      parameter('plan.objective', objective),
      parameter('plan.exponent', exponent),
    ];
    expect(objectivesFor(world(0, 2))).toEqual([0, 1, 2]);
    expect([objectiveOf(world(0, 1)), objectiveOf(world(0, 2)), objectiveOf(world(0, 1.5))]).toEqual([0, 1, -1]);
    expect([objectiveOf(world(1, 1)), objectiveOf(world(1, 2)), objectiveOf(world(1, 3))]).toEqual([2, 2, 2]);
  });

  it('send values that the world takes, and read back as what was chosen', () => {
    for (const objective of [0, 1])
      for (const exponent of [1, 1.5, 2])
        for (const index of [0, 1, 2]) {
          const before = [parameter('plan.objective', objective), parameter('plan.exponent', exponent)];
          const sent = objectiveParameters(before, index);
          for (const { name, value } of sent) expect(kTaken.get(name)).toContain(value);
          const after = before.map((old) => sent.find(({ name }) => name === old.name) ?? old);
          expect(objectiveOf(after)).toBe(index);
        }
  });

  it('are chosen by the exponent alone where the world has no other', () => {
    expect(objectiveOf([parameter('plan.exponent', 1)])).toBe(0);
    expect(objectiveOf([parameter('plan.exponent', 1.5)])).toBe(-1);
    expect(objectivesFor([parameter('plan.exponent', 1)])).toEqual([0, 1]);
    expect(objectiveParameters([parameter('plan.exponent', 1)], 1)).toEqual([{ name: 'plan.exponent', value: 2 }]);
    expect([objectiveOf([]), objectivesFor([])]).toEqual([-1, []]);
  });
});
