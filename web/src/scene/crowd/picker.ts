// Finds the character under a pointer.

import { distanceToSegment, type ScreenPoint } from '../../model/plane';
import type { CameraController } from '../camera/camera_controller';
import type { CrowdState } from './crowd_state';

/** Height of a figure's head [m]. */
const kHead = 1.7;

/** Index of the character whose figure is nearest on the screen, or -1. */
export function pickCharacter(at: ScreenPoint, state: CrowdState, camera: CameraController): number {
  let best = -1;
  let least = Math.max(10, 0.4 * camera.pixelsPerMetre());
  const { positions: places, count } = state;
  for (let i = 0; i < count; ++i) {
    const x = places[2 * i]!,
      y = places[2 * i + 1]!;
    const away = distanceToSegment(at, camera.worldToScreen(x, y), camera.worldToScreen(x, y, kHead));
    if (away >= least) continue;
    least = away;
    best = i;
  }
  return best;
}
