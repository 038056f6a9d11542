// Which scenario a page goes back to from a take.

import type { StudioState } from './studio_state';
import type { ScenarioInfo } from '../protocol/messages';

/** The scenario to go back to from a take. */
export function scenarioBehind(state: Pick<StudioState, 'scenarios' | 'title' | 'lastSteered'>): ScenarioInfo | null {
  const { scenarios, title, lastSteered } = state;
  const known = scenarios.find(({ name }) => name === lastSteered) ?? scenarios.find((one) => one.title === title);
  return known ?? scenarios[0] ?? null;
}
