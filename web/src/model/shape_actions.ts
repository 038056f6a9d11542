// What panels ask for formations of a visitor's own and for new groups.

import type { GroundPoint } from './plane';

/** A group to be put on the ground. */
export interface NewGroup {
  readonly name: string;
  readonly count: number;
  /** Of the library. */
  readonly formation: string;
  /** Between neighbours [m]. */
  readonly spacing: number;
  /** Of each body [m]. */
  readonly radius: number;
  /** The fastest that they run [m/s]. */
  readonly speed: number;
}

export interface ShapeActions {
  /** Takes the tool that draws outlines, or puts it away. */
  toggleDraw(): void;
  /** The active group writes words: places in any unit about their middle, y up, the least gap between two of them. */
  takeWords(places: readonly GroundPoint[], gap: number, words: string): void;
  /** Takes a new group in hand; the next press on the ground puts it down. */
  holdGroup(group: NewGroup): void;
}
