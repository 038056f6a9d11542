// Where people can be told to go without places: exits to leave by, and areas to wait in.

import type { AreaKindWord, OrderKindWord } from '../protocol/generated/words';
import type { SceneArea } from '../protocol/messages';
import { distanceToSegment, insidePolygon, type GroundPoint } from './plane';

/** True for orders during which nobody has a place. */
export function isPlaceless({ kind }: { readonly kind: OrderKindWord }): boolean {
  return kind === 'leave' || kind === 'wait' || kind === 'walk';
}

/** True while nobody of a group has a place. */
export function hasNoPlaces({ orders }: { readonly orders: readonly { readonly kind: OrderKindWord }[] }): boolean {
  return orders[0] !== undefined && isPlaceless(orders[0]);
}

/** A press this near counts as one on the area [m]. */
const kNear = 1;

function away(at: GroundPoint, { polygon }: SceneArea): number {
  const corners = polygon.map(([x, y]) => ({ x, y }));
  if (insidePolygon(at, corners)) return 0;
  return Math.min(...corners.map((a, k) => distanceToSegment(at, a, corners[(k + 1) % corners.length]!)));
}

/** The area of that kind at a press, or near it; null for none. */
export function areaAt(areas: readonly SceneArea[], kind: AreaKindWord, at: GroundPoint): SceneArea | null {
  const near = areas
    .filter((area) => area.kind === kind)
    .map((area) => ({ area, away: away(at, area) }))
    .sort((a, b) => a.away - b.away)[0];
  return near && near.away <= kNear ? near.area : null;
}
