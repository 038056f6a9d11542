// How the crowd does, in words that need no explanation.

import { formatCount } from './formatters';
import { standingSum, type StandingSum } from './standing';
import type { StudioState } from './studio_state';

export interface PlainWords {
  readonly people: string;
  readonly does: string;
  /** Empty where there is nothing to collect. */
  readonly items: string;
  /** Who cannot be in their places, and why; empty for nobody. */
  readonly barred: string;
  /** Empty where the world goes as fast as it shall. */
  readonly slow: string;
}

/** Distances below this are not told [m]. */
const kNear = 1;
/** A pace below this share of the wanted one is slow. */
const kSlow = 0.95;

type PlainState = Pick<
  StudioState,
  'characters' | 'lag' | 'playing' | 'replaying' | 'standings' | 'pace' | 'speed' | 'items' | 'collected' | 'units'
>;

function doing({ lag, playing, replaying, units }: PlainState, { all, there, walk, held }: StandingSum): string {
  if (!playing) return 'paused';
  if (replaying) return 'in a replay';
  if (all === 0) return '';
  if (there === all) return 'all in their places';
  if (walk > 0) {
    const ordered = walk === all && units.some(({ orders, held: waits }) => orders.length > 0 && !waits);
    const far = lag < kNear ? '' : `, ${lag < 9.95 ? lag.toFixed(1) : Math.round(lag)} m to go`;
    if (ordered && far === '') return 'walking as ordered';
    return walk === all ? `on the way${far}` : `${formatCount(walk)} on the way${far}`;
  }
  if (held === all) return 'waiting';
  return there === 0 ? 'nobody in place' : `${formatCount(there)} in their places`;
}

function slowness({ pace, speed }: PlainState): string {
  if (!(pace < kSlow * speed)) return '';
  return speed === 1 ? `at ${Math.max(1, Math.round(100 * pace))} % of real time` : `at ${pace.toFixed(1)}×`;
}

export function plainWords(state: PlainState): PlainWords {
  const { characters, items, collected, standings } = state;
  const sum = standingSum(standings);
  return {
    people: characters === 1 ? '1 person' : `${formatCount(characters)} people`,
    does: characters === 0 ? '' : doing(state, sum),
    items: items > 0 ? `${collected} of ${items} collected` : '',
    barred: sum.barred,
    slow: characters > 0 ? slowness(state) : '',
  };
}
