import { beforeEach, describe, expect, it } from 'vitest';
import { backoffMs } from './backoff';
import { Connection, type Socket, type Timers } from './connection';
import type { LinkState } from '../model/link_state';

class FakeSocket implements Socket {
  binaryType = '';
  onopen: ((event: never) => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: ((event: never) => void) | null = null;
  readonly sent: ArrayBuffer[] = [];
  closed = false;
  send(bytes: ArrayBuffer): void {
    this.sent.push(bytes);
  }
  close(): void {
    this.closed = true;
  }
}

class FakeTimers implements Timers {
  private time_ = 0;
  private next_ = 1;
  private readonly waiting_ = new Map<number, { at: number; action: () => void }>();
  now(): number {
    return this.time_;
  }
  after(ms: number, action: () => void): number {
    this.waiting_.set(this.next_, { at: this.time_ + ms, action });
    return this.next_++;
  }
  cancel(handle: number): void {
    this.waiting_.delete(handle);
  }
  advance(ms: number): void {
    const end = this.time_ + ms;
    for (;;) {
      const due = [...this.waiting_].filter(([, one]) => one.at <= end).sort((a, b) => a[1].at - b[1].at)[0];
      if (!due) break;
      this.waiting_.delete(due[0]);
      this.time_ = due[1].at;
      due[1].action();
    }
    this.time_ = end;
  }
}

let sockets: FakeSocket[];
let timers: FakeTimers;
let states: LinkState[];
let received: number;
let pings: number;
let connection: Connection;

function newest(): FakeSocket {
  return sockets[sockets.length - 1]!;
}

beforeEach(() => {
  sockets = [];
  states = [];
  received = 0;
  pings = 0;
  timers = new FakeTimers();
  const open = (): Socket => {
    sockets.push(new FakeSocket());
    return newest();
  };
  const handlers = {
    onBytes: () => (received += 1),
    onState: (state: LinkState) => states.push(state),
    ping: () => (pings += 1),
  };
  connection = new Connection(open, timers, handlers);
});

describe('backoffMs', () => {
  it('doubles up to five seconds', () => {
    expect([1, 2, 3, 4, 5, 60].map(backoffMs)).toEqual([500, 1000, 2000, 4000, 5000, 5000]);
  });
});

describe('Connection', () => {
  it('sends only while it is open', () => {
    connection.start();
    expect(connection.send(new ArrayBuffer(1))).toBe(false);
    newest().onopen!(undefined as never);
    expect(connection.send(new ArrayBuffer(1))).toBe(true);
    expect(newest().sent).toHaveLength(1);
    expect(states.map((state) => state.phase)).toEqual(['connecting', 'open']);
  });

  it('comes back with growing pauses, and starts small again after a success', () => {
    connection.start();
    newest().onclose!(undefined as never);
    expect(states[states.length - 1]).toEqual({ phase: 'lost', attempt: 1, retryAt: 500 });
    timers.advance(499);
    expect(sockets).toHaveLength(1);
    timers.advance(1);
    expect(sockets).toHaveLength(2);
    newest().onclose!(undefined as never);
    timers.advance(999);
    expect(sockets).toHaveLength(2);
    timers.advance(1);
    expect(sockets).toHaveLength(3);
    newest().onopen!(undefined as never);
    newest().onclose!(undefined as never);
    timers.advance(500);
    expect(sockets).toHaveLength(4);
  });

  it('tries at once when asked, and only once', () => {
    connection.start();
    newest().onclose!(undefined as never);
    connection.retryNow();
    expect(sockets).toHaveLength(2);
    connection.retryNow();
    timers.advance(500);
    expect(sockets).toHaveLength(2);
  });

  it('closes a connection that has been silent for long, but keeps one that answers pings', () => {
    connection.start();
    newest().onopen!(undefined as never);
    for (let i = 0; i < 10; ++i) {
      timers.advance(3000);
      newest().onmessage!({ data: new ArrayBuffer(1) });
    }
    expect(pings).toBe(10);
    expect(received).toBe(10);
    expect(newest().closed).toBe(false);
    const silent = newest();
    timers.advance(13000);
    expect(silent.closed).toBe(true);
    expect(states.some((state) => state.phase === 'lost')).toBe(true);
  });

  it('ignores what an old socket still says', () => {
    connection.start();
    const old = newest();
    old.onclose!(undefined as never);
    timers.advance(500);
    old.onmessage!({ data: new ArrayBuffer(1) });
    old.onclose!(undefined as never);
    expect(received).toBe(0);
    expect(sockets).toHaveLength(2);
  });
});
