// From a drawn loop to the few corners of an area control.

import { convexHull, turn, type GroundPoint } from '../model/plane';

const kMostCorners = 6;

/** Twice the area that is lost without this corner. */
function loss(hull: readonly GroundPoint[], corner: number): number {
  const count = hull.length;
  return turn(hull[(corner + count - 1) % count]!, hull[corner]!, hull[(corner + 1) % count]!);
}

/**
 * The hull of a lasso, reduced to 3 to 6 corners: corners that cost the least area go first, and beyond that
 * those that cost less than a fiftieth of it. Empty where the loop spans less than `leastArea` [m^2].
 */
export function lassoCorners(loop: readonly GroundPoint[], leastArea = 0.5): GroundPoint[] {
  const hull = convexHull(loop);
  if (hull.length < 3) return [];
  let doubled = 0;
  for (let i = 1; i + 1 < hull.length; ++i) doubled += turn(hull[0]!, hull[i]!, hull[i + 1]!);
  if (doubled / 2 < leastArea) return [];
  while (hull.length > 3) {
    const losses = hull.map((_, corner) => loss(hull, corner));
    const least = Math.min(...losses);
    if (hull.length <= kMostCorners && least > doubled / 50) break;
    hull.splice(losses.indexOf(least), 1);
  }
  return hull;
}
