// From a finger's event to the first drawn frame that shows it.

export interface LatencySample {
  /** Page clock [s]. */
  readonly down: number;
  /** Page clock [s]. */
  readonly shown: number;
}

const KEPT = 2000;

export class LatencyMeter {
  readonly samples: LatencySample[] = [];
  private waiting: number[] = [];
  /** Touches by the server frame that first showed their effect. */
  private arrived: { readonly time: number; readonly frame: number }[] = [];

  /** A touch event with this time was sent. */
  touched(time: number): void {
    this.waiting.push(time);
  }

  /** A server frame arrived that shows all touches up to `echo`. */
  echoed(echo: number, frame: number): void {
    if (this.waiting.length === 0 || echo <= 0) return;
    for (const time of this.waiting) if (time <= echo) this.arrived.push({ time, frame });
    this.waiting = this.waiting.filter((time) => time > echo);
  }

  /** Takes the touches that a picture made of server frames up to `frame` shows. */
  takeDrawn(frame: number): number[] {
    const drawn = this.arrived.filter((one) => one.frame <= frame).map((one) => one.time);
    if (drawn.length > 0) this.arrived = this.arrived.filter((one) => one.frame > frame);
    return drawn;
  }

  /** That picture is done. */
  drawn(times: readonly number[], shown: number): void {
    for (const down of times) this.samples.push({ down, shown });
    if (this.samples.length > KEPT) this.samples.splice(0, this.samples.length - KEPT);
  }

  /** Touches that a lost connection or a new scene will never show. */
  reset(): void {
    this.waiting = [];
    this.arrived = [];
  }
}

/** Page clock [s]: since the epoch, finer than Date. */
export function pageClock(eventTime: number = performance.now()): number {
  return (performance.timeOrigin + eventTime) / 1000;
}
