// Lets one frame at a time through to the page; while the page is busy only the newest waits.

import type { StudioFrame } from './studio_frame';

/** A frame that was overtaken leaves behind what later frames do not repeat: ids and events. */
export function mergeStale(stale: StudioFrame, newer: StudioFrame): StudioFrame {
  const idsKept = newer.ids.length === 0 && stale.ids.length > 0;
  return {
    ...newer,
    ids: idsKept ? stale.ids : newer.ids,
    group: idsKept ? stale.group : newer.group,
    events: stale.events.length > 0 ? [...stale.events, ...newer.events] : newer.events,
  };
}

export class FrameGate {
  private waiting: { frame: StudioFrame; receivedAt: number } | null = null;
  private pageIsReady = true;
  /** Frames that the page never saw. */
  dropped = 0;

  constructor(private readonly deliver: (frame: StudioFrame, receivedAt: number) => void) {}

  offer(frame: StudioFrame, receivedAt: number): void {
    if (this.pageIsReady) {
      this.pageIsReady = false;
      this.deliver(frame, receivedAt);
      return;
    }
    if (this.waiting) this.dropped += 1;
    this.waiting = { frame: this.waiting ? mergeStale(this.waiting.frame, frame) : frame, receivedAt };
  }

  ready(): void {
    const next = this.waiting;
    this.waiting = null;
    this.pageIsReady = next === null;
    if (next) this.deliver(next.frame, next.receivedAt);
  }

  /** Forgets a frame of a connection that is gone. */
  reset(): void {
    this.waiting = null;
  }
}
