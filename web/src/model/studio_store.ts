// Holds the state of the page. All changes pass through `set`, which calls the watchers of the changed fields.

import { kInitialState, type StudioState } from './studio_state';

type Listener = (state: StudioState, before: StudioState) => void;

export class StudioStore {
  private listeners_: Listener[] = [];
  private current_: StudioState = kInitialState;

  get state(): StudioState {
    return this.current_;
  }

  set(change: Partial<StudioState>): void {
    const before = this.current_;
    this.current_ = { ...before, ...change };
    for (const listener of this.listeners_) listener(this.current_, before);
  }

  /** The listener is called at once, and whenever one of the fields changes. */
  watch(fields: readonly (keyof StudioState)[], listener: (state: StudioState) => void): void {
    listener(this.current_);
    this.listeners_.push((state, before) => {
      if (fields.some((field) => state[field] !== before[field])) listener(state);
    });
  }
}
