// Reduces scattered points to those that bound a view, with a margin around them.

import type { GroupView, Numbers } from '../../model/frame_view';
import type { GroundPoint } from '../../model/plane';

/** Margin around every point [m]. */
const kMargin = 1;
/** A view of a small crowd still spans this much, in a wide window and in a narrow one [m]. */
export const kSpanLeast = { wide: 20, narrow: 13 } as const;
/** Number of directions whose farthest point is remembered. */
const kDirections = 24;

export class BoundsBuilder {
  private readonly far_: GroundPoint[] = [];
  private readonly reach_ = new Float64Array(kDirections).fill(-Infinity);

  add(x: number, y: number): void {
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    for (let i = 0; i < kDirections; ++i) {
      const angle = (2 * Math.PI * i) / kDirections;
      const reach = x * Math.cos(angle) + y * Math.sin(angle);
      if (reach <= (this.reach_[i] ?? 0)) continue;
      this.reach_[i] = reach;
      this.far_[i] = { x: x + kMargin * Math.cos(angle), y: y + kMargin * Math.sin(angle) };
    }
  }

  /** x, y pairs. */
  addAll(points: Numbers): void {
    for (let i = 0; i + 1 < points.length; i += 2) this.add(points[i] ?? 0, points[i + 1] ?? 0);
  }

  /** Points whose outline holds all that was added; none where nothing was. */
  outline(span: number = kSpanLeast.wide): GroundPoint[] {
    if (this.far_.length === 0) return [];
    const points = [...this.far_];
    const xs = points.map((point) => point.x);
    const ys = points.map((point) => point.y);
    const middle = { x: (Math.min(...xs) + Math.max(...xs)) / 2, y: (Math.min(...ys) + Math.max(...ys)) / 2 };
    const half = span / 2;
    for (const [u, v] of [
      [-1, 0],
      [1, 0],
      [0, -1],
      [0, 1],
    ] as const) {
      points.push({ x: middle.x + u * half, y: middle.y + v * half });
    }
    return points;
  }
}

/** Points whose outline holds the crowd, its places, and the paths that lie ahead. */
export function crowdOutline(
  positions: Numbers,
  groups: readonly GroupView[],
  span: number = kSpanLeast.wide,
): GroundPoint[] {
  const bounds = new BoundsBuilder();
  bounds.addAll(positions);
  for (const group of groups) {
    bounds.addAll(group.places);
    for (const control of group.controls) for (const point of control.points) bounds.addAll(point.path);
  }
  return bounds.outline(span);
}
