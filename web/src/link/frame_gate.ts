// Passes one frame at a time to the page. While the page is busy only the newest frame waits.

import type { StudioFrame } from '../model/studio_frame';

/** Merges a frame that was overtaken into the newer one, as later frames do not repeat ids and events. */
export function mergeStale(stale: StudioFrame, newer: StudioFrame): StudioFrame {
  const idsKept = newer.ids.length === 0 && stale.ids.length > 0;
  return {
    ...newer,
    ids: idsKept ? stale.ids : newer.ids,
    group: idsKept ? stale.group : newer.group,
    unitClass: idsKept ? stale.unitClass : newer.unitClass,
    radius: idsKept ? stale.radius : newer.radius,
    events: stale.events.length > 0 ? [...stale.events, ...newer.events] : newer.events,
  };
}

export class FrameGate {
  private waiting_: { frame: StudioFrame; receivedAt: number } | null = null;
  private pageIsReady_ = true;
  /** Frames that the page never saw. */
  dropped = 0;

  constructor(private readonly deliver_: (frame: StudioFrame, receivedAt: number) => void) {}

  offer(frame: StudioFrame, receivedAt: number): void {
    if (this.pageIsReady_) {
      this.pageIsReady_ = false;
      this.deliver_(frame, receivedAt);
      return;
    }
    if (this.waiting_) this.dropped += 1;
    this.waiting_ = { frame: this.waiting_ ? mergeStale(this.waiting_.frame, frame) : frame, receivedAt };
  }

  ready(): void {
    const next = this.waiting_;
    this.waiting_ = null;
    this.pageIsReady_ = next === null;
    if (next) this.deliver_(next.frame, next.receivedAt);
  }

  /** Forgets a frame of a connection that is gone. */
  reset(): void {
    this.waiting_ = null;
  }
}
