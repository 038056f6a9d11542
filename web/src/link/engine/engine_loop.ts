// Lets the engine's time pass as the page's does, and carries messages to and from one client.

import type { Engine } from 'muster-engine/studio';
import type { SocketMessage } from './engine_messages';

/** Waits shorter than this are none [s]. */
const kAtOnce = 0.001;

/** Time, replaceable in tests. */
export interface LoopTimers {
  /** [ms] */
  now(): number;
  after(ms: number, action: () => void): number;
  cancel(handle: number): void;
  /** As soon as what waits has been handled. */
  soon(action: () => void): void;
}

export class EngineLoop {
  private client_ = 0;
  private last_ = 0;
  private timer_ = 0;
  private soon_ = false;

  constructor(
    private readonly engine_: Pick<Engine, 'advance' | 'connect' | 'disconnect' | 'outgoing' | 'receive'>,
    private readonly port_: Pick<MessagePort, 'postMessage'>,
    private readonly timers_: LoopTimers,
  ) {}

  handle(message: SocketMessage): void {
    if (message.kind === 'bytes') return this.receive(message.bytes);
    if (this.client_ !== 0) this.engine_.disconnect(this.client_);
    this.client_ = 0;
    if (message.kind === 'close') return this.timers_.cancel(this.timer_);
    this.client_ = this.engine_.connect();
    this.last_ = this.timers_.now();
    this.post({ kind: 'open' });
    this.step();
  }

  /** Something has changed without a message: a request was answered. */
  wake(): void {
    if (this.client_ !== 0) this.step();
  }

  private receive(bytes: ArrayBuffer): void {
    if (this.client_ === 0) return;
    this.engine_.receive(this.client_, new Uint8Array(bytes));
    this.step();
  }

  /** The world stands still while nobody is connected. */
  private step(): void {
    if (this.client_ === 0) return;
    const now = this.timers_.now();
    const wait = this.engine_.advance((now - this.last_) / 1000);
    this.last_ = now;
    for (const bytes of this.engine_.outgoing(this.client_)) this.post({ kind: 'bytes', bytes }, [bytes]);
    this.plan(wait);
  }

  private plan(wait: number): void {
    this.timers_.cancel(this.timer_);
    if (wait >= kAtOnce) {
      this.timer_ = this.timers_.after(1000 * wait, () => this.step());
      return;
    }
    if (this.soon_) return;
    this.soon_ = true;
    this.timers_.soon(() => {
      this.soon_ = false;
      this.step();
    });
  }

  private post(message: SocketMessage, transfer: Transferable[] = []): void {
    this.port_.postMessage(message, transfer);
  }
}
