import { describe, expect, it } from 'vitest';
import type { StudioGroup } from './studio_frame';
import { objectiveOf, objectiveParameter, objectivesFor, objectiveText, walksOf } from './objective';

const parameter = (name: string, value: number) => ({ name, value });

describe('objectives', () => {
  it('are told for all groups together', () => {
    const groups = [
      { walkSum: 10, walkSquares: 60, walkLongest: 7 },
      { walkSum: 5, walkSquares: 13, walkLongest: 3 },
    ] as StudioGroup[];
    const walks = walksOf({ groups });
    expect(walks).toEqual({ sum: 15, squares: 73, longest: 7 });
    expect([0, 1, 2].map((index) => objectiveText(index, walks))).toEqual([
      'Least sum: 15.0\u2009m',
      'Least squares: 73.0\u2009m²',
      'Least longest: 7.00\u2009m',
    ]);
    expect(objectiveText(1, { ...walks, squares: 31204.4 })).toBe('Least squares: 31\u2009204\u2009m²');
  });

  it('follow plan.objective where the world has it', () => {
    const parameters = [parameter('plan.exponent', 2), parameter('plan.objective', 2)];
    expect([objectiveOf(parameters), objectivesFor(parameters)]).toEqual([2, [0, 1, 2]]);
    expect(objectiveParameter(parameters, 0)).toEqual({ name: 'plan.objective', value: 0 });
  });

  it('follow the exponent where it has not', () => {
    expect(objectiveOf([parameter('plan.exponent', 1)])).toBe(0);
    expect(objectiveOf([parameter('plan.exponent', 1.5)])).toBe(-1);
    expect(objectiveParameter([parameter('plan.exponent', 1)], 1)).toEqual({ name: 'plan.exponent', value: 2 });
    expect([objectiveOf([]), objectivesFor([])]).toEqual([-1, []]);
  });
});
