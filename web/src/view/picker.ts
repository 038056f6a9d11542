// Who stands under a pointer.

import { distanceToSegment } from '../geometry/plane';
import type { CameraController } from './camera_controller';
import type { ScreenPoint } from './camera_types';
import type { CrowdState } from './crowd_state';

/** Height of a figure's head [m]. */
const kHead = 1.7;

/** Index of the character whose figure is nearest on the screen, or -1. */
export function pickCharacter(at: ScreenPoint, state: CrowdState, camera: CameraController): number {
  let best = -1;
  let least = Math.max(10, 0.4 * camera.pixelsPerMetre());
  for (let i = 0; i < state.count; ++i) {
    const x = state.placement[4 * i] ?? 0;
    const y = state.placement[4 * i + 1] ?? 0;
    const away = distanceToSegment(at, camera.worldToScreen(x, y), camera.worldToScreen(x, y, kHead));
    if (away >= least) continue;
    least = away;
    best = i;
  }
  return best;
}
