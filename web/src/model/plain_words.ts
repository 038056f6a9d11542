// How the crowd does, in words that need no explanation.

import { formatCount } from './formatters';
import type { StudioState } from './studio_state';

export interface PlainWords {
  readonly people: string;
  readonly does: string;
  /** Empty where there is nothing to collect. */
  readonly items: string;
  /** Empty where the server keeps up. */
  readonly slow: string;
}

/** Who is so near to its place is in it; so near, nearly [m]. */
const kInPlace = 0.35;
const kNearly = 1;
/** Time that a step stands for [ms]. */
const kStep = 1000 / 60;

type PlainState = Pick<
  StudioState,
  'characters' | 'lag' | 'playing' | 'replaying' | 'stepMs' | 'speed' | 'items' | 'collected' | 'units'
>;

function doing({ lag, playing, replaying, units }: PlainState): string {
  if (!playing) return 'paused';
  if (replaying) return 'in a replay';
  const ordered = units.some(({ orders, held }) => orders.length > 0 && !held);
  if (ordered && lag < kNearly) return 'walking as ordered';
  if (!Number.isFinite(lag) || lag < kInPlace) return 'all in their places';
  if (lag < kNearly) return 'nearly in their places';
  return `on the way, ${lag < 9.95 ? lag.toFixed(1) : Math.round(lag)} m to go`;
}

export function plainWords(state: PlainState): PlainWords {
  const { characters, items, collected, stepMs, speed } = state;
  const share = kStep / Math.max(stepMs * speed, 1e-9);
  return {
    people: characters === 1 ? '1 person' : `${formatCount(characters)} people`,
    does: characters === 0 ? '' : doing(state),
    items: items > 0 ? `${collected} of ${items} collected` : '',
    slow: characters > 0 && share < 0.95 ? `at ${Math.max(1, Math.round(100 * share))} % of its speed` : '',
  };
}
