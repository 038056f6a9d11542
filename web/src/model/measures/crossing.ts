// Who crosses a line: the definition of PedPy and of `muster measure` (docs/people.md, Measures).

import type { GroundPoint } from '../plane';

export interface MeasureLine {
  readonly a: GroundPoint;
  readonly b: GroundPoint;
}

export interface Crossing {
  /** By linear interpolation between two frames [s]. */
  readonly time: number;
  /** Id of the person. */
  readonly person: number;
  /** 1: to the right of the line as seen from `a` to `b`; -1: to its left. */
  readonly direction: 1 | -1;
}

function cross(a: GroundPoint, b: GroundPoint, p: GroundPoint): number {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/** The share of the way from `p` to `q` at which it crosses, and where to; null where it does not. A movement that ends on the
 * line does not cross it, one that begins on it does. */
export function crossingOf(
  { a, b }: MeasureLine,
  p: GroundPoint,
  q: GroundPoint,
): { readonly share: number; readonly direction: 1 | -1 } | null {
  const from = cross(a, b, p);
  const to = cross(a, b, q);
  if (to === 0 || (from > 0 && to > 0) || (from < 0 && to < 0)) return null;
  const share = Math.abs(from / (from - to));
  const [x, y] = [p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)];
  const along = (x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y);
  const length2 = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;
  return along >= 0 && along <= length2 ? { share, direction: to < 0 ? 1 : -1 } : null;
}

/** Numbers of crossings, and flows of those within a time. */
export interface LineFigures {
  /** Persons who have crossed at least once. */
  readonly persons: number;
  /** Crossings in direction 1, and in the other one. */
  readonly right: number;
  readonly left: number;
  /** Crossings of the last `window` seconds, each way [1/s]. */
  readonly rightFlow: number;
  readonly leftFlow: number;
  /** (N - 1) / (t_N - t_1) over first crossings of the persons [1/s]; NaN before the second one. */
  readonly meanFlow: number;
}

/** What a line has counted. Crossings come in the order of their times. */
export class LineRecord {
  crossings: Crossing[] = [];
  private seen_ = new Set<number>();
  private firsts_: number[] = [];
  /** How many of the first k crossings were to the right, for each k. */
  private rights_: number[] = [0];

  add(found: readonly Crossing[]): void {
    const sorted = [...found].sort((a, b) => a.time - b.time || a.person - b.person);
    for (const one of sorted) {
      this.rights_.push(this.rights_[this.crossings.length]! + (one.direction > 0 ? 1 : 0));
      this.crossings.push(one);
      if (this.seen_.has(one.person)) continue;
      this.seen_.add(one.person);
      this.firsts_.push(one.time);
    }
  }

  /** Forgets what came later. */
  cut(time: number): void {
    const kept = this.crossings.filter((one) => one.time <= time);
    this.crossings = [];
    this.seen_ = new Set();
    this.firsts_ = [];
    this.rights_ = [0];
    this.add(kept);
  }

  /** Crossings up to that time, each way. */
  until(time: number): { readonly right: number; readonly left: number } {
    let [low, high] = [0, this.crossings.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.crossings[middle]!.time <= time) low = middle + 1;
      else high = middle;
    }
    const right = this.rights_[low]!;
    return { right, left: low - right };
  }

  /** Flows of the `window` seconds before `time`, of which those since `since` count [1/s]. */
  flowAt(time: number, window: number, since: number): { readonly right: number; readonly left: number } {
    const seconds = Math.min(window, time - since);
    if (seconds <= 0) return { right: 0, left: 0 };
    const [now, before] = [this.until(time), this.until(time - seconds)];
    return { right: (now.right - before.right) / seconds, left: (now.left - before.left) / seconds };
  }

  figures(time: number, window: number, since: number): LineFigures {
    const { right: rightFlow, left: leftFlow } = this.flowAt(time, window, since);
    const [first, last] = [this.firsts_[0], this.firsts_[this.firsts_.length - 1]];
    const persons = this.firsts_.length;
    const passed = (last ?? NaN) - (first ?? NaN);
    const meanFlow = persons > 1 && passed > 0 ? (persons - 1) / passed : NaN;
    return { persons, ...this.until(Infinity), rightFlow, leftFlow, meanFlow };
  }
}
