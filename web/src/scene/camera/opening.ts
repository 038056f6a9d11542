// What the opening view shows apart from the crowd: what stands near it, and where it is to go.

import type { Vec2 } from '../../protocol/generated/commands';
import type { SceneFacts } from '../../protocol/scene';
import type { GroupView } from '../../model/frame_view';
import type { GroundPoint } from '../../model/plane';

/** Things within this of the crowd are shown [m]. */
const kNear = 20;
/** They widen the view by no more than this to a side, so that people stay large [m]. */
export const kWiden = 6;
/** So far from the crowd its goals are shown [m]. */
const kGoal = 12;

/** Points to fit into the view: corners of what is near, drawn in where they would widen it too far. Beside patches, which say
 * more of the place, obstacles do not count. */
export function surroundings(
  scene: SceneFacts | null,
  crowd: readonly GroundPoint[],
  widen: number = kWiden,
): GroundPoint[] {
  if (!scene || crowd.length === 0) return [];
  const xs = crowd.map((point) => point.x);
  const ys = crowd.map((point) => point.y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));
  const near = (corners: readonly Vec2[], most: number): GroundPoint[] =>
    corners
      .filter(([x, y]) => Math.hypot(x - clamp(x, x0, x1), y - clamp(y, y0, y1)) <= kNear)
      .map(([x, y]) => ({ x: clamp(x, x0 - most, x1 + most), y: clamp(y, y0 - most, y1 + most) }));
  const obstacles = scene.obstacles.flatMap(({ polygon, centre }) => (polygon.length > 0 ? polygon : [centre]));
  const patches = scene.patches.flatMap(({ polygon }) => polygon);
  const checkpoints = scene.checkpoints.map(({ position }) => position);
  return near([...(patches.length > 0 ? [] : obstacles), ...patches, ...checkpoints], widen);
}

/** Where its orders lead the crowd, drawn in where they are far. */
export function goals(groups: readonly GroupView[], crowd: readonly GroundPoint[]): GroundPoint[] {
  const xs = crowd.map((point) => point.x);
  const ys = crowd.map((point) => point.y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));
  return groups.flatMap(({ orders }) =>
    orders
      .filter(({ kind }) => kind === 'move' || kind === 'guard')
      .map(({ target: [x, y] }) => ({ x: clamp(x, x0 - kGoal, x1 + kGoal), y: clamp(y, y0 - kGoal, y1 + kGoal) })),
  );
}
