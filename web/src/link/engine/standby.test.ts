import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { LinkState } from '../../model/link_state';
import { answerBy, hasEngine } from '../answers';
import type { EnginePort } from './engine_link';
import type { FromEngine, ToEngine } from './engine_messages';
import { pauseAfter, Standby } from './standby';

class Worker implements EnginePort {
  onmessage: ((event: MessageEvent<FromEngine>) => void) | null = null;
  readonly told: ToEngine[] = [];
  ended = false;
  /** The status of the answer to each request. */
  status = 200;
  postMessage(message: ToEngine): void {
    this.told.push(message);
    if (message.kind === 'prepare') queueMicrotask(() => this.say(this.reply));
    if (message.kind === 'ask') queueMicrotask(() => this.answer(message.id));
  }
  reply: FromEngine = { kind: 'prepared' };
  terminate(): void {
    this.ended = true;
  }
  say(message: FromEngine): void {
    this.onmessage?.({ data: message } as MessageEvent<FromEngine>);
  }
  private answer(id: number): void {
    const bytes = new TextEncoder().encode('a sentence\n');
    this.say({ kind: 'answer', id, answer: { status: this.status, type: 'text/plain', bytes } });
  }
}

/** A handover without a take. */
function handover(rest: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(33);
  bytes.set(new TextEncoder().encode('MUSTHAND'));
  bytes.set([1, 0, 0, 0, 6], 8);
  bytes.set([1], 28);
  bytes[32] = rest;
  return bytes;
}

let worker: Worker;
let asked: string[] = [];
let hidden = false;
let state: LinkState = { phase: 'open' };
let ports: MessagePort[] = [];
let standby: Standby;

beforeEach(() => {
  vi.useFakeTimers();
  [worker, asked, hidden, state, ports] = [new Worker(), [], false, { phase: 'open' }, []];
  standby = new Standby({
    client: {
      connectEngine: (port) => void ports.push(port),
      get state() {
        return state;
      },
    },
    base: 'http://here/engine/',
    makeWorker: () => worker,
    askServer: (path) => {
      asked.push(path);
      return Promise.resolve(new Response(handover(asked.length)));
    },
    hidden: () => hidden,
    failed: () => undefined,
  });
});

afterEach(() => {
  answerBy(null);
  vi.useRealTimers();
});

describe('the engine on standby', () => {
  it('keeps the world while the server is there and the page is seen', async () => {
    await standby.prepare();
    standby.keep();
    await vi.advanceTimersByTimeAsync(4500);
    expect(asked).toEqual(['handover?world=0&take=0', 'handover?world=6&take=0', 'handover?world=6&take=0']);
    hidden = true;
    await vi.advanceTimersByTimeAsync(9000);
    [hidden, state] = [false, { phase: 'lost', attempt: 1, retryAt: 0 }];
    await vi.advanceTimersByTimeAsync(9000);
    expect(asked).toHaveLength(3);
  });

  it('asks less often for larger worlds', () => {
    expect(pauseAfter(0)).toBe(2000);
    expect(pauseAfter(600_000)).toBe(4000);
    expect(pauseAfter(1e9)).toBe(30000);
  });

  it('goes on with the newest world before the page is connected', async () => {
    await standby.prepare();
    standby.keep();
    await vi.advanceTimersByTimeAsync(2500);
    await standby.goOn('');
    expect(worker.told.map(({ kind }) => kind)).toEqual(['prepare', 'start', 'ask']);
    const given = worker.told.at(-1) as Extract<ToEngine, { kind: 'ask' }>;
    expect([given.method, given.target]).toEqual(['POST', '/handover']);
    expect(given.body).toEqual(handover(2));
    expect(ports).toHaveLength(1);
    expect(hasEngine()).toBe(true);
    await vi.advanceTimersByTimeAsync(9000);
    expect(asked).toHaveLength(2);
  });

  it('begins with a scenario where it never saw a world', async () => {
    await standby.goOn('market');
    expect(worker.told.map(({ kind }) => kind)).toEqual(['prepare', 'start']);
    expect(worker.told[1]).toMatchObject({ scenario: 'market' });
    expect(ports).toHaveLength(1);
  });

  it('says why it cannot, and leaves the page as it is', async () => {
    worker.reply = { kind: 'failed', problem: 'no memory' };
    await expect(standby.prepare()).rejects.toThrow('no memory');
    expect(worker.ended).toBe(true);
    worker.reply = { kind: 'prepared' };
    await standby.prepare();
    standby.keep();
    await vi.advanceTimersByTimeAsync(100);
    worker.status = 400;
    await expect(standby.goOn('')).rejects.toThrow('a sentence');
    expect(ports).toEqual([]);
    expect(hasEngine()).toBe(false);
    expect(worker.ended).toBe(true);
    const before = asked.length;
    await vi.advanceTimersByTimeAsync(2500);
    expect(asked.length).toBeGreaterThan(before);
    worker.status = 200;
    await standby.goOn('');
    expect(worker.told.map(({ kind }) => kind).slice(-3)).toEqual(['prepare', 'start', 'ask']);
    expect(ports).toHaveLength(1);
  });
});
