// What a visitor chooses to see of the scene.

export type Theme = 'light' | 'dark';

/** What is drawn over the ground. */
export interface Layers {
  /** The formation's mesh. */
  readonly mesh: boolean;
  /** Goal points of the characters. */
  readonly places: boolean;
  /** Drawn paths that lie ahead. */
  readonly paths: boolean;
}
