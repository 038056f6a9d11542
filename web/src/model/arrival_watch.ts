// Notices groups that have arrived, and how long they were on the way.

import { EventKind, Standing, type EventFrame } from '../protocol/messages';
import type { Standings } from './standing';

interface WatchedFrame {
  readonly time: number;
  readonly events: readonly EventFrame[];
  readonly groups: readonly {
    readonly id: number;
    readonly standings: Standings;
    readonly x: number;
    readonly y: number;
  }[];
}

export interface Arrival {
  readonly id: number;
  readonly index: number;
  /** On the way [s]. */
  readonly seconds: number;
  /** Where its formation is [m]. */
  readonly x: number;
  readonly y: number;
}

export class ArrivalWatch {
  /** World time at which groups set out, by ids [s]. */
  private readonly since_ = new Map<number, number>();

  /** Groups that are in place as a whole since this frame. */
  observe({ time, events, groups }: WatchedFrame): readonly Arrival[] {
    const arrivals: Arrival[] = [];
    groups.forEach(({ id, standings, x, y }, index) => {
      const since = this.since_.get(id);
      const whole = Array.from(standings).every((count, k) => count === 0 || k === Number(Standing.InPlace));
      if (whole && events.some(({ kind, subject }) => kind === EventKind.Arrived && subject === id))
        arrivals.push({ id, index, seconds: since === undefined ? 0 : time - since, x, y });
      if (whole || (since !== undefined && since > time)) this.since_.delete(id);
      else if (since === undefined && (standings[Standing.OnTheWay] ?? 0) > 0) this.since_.set(id, time);
    });
    return arrivals;
  }

  /** Another world. */
  clear(): void {
    this.since_.clear();
  }
}
