// Whether a mark on the ground would lie over somebody's figure on the screen.

import type { GroundPoint } from '../../model/plane';
import type { CrowdState } from './crowd_state';
import type { CameraController } from '../camera/camera_controller';

/** Heights of a figure at which it is looked for, and its half width there [m]. */
const kHeights = [0.7, 1.15, 1.6];
const kHalfWidth = 0.24;

/** The line of sight to the spot passes over the ground before it, at these heights where somebody may stand. */
export function coversFigure(
  people: Pick<CrowdState, 'someoneNear'>,
  camera: CameraController,
  at: GroundPoint,
): boolean {
  const { eye } = camera.basis();
  const [dx, dy] = [eye[0] - at.x, eye[1] - at.y];
  return kHeights.some((height) => {
    const share = height / Math.max(1e-6, eye[2]);
    return people.someoneNear(at.x + dx * share, at.y + dy * share, kHalfWidth);
  });
}
