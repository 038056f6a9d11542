// One WebSocket that comes back: opens, notices silence, and tries again with growing pauses.

import { backoffMs } from './backoff';
import type { LinkState } from './link_messages';

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
  /** Asks the other side for a sign of life. */
  ping(): void;
}

const PING_EVERY_MS = 3000;
const SILENCE_MS = 10000;

export class Connection {
  private socket: Socket | null = null;
  private isOpen = false;
  private attempt = 0;
  private lastHeard = 0;
  private timer: number | null = null;

  constructor(
    private readonly openSocket: () => Socket,
    private readonly timers: Timers,
    private readonly handlers: ConnectionHandlers,
  ) {}

  start(): void {
    this.stopTimer();
    this.handlers.onState({ phase: 'connecting' });
    const socket = this.openSocket();
    this.socket = socket;
    this.lastHeard = this.timers.now();
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened(socket);
    socket.onmessage = (event) => this.received(socket, event.data);
    socket.onclose = () => this.lost(socket);
    this.watch();
  }

  /** False where there is no open connection: the message is dropped. */
  send(bytes: ArrayBuffer): boolean {
    if (!this.isOpen || !this.socket) return false;
    this.socket.send(bytes);
    return true;
  }

  /** Tries now instead of at the end of the pause. */
  retryNow(): void {
    if (!this.isOpen && !this.socket) this.start();
  }

  private opened(socket: Socket): void {
    if (socket !== this.socket) return;
    this.isOpen = true;
    this.attempt = 0;
    this.lastHeard = this.timers.now();
    this.handlers.onState({ phase: 'open' });
  }

  private received(socket: Socket, data: unknown): void {
    if (socket !== this.socket || !(data instanceof ArrayBuffer)) return;
    this.lastHeard = this.timers.now();
    this.handlers.onBytes(data);
  }

  private lost(socket: Socket): void {
    if (socket !== this.socket) return;
    this.socket = null;
    this.isOpen = false;
    this.attempt += 1;
    const pause = backoffMs(this.attempt);
    this.handlers.onState({ phase: 'lost', attempt: this.attempt, retryAt: this.timers.now() + pause });
    this.stopTimer();
    this.timer = this.timers.after(pause, () => this.start());
  }

  /** A server that hangs closes nothing: after long silence we do. */
  private watch(): void {
    this.timer = this.timers.after(PING_EVERY_MS, () => {
      const socket = this.socket;
      if (!socket) return;
      if (this.timers.now() - this.lastHeard > SILENCE_MS) {
        socket.close();
        this.lost(socket);
        return;
      }
      if (this.isOpen) this.handlers.ping();
      this.watch();
    });
  }

  private stopTimer(): void {
    if (this.timer !== null) this.timers.cancel(this.timer);
    this.timer = null;
  }
}
