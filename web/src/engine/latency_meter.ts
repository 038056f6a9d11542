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
  private inFrame: number[] = [];

  /** A touch event with this time was sent. */
  touched(time: number): void {
    this.waiting.push(time);
  }

  /** A frame arrived that shows all touches up to `echo`. */
  echoed(echo: number): void {
    if (this.waiting.length === 0 || echo <= 0) return;
    const shown = this.waiting.filter((time) => time <= echo);
    if (shown.length === 0) return;
    this.waiting = this.waiting.filter((time) => time > echo);
    this.inFrame.push(...shown);
  }

  /** Takes what the drawing that begins now will show. */
  takeDrawn(): number[] {
    const drawn = this.inFrame;
    this.inFrame = [];
    return drawn;
  }

  /** That drawing is done. */
  drawn(times: readonly number[], shown: number): void {
    for (const down of times) this.samples.push({ down, shown });
    if (this.samples.length > KEPT) this.samples.splice(0, this.samples.length - KEPT);
  }

  /** Touches that a lost connection or a pause will never show. */
  reset(): void {
    this.waiting = [];
    this.inFrame = [];
  }
}

/** Page clock [s]: since the epoch, finer than Date. */
export function pageClock(eventTime: number = performance.now()): number {
  return (performance.timeOrigin + eventTime) / 1000;
}
