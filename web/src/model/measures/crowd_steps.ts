// Follows the crowd from frame to frame: where each person went, who left, how fast each is, and whether time leapt.

import type { Numbers } from '../frame_view';
import type { GroundPoint } from '../plane';

/** What a frame tells of people. */
export interface CrowdMoment {
  readonly time: number;
  readonly ids: Numbers;
  readonly x: Numbers;
  readonly y: Numbers;
}

/** Who left the world on the way to this moment, and where. */
export interface Leaver {
  readonly id: number;
  readonly at: GroundPoint;
}

export interface Move {
  readonly id: number;
  readonly from: GroundPoint;
  readonly to: GroundPoint;
}

/** Speeds are those over this time, half of it before and half after [s]. */
export const kSpeedTime = 0.5;

/** By that much x differs from one side of a ring to the other; 0 where there is none [m]. */
function unwrapped(from: number, to: number, ring: number): number {
  if (ring <= 0) return to;
  return to - ring * Math.round((to - from) / ring);
}

/** Indices by id, where the persons of two moments are not the same. */
function indicesOf(ids: Numbers): Map<number, number> {
  const found = new Map<number, number>();
  for (let i = 0; i < ids.length; ++i) found.set(ids[i]!, i);
  return found;
}

/** The moves of everybody from one moment to the next. Who walks over the seam of a ring makes two moves that are the same:
 * one that leaves the box on one side, one that comes into it on the other. */
export function movesBetween(before: CrowdMoment, now: CrowdMoment, leavers: readonly Leaver[] = [], ring = 0): Move[] {
  const moves: Move[] = [];
  const known = before.ids === now.ids ? null : indicesOf(before.ids);
  const add = (id: number, j: number, at: GroundPoint): void => {
    const from = { x: before.x[j]!, y: before.y[j]! };
    const to = { x: unwrapped(from.x, at.x, ring), y: at.y };
    const seam = at.x - to.x;
    if (from.x === to.x && from.y === to.y) return;
    moves.push({ id, from, to });
    if (seam !== 0) moves.push({ id, from: { x: from.x + seam, y: from.y }, to: at });
  };
  for (let i = 0; i < now.ids.length; ++i) {
    const j = known ? known.get(now.ids[i]!) : i;
    if (j !== undefined) add(now.ids[i]!, j, { x: now.x[i]!, y: now.y[i]! });
  }
  for (const { id, at } of leavers) {
    const j = known?.get(id);
    if (j !== undefined) add(id, j, at);
  }
  return moves;
}

/** The last moments, so that speeds can be told from both sides. */
export class SpeedMemory {
  private moments_: CrowdMoment[] = [];

  add(moment: CrowdMoment): void {
    this.moments_.push(moment);
    // One that is old enough is needed, older ones are not.
    while (this.moments_.length > 2 && this.moments_[1]!.time <= moment.time - kSpeedTime + 1e-6) this.moments_.shift();
  }

  clear(): void {
    this.moments_ = [];
  }

  /** The moment in the middle, for which there are moments before and after; null at first. */
  middle(): { readonly at: CrowdMoment; speed(index: number, ring: number): number } | null {
    const { moments_: all } = this;
    const [first, last] = [all[0], all[all.length - 1]];
    if (!first || !last || all.length < 3 || last.time - first.time < kSpeedTime - 1e-3) return null;
    const wished = (first.time + last.time) / 2;
    const inner = all.slice(1, -1);
    const at = inner.reduce((a, b) => (Math.abs(b.time - wished) < Math.abs(a.time - wished) ? b : a));
    const [old, fresh] = [first, last].map((one) => (one.ids === at.ids ? null : indicesOf(one.ids)));
    const spot = (one: CrowdMoment, map: Map<number, number> | null, i: number): number =>
      map ? (map.get(at.ids[i]!) ?? -1) : i < one.x.length ? i : -1;
    const speed = (i: number, ring: number): number => {
      const [a, b] = [spot(first, old!, i), spot(last, fresh!, i)];
      // Who has just come, or leaves, is measured on one side.
      const [from, k] = a >= 0 ? [first, a] : [at, i];
      const [to, n] = b >= 0 ? [last, b] : [at, i];
      const seconds = to.time - from.time;
      if (seconds <= 0) return NaN;
      const dx = unwrapped(from.x[k]!, to.x[n]!, ring) - from.x[k]!;
      return Math.hypot(dx, to.y[n]! - from.y[k]!) / seconds;
    };
    return { at, speed };
  }
}
