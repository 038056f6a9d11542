// What a director would like to do with the world that others direct, too: they can be asked first.

import type { StudioState } from './studio_state';
import type { StudioStore } from './studio_store';

/** Of each, what it asks of whoever does it, and what the others are told. */
export interface Wish {
  /** "Change the place for all?" */
  readonly question: string;
  /** "Change for all" */
  readonly yes: string;
  /** "open Market square": what Ada would like to. */
  readonly text: string;
}

/** A wish that waits for the one who has it. */
export interface Consent {
  readonly wish: Wish;
  readonly then: () => void;
  readonly never: () => void;
}

/** The wish of another director, until it is answered. */
export interface AskedWish {
  readonly number: number;
  readonly client: number;
  readonly wish: string;
  /** Page clock [ms]. */
  readonly until: number;
}

export function openingOf(title: string): Wish {
  return { question: 'Change the place for all?', yes: 'Change for all', text: `open ${title}` };
}

export function takeOpeningOf(title: string): Wish {
  return { question: 'Open the take for all?', yes: 'Open for all', text: `open the take ${title}` };
}

export const kBeginAgain: Wish = {
  question: 'Begin again for all?',
  yes: 'Begin again for all',
  text: 'begin again from the start',
};
export const kWatch: Wish = {
  question: 'Show the demonstration to all?',
  yes: 'Show it to all',
  text: 'begin again and show the demonstration',
};

export function othersOf({ directors }: Pick<StudioState, 'directors'>): readonly StudioState['directors'][number][] {
  return directors.filter(({ own }) => !own);
}

/** Does it at once for who is alone; otherwise when that director has chosen so, or the others allow it. */
export function whenAllowed(store: StudioStore, wish: Wish, then: () => void, never: () => void = () => {}): void {
  if (othersOf(store.state).length === 0) return then();
  store.state.consent?.never();
  store.set({ consent: { wish, then, never } });
}

/** The same for who waits; false where it is not to be done. */
export function allowed(store: StudioStore, wish: Wish): Promise<boolean> {
  return new Promise((done) =>
    whenAllowed(
      store,
      wish,
      () => done(true),
      () => done(false),
    ),
  );
}
