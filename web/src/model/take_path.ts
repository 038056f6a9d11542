// The path of somebody in the open take, and how it bends where it is pulled.

import { distanceToSegment, type GroundPoint, type ScreenPoint } from './plane';

export interface TakeWay {
  /** One point per `spacing` steps, from the beginning of the take [m]. */
  readonly points: readonly GroundPoint[];
  readonly spacing: number;
  /** [s] */
  readonly stepTime: number;
}

/** Where somebody has taken hold of a path, and how far it has been pulled. */
export interface PathPull {
  /** Index of the point. */
  readonly at: number;
  readonly dx: number;
  readonly dy: number;
}

/** How far a bend reaches before and after its moment [s]. */
export const kLeastReach = 0.5;
export const kMostReach = 60;

/** x, y after x, y. */
export function wayOf(points: ArrayLike<number>, spacing: number, stepTime: number): TakeWay {
  const made = Array.from({ length: Math.floor(points.length / 2) }, (_, k) => ({
    x: points[2 * k]!,
    y: points[2 * k + 1]!,
  }));
  return { points: made, spacing, stepTime };
}

/** As bendWeight() of the server: 1 at the moment, 0 from `reach` on, smooth between. */
export function bendWeight(after: number, reach: number): number {
  const share = Math.abs(after) / reach;
  return share >= 1 ? 0 : (1 - share * share) ** 2;
}

/** The path as it will be wished. */
export function bent({ points, spacing, stepTime }: TakeWay, { at, dx, dy }: PathPull, reach: number): GroundPoint[] {
  return points.map(({ x, y }, k) => {
    const weight = bendWeight((k - at) * spacing * stepTime, reach);
    return { x: x + dx * weight, y: y + dy * weight };
  });
}

/** The point that is shown at a step. */
export function pointAt({ points, spacing }: TakeWay, step: number): number {
  return Math.max(0, Math.min(points.length - 1, Math.round(step / spacing)));
}

/**
 * The point that a finger at `at` takes hold of: of the piece of path nearest to it, within `px` on the screen, the
 * nearer end; -1 for none. Where somebody stands long, many points lie in one spot: then that of `step` is taken, or
 * the next to it.
 */
export function grabbed(
  way: TakeWay,
  at: ScreenPoint,
  toScreen: (point: GroundPoint) => ScreenPoint,
  px: number,
  step: number,
): number {
  const screen = way.points.map(toScreen);
  const now = pointAt(way, step);
  let best = -1;
  let least = px;
  screen.forEach((point, k) => {
    const away = Math.hypot(point.x - at.x, point.y - at.y);
    const tie = best >= 0 && Math.abs(away - least) < 2 && Math.abs(k - now) < Math.abs(best - now);
    if (away > px || (away >= least && !tie)) return;
    least = Math.min(away, least);
    best = k;
  });
  if (best >= 0) return best;
  for (let k = 0; k + 1 < screen.length; ++k) {
    const [a, b] = [screen[k]!, screen[k + 1]!];
    const away = distanceToSegment(at, a, b);
    if (away >= least) continue;
    least = away;
    best = Math.hypot(a.x - at.x, a.y - at.y) < Math.hypot(b.x - at.x, b.y - at.y) ? k : k + 1;
  }
  return best;
}

/** Points that get their time written beside them: whole seconds, so far apart that they can be read. */
export function timesBeside(way: TakeWay, screen: readonly ScreenPoint[], px: number): number[] {
  const chosen: number[] = [];
  let last: ScreenPoint | null = null;
  screen.forEach((point, k) => {
    const seconds = k * way.spacing * way.stepTime;
    if (Math.abs(seconds - Math.round(seconds)) > 1e-6) return;
    if (last && Math.hypot(point.x - last.x, point.y - last.y) < px) return;
    chosen.push(k);
    last = point;
  });
  return chosen;
}
