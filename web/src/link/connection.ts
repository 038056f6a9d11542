// Keeps one WebSocket open: it notices a silent server and reconnects after growing pauses.

import { backoffMs } from './backoff';
import type { LinkState } from '../model/link_state';

/** What a connection needs of a WebSocket. */
export interface Socket {
  binaryType: string;
  onopen: ((event: never) => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: never) => void) | null;
  send(bytes: ArrayBuffer): void;
  close(): void;
}

/** Time, replaceable in tests. */
export interface Timers {
  now(): number;
  after(ms: number, action: () => void): number;
  cancel(handle: number): void;
}

export interface ConnectionHandlers {
  onBytes(bytes: ArrayBuffer): void;
  onState(state: LinkState): void;
  /** Sends a ping. */
  ping(): void;
}

const kPingEveryMs = 3000;
const kSilenceMs = 10000;

export class Connection {
  private socket_: Socket | null = null;
  private isOpen_ = false;
  private attempt_ = 0;
  private lastHeard_ = 0;
  private timer_: number | null = null;

  constructor(
    private readonly openSocket_: () => Socket,
    private readonly timers_: Timers,
    private readonly handlers_: ConnectionHandlers,
  ) {}

  /** Opens a socket; one that is there is closed. */
  start(): void {
    this.stopTimer();
    const before = this.socket_;
    this.socket_ = null;
    this.isOpen_ = false;
    before?.close();
    this.handlers_.onState({ phase: 'connecting' });
    const socket = this.openSocket_();
    this.socket_ = socket;
    this.lastHeard_ = this.timers_.now();
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened(socket);
    socket.onmessage = (event) => this.received(socket, event.data);
    socket.onclose = () => this.lost(socket);
    this.watch();
  }

  /** False where there is no open connection: the message is dropped. */
  send(bytes: ArrayBuffer): boolean {
    if (!this.isOpen_ || !this.socket_) return false;
    this.socket_.send(bytes);
    return true;
  }

  /** Tries now instead of at the end of the pause. */
  retryNow(): void {
    if (!this.isOpen_ && !this.socket_) this.start();
  }

  private opened(socket: Socket): void {
    if (socket !== this.socket_) return;
    this.isOpen_ = true;
    this.attempt_ = 0;
    this.lastHeard_ = this.timers_.now();
    this.handlers_.onState({ phase: 'open' });
  }

  private received(socket: Socket, data: unknown): void {
    if (socket !== this.socket_ || !(data instanceof ArrayBuffer)) return;
    this.lastHeard_ = this.timers_.now();
    this.handlers_.onBytes(data);
  }

  private lost(socket: Socket): void {
    if (socket !== this.socket_) return;
    this.socket_ = null;
    this.isOpen_ = false;
    this.attempt_ += 1;
    const pause = backoffMs(this.attempt_);
    this.handlers_.onState({ phase: 'lost', attempt: this.attempt_, retryAt: this.timers_.now() + pause });
    this.stopTimer();
    this.timer_ = this.timers_.after(pause, () => this.start());
  }

  /** A server that hangs does not close its socket, so a long silence closes it here. */
  private watch(): void {
    this.timer_ = this.timers_.after(kPingEveryMs, () => {
      const socket = this.socket_;
      if (!socket) return;
      if (this.timers_.now() - this.lastHeard_ > kSilenceMs) {
        socket.close();
        this.lost(socket);
        return;
      }
      if (this.isOpen_) this.handlers_.ping();
      this.watch();
    });
  }

  private stopTimer(): void {
    if (this.timer_ !== null) this.timers_.cancel(this.timer_);
    this.timer_ = null;
  }
}
