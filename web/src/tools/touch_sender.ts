// Sends touches: downs and lifts at once, moves at once unless the last were sent less than 8 ms ago.

import { TouchPhase, type TouchEvent } from '../protocol/messages';
import type { MessageSender } from '../link/studio_client';
import type { GroundPoint } from '../model/plane';

/** Least time between two messages with moves [ms]; queued moves are sent with the next picture. */
const kSpacing = 8;

export class TouchSender {
  private queue_: TouchEvent[] = [];
  private lastTouch_ = 0;
  private lastSent_ = -Infinity;

  /** `sent` hears the time of every event that leaves, for the measurement of latency; `now` in [ms]. */
  constructor(
    private readonly client_: MessageSender,
    private readonly sent_: (time: number) => void = () => undefined,
    private readonly now_: () => number = () => performance.now(),
  ) {}

  /** A number that no finger of this page has had. */
  nextTouch(): number {
    this.lastTouch_ += 1;
    return this.lastTouch_;
  }

  down(touch: number, at: GroundPoint, time: number, group: number): void {
    this.push(TouchPhase.Down, touch, at, time, group);
    this.flush();
  }

  /** Queues a move for `moved()` or `flush()`. */
  move(touch: number, at: GroundPoint, time: number): void {
    this.push(TouchPhase.Move, touch, at, time, 0);
  }

  /** All moves of one event are queued: sends them unless others were sent just before. */
  moved(): void {
    if (this.now_() - this.lastSent_ >= kSpacing) this.flush();
  }

  up(touch: number, at: GroundPoint, time: number): void {
    this.push(TouchPhase.Up, touch, at, time, 0);
    this.flush();
  }

  cancel(touch: number, at: GroundPoint, time: number): void {
    this.push(TouchPhase.Cancel, touch, at, time, 0);
    this.flush();
  }

  /** Sends the queue. */
  flush(): void {
    if (this.queue_.length === 0) return;
    const events = this.queue_;
    this.queue_ = [];
    this.lastSent_ = this.now_();
    this.client_.send({ type: 'Touches', events });
    for (const event of events) if (event.phase <= TouchPhase.Move) this.sent_(event.time);
  }

  private push(phase: TouchPhase, touch: number, at: GroundPoint, time: number, group: number): void {
    this.queue_.push({ phase, touch, x: at.x, y: at.y, time, group });
  }
}
