// What stands still in a world or is known for good, as the Scene message has it.

import type { TimedPath } from './generated/commands';
import type { Scene } from './messages';

export type SceneFacts = Readonly<Omit<Scene, 'type' | 'revision'>>;

/** True where both are the same place, whatever stands in it: the view need not open anew. */
export function isSameWorld(a: SceneFacts, b: SceneFacts): boolean {
  const corners = ({ box }: SceneFacts): string => [...box.min, ...box.max].join();
  return (a.name === b.name || a.world === b.world) && corners(a) === corners(b);
}

/** True for what follows a path. */
export function isMoving({ path }: { readonly path: TimedPath }): boolean {
  return path.waypoints.length > 0;
}

/** A gate's path ends with the world [s]: it always has something left to do. */
export const kGateEnd = 1e7;

/** True for an obstacle that slides aside and back. */
export function isGatePath(path: TimedPath | null): boolean {
  const last = path?.waypoints[path.waypoints.length - 1];
  return last?.time === kGateEnd && !path!.loop;
}
