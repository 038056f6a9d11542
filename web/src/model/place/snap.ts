// Where a point goes that is drawn or dragged: to corners of others, to the grid, to right angles.

import { distance, type GroundPoint } from '../plane';
import { outlineOf, type Thing } from './things';

/** Lines of the grid lie so far apart [m]. */
export const kGrid = 0.5;
/** Of right and half right angles. */
const kAngle = Math.PI / 4;

function toGrid(value: number): number {
  return Math.round(value / kGrid) * kGrid;
}

/** The nearest corner of a thing within `reach` [m], else the grid. */
export function snapped(p: GroundPoint, others: readonly Thing[], reach: number): GroundPoint {
  let best: GroundPoint | null = null;
  for (const one of others) {
    if (!one.polygon) continue;
    for (const corner of outlineOf(one))
      if (distance(corner, p) < Math.min(reach, best ? distance(best, p) : Infinity)) best = corner;
  }
  return best ?? { x: toGrid(p.x), y: toGrid(p.y) };
}

/** The point turned about `from` to the nearest multiple of 45 degrees. */
export function rightAngled(from: GroundPoint, p: GroundPoint): GroundPoint {
  const length = distance(from, p);
  const angle = Math.round(Math.atan2(p.y - from.y, p.x - from.x) / kAngle) * kAngle;
  return { x: from.x + length * Math.cos(angle), y: from.y + length * Math.sin(angle) };
}
