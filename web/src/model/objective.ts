// The objectives that a plan can minimise, and their current values.

import type { StudioFrame } from './studio_frame';
import type { SceneParameter } from '../protocol/scene';
import { formatCount, formatFigure } from './formatters';

/** Distances that characters walk, over all groups, on uniform ground: sum [m], sum of squares [m^2], longest [m]. */
export interface Walks {
  readonly sum: number;
  readonly squares: number;
  readonly longest: number;
}

/** Index: how plan.objective numbers them. */
export const kObjectives: readonly {
  readonly label: string;
  readonly unit: string;
  readonly value: (walks: Walks) => number;
}[] = [
  { label: 'Least sum', unit: 'm', value: (walks) => walks.sum },
  { label: 'Least squares', unit: 'm²', value: (walks) => walks.squares },
  { label: 'Least longest', unit: 'm', value: (walks) => walks.longest },
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

/** "Least sum: 812 m". */
export function objectiveText(index: number, walks: Walks): string {
  return `${kObjectives[index]!.label}: ${objectiveFigure(index, walks)}`;
}

const valueOf = (parameters: readonly SceneParameter[], name: string): number | undefined =>
  parameters.find((one) => one.name === name)?.value;

/** Index of the world's objective; -1 where its parameters do not hold one. */
export function objectiveOf(parameters: readonly SceneParameter[]): number {
  const chosen = valueOf(parameters, 'plan.objective');
  if (chosen !== undefined) return Math.min(kObjectives.length - 1, Math.max(0, Math.round(chosen)));
  const exponent = valueOf(parameters, 'plan.exponent');
  return exponent === 1 ? 0 : exponent === 2 ? 1 : -1;
}

/** Indices of the objectives that the world supports. */
export function objectivesFor(parameters: readonly SceneParameter[]): readonly number[] {
  if (valueOf(parameters, 'plan.objective') !== undefined) return [0, 1, 2];
  return valueOf(parameters, 'plan.exponent') !== undefined ? [0, 1] : [];
}

/** The parameter that sets this objective. */
export function objectiveParameter(
  parameters: readonly SceneParameter[],
  index: number,
): { readonly name: string; readonly value: number } {
  if (valueOf(parameters, 'plan.objective') !== undefined) return { name: 'plan.objective', value: index };
  return { name: 'plan.exponent', value: index + 1 };
}
