// Who is in place and what keeps the others from theirs: sums over groups, and words for them.

import { Standing } from '../protocol/messages';

/** People by Standing. */
export type Standings = ArrayLike<number>;

/** What keeps people from their places, and what is said of so many of them. */
const kBars: readonly (readonly [Standing, (count: number) => string])[] = [
  [Standing.Outside, (n) => `${placesOf(n)} outside the ground`],
  [Standing.Obstacle, (n) => `${placesOf(n)} in obstacles`],
  [Standing.Narrow, (n) => `${placesOf(n)} too narrow`],
  [Standing.NoWay, (n) => `${n} without a way`],
  [Standing.Crowded, (n) => `${n} without room`],
  [Standing.Stuck, (n) => `${n} stuck`],
];

function placesOf(count: number): string {
  return count === 1 ? '1 place' : `${count} places`;
}

/** Of several groups together. */
export interface StandingSum {
  readonly all: number;
  readonly there: number;
  readonly walk: number;
  readonly held: number;
  /** "12 places outside the ground · 3 stuck"; empty where nobody is barred. */
  readonly barred: string;
}

export function standingSum(groups: readonly Standings[]): StandingSum {
  const count = (standing: Standing): number => groups.reduce((sum, one) => sum + (one[standing] ?? 0), 0);
  const bars = kBars.map(([standing, words]) => [count(standing), words] as const).filter(([number]) => number > 0);
  const [there, walk, held] = [count(Standing.InPlace), count(Standing.OnTheWay), count(Standing.Held)];
  return {
    all: there + walk + held + bars.reduce((sum, [number]) => sum + number, 0),
    there,
    walk,
    held,
    barred: bars.map(([number, words]) => words(number)).join(' · '),
  };
}
