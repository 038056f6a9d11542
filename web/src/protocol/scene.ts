// What stands still in a world or is known for good, as the Scene message has it.

import type { TimedPath } from './generated/commands';
import type { Scene } from './messages';

export type SceneFacts = Readonly<Omit<Scene, 'type' | 'revision'>>;

/** True where both are the same place, whatever stands in it: the view need not open anew. */
export function isSameWorld(a: SceneFacts, b: SceneFacts): boolean {
  const corners = ({ box }: SceneFacts): string => [...box.min, ...box.max].join();
  return a.name === b.name && corners(a) === corners(b);
}

/** True for what follows a path. */
export function isMoving({ path }: { readonly path: TimedPath }): boolean {
  return path.waypoints.length > 0;
}
