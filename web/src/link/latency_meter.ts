// Measures the time from a finger's event to the first picture that shows its effect.

import { pageClock } from '../model/page_clock';

export interface LatencySample {
  /** Page clock [s]. */
  readonly down: number;
  /** The first server frame that shows the touch arrived; page clock [s]. */
  readonly received: number;
  /** A picture of it was drawn; page clock [s]. */
  readonly shown: number;
}

/** A touch whose effect has arrived. */
export interface ArrivedTouch {
  readonly down: number;
  readonly received: number;
  /** The server frame that first showed it. */
  readonly frame: number;
}

const kKept = 2000;

export class LatencyMeter {
  readonly samples: LatencySample[] = [];
  private waiting_: number[] = [];
  private arrived_: ArrivedTouch[] = [];

  /** A touch event with this time was sent. */
  touched(time: number): void {
    this.waiting_.push(time);
  }

  /** A server frame arrived at `received` that shows all touches up to `echo`. */
  echoed(echo: number, frame: number, received: number): void {
    if (this.waiting_.length === 0 || echo <= 0) return;
    for (const down of this.waiting_) if (down <= echo) this.arrived_.push({ down, received, frame });
    this.waiting_ = this.waiting_.filter((time) => time > echo);
  }

  /** Removes and returns the touches that a picture of the server's frames up to `frame` shows. */
  takeDrawn(frame: number): ArrivedTouch[] {
    const drawn = this.arrived_.filter((one) => one.frame <= frame);
    if (drawn.length > 0) this.arrived_ = this.arrived_.filter((one) => one.frame > frame);
    return drawn;
  }

  /** Records when the picture of these touches was done. */
  drawn(touches: readonly ArrivedTouch[], shown: number): void {
    for (const { down, received } of touches) this.samples.push({ down, received, shown });
    if (this.samples.length > kKept) this.samples.splice(0, this.samples.length - kKept);
  }

  /** Forgets the touches that wait; a lost connection or a new scene never shows them. */
  reset(): void {
    this.waiting_ = [];
    this.arrived_ = [];
  }
}

/** Times the touches whose effect the picture shows that is being drawn. */
export function timePicture(latency: LatencyMeter, shownFrame: number): void {
  const shown = latency.takeDrawn(shownFrame);
  if (shown.length === 0) return;
  // The task after this one: the scene has been drawn by then.
  const after = new MessageChannel();
  after.port1.onmessage = () => latency.drawn(shown, pageClock());
  after.port2.postMessage(null);
}
