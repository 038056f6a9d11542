// Directions of the arrow keys on the ground, as the camera looks.

import type { GroundPoint, ScreenPoint } from '../model/plane';
import type { GroundAxes } from './keyboard_steering';

/** Right and up on the ground, as the camera looks; the world's axes where the middle shows no ground. */
export function groundAxes(toGround: (at: ScreenPoint) => GroundPoint | null, middle: ScreenPoint): GroundAxes {
  const from = toGround(middle);
  const towards = (x: number, y: number): GroundPoint | null => {
    const to = toGround({ x: middle.x + x, y: middle.y + y });
    if (!from || !to) return null;
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    return length > 0 ? { x: (to.x - from.x) / length, y: (to.y - from.y) / length } : null;
  };
  return { right: towards(20, 0) ?? { x: 1, y: 0 }, up: towards(0, -20) ?? { x: 0, y: 1 } };
}
