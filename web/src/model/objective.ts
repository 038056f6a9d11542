// The objectives that a plan can minimise, and their current values.

import type { StudioFrame } from './studio_frame';
import { kPlanObjective, type ParameterName } from '../protocol/generated/parameters';
import type { SceneParameter } from '../protocol/messages';
import { formatCount, formatFigure } from './formatters';

/** Distances that characters walk, over all groups, on uniform ground: sum [m], sum of squares [m^2], longest [m]. */
export interface Walks {
  readonly sum: number;
  readonly squares: number;
  readonly longest: number;
}

/** The choices, in the order of the menu. */
export const kObjectives: readonly {
  readonly label: string;
  readonly unit: string;
  readonly value: (walks: Walks) => number;
}[] = [
  { label: 'Least walking', unit: 'm', value: (walks) => walks.sum },
  { label: 'Even walks', unit: 'm²', value: (walks) => walks.squares },
  { label: 'Nobody far', unit: 'm', value: (walks) => walks.longest },
];

export function walksOf({ groups }: Pick<StudioFrame, 'groups'>): Walks {
  return groups.reduce(
    (all, { walkSum, walkSquares, walkLongest }) => ({
      sum: all.sum + walkSum,
      squares: all.squares + walkSquares,
      longest: Math.max(all.longest, walkLongest),
    }),
    { sum: 0, squares: 0, longest: 0 },
  );
}

/** "812 m". */
export function objectiveFigure(index: number, walks: Walks): string {
  const { unit, value } = kObjectives[index]!;
  const figure = value(walks);
  return `${figure < 1000 ? formatFigure(figure) : formatCount(figure)}\u2009${unit}`;
}

/** "Least walking: 812 m". */
export function objectiveText(index: number, walks: Walks): string {
  return `${kObjectives[index]!.label}: ${objectiveFigure(index, walks)}`;
}

const valueOf = (parameters: readonly SceneParameter[], name: ParameterName): number | undefined =>
  parameters.find((one) => one.name === name)?.value;

/** Index of the world's objective; -1 where its parameters hold none of ours. */
export function objectiveOf(parameters: readonly SceneParameter[]): number {
  if (valueOf(parameters, 'plan.objective') === kPlanObjective.longestWalk) return 2;
  const exponent = valueOf(parameters, 'plan.exponent');
  return exponent === 1 ? 0 : exponent === 2 ? 1 : -1;
}

/** Indices of the objectives that the world supports. */
export function objectivesFor(parameters: readonly SceneParameter[]): readonly number[] {
  if (valueOf(parameters, 'plan.exponent') === undefined) return [];
  return valueOf(parameters, 'plan.objective') === undefined ? [0, 1] : [0, 1, 2];
}

/** The parameters that set this objective: least sum and least squares are the power objective with exponent 1 and 2. */
export function objectiveParameters(parameters: readonly SceneParameter[], index: number): readonly SceneParameter[] {
  if (index === 2) return [{ name: 'plan.objective', value: kPlanObjective.longestWalk }];
  const exponent = { name: 'plan.exponent', value: index + 1 };
  const known = valueOf(parameters, 'plan.objective') !== undefined;
  return known ? [exponent, { name: 'plan.objective', value: kPlanObjective.power }] : [exponent];
}
