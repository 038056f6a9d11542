import { beforeEach, describe, expect, it } from 'vitest';
import { EngineLoop } from './engine_loop';
import type { SocketMessage } from './engine_messages';

let time = 0;
let wait = 0.25;
let calls: string[] = [];
let sent: SocketMessage[] = [];
let planned: { at: number; action: () => void; handle: number }[] = [];
let soon: (() => void)[] = [];
let waiting: ArrayBuffer[] = [];
let clients = 0;
let loop: EngineLoop;

beforeEach(() => {
  [time, wait, calls, sent, planned, soon, waiting, clients] = [1000, 0.25, [], [], [], [], [], 0];
  const engine = {
    advance: (seconds: number) => (calls.push(`advance ${seconds.toFixed(3)}`), wait),
    connect: () => (calls.push('connect'), ++clients),
    disconnect: (client: number) => void calls.push(`disconnect ${client}`),
    receive: (client: number, bytes: Uint8Array) => void calls.push(`receive ${client}: ${bytes.join()}`),
    outgoing: () => waiting.splice(0),
  };
  let handles = 0;
  const timers = {
    now: () => time,
    after: (ms: number, action: () => void) => (planned.push({ at: time + ms, action, handle: ++handles }), handles),
    cancel: (handle: number) => void (planned = planned.filter((one) => one.handle !== handle)),
    soon: (action: () => void) => void soon.push(action),
  };
  const port = { postMessage: (message: SocketMessage) => void sent.push(message) };
  loop = new EngineLoop(engine, port, timers);
});

/** Lets the time come to the next planned call. */
function run(): void {
  const next = planned.shift()!;
  time = next.at;
  next.action();
}

describe("the engine's loop", () => {
  it('stands still until somebody is connected, and after they have gone', () => {
    loop.wake();
    loop.handle({ kind: 'bytes', bytes: new ArrayBuffer(1) });
    expect(calls).toEqual([]);
    loop.handle({ kind: 'open' });
    expect(calls).toEqual(['connect', 'advance 0.000']);
    expect(sent).toEqual([{ kind: 'open' }]);
    loop.handle({ kind: 'close' });
    expect(planned).toEqual([]);
    time += 5000;
    loop.handle({ kind: 'open' });
    expect(calls.slice(2)).toEqual(['disconnect 1', 'connect', 'advance 0.000']);
  });

  it('lets as much time pass as has passed, when the engine wants it', () => {
    loop.handle({ kind: 'open' });
    expect(planned.map(({ at }) => at)).toEqual([1250]);
    run();
    expect(calls.at(-1)).toBe('advance 0.250');
    time += 10;
    loop.handle({ kind: 'bytes', bytes: Uint8Array.of(7, 8).buffer });
    expect(calls.slice(-2)).toEqual(['receive 1: 7,8', 'advance 0.010']);
    expect(planned).toHaveLength(1);
  });

  it('goes on at once where work is due, but never twice at a time', () => {
    wait = 0;
    loop.handle({ kind: 'open' });
    loop.wake();
    expect(soon).toHaveLength(1);
    wait = 0.01;
    soon.shift()!();
    expect(soon).toEqual([]);
    expect(planned).toHaveLength(1);
  });

  it('sends what there is for the client', () => {
    waiting = [Uint8Array.of(1).buffer, Uint8Array.of(2, 3).buffer];
    loop.handle({ kind: 'open' });
    expect(sent.map(({ kind }) => kind)).toEqual(['open', 'bytes', 'bytes']);
  });
});
