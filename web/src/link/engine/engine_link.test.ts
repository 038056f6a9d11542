import { beforeEach, expect, it, vi } from 'vitest';
import { EngineLink, type EnginePort } from './engine_link';
import type { FromEngine, ToEngine } from './engine_messages';

/** A worker that writes down what it is told. */
class Worker implements EnginePort {
  onmessage: ((event: MessageEvent<FromEngine>) => void) | null = null;
  readonly told: ToEngine[] = [];
  ended = false;
  postMessage(message: ToEngine): void {
    this.told.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  say(message: FromEngine): void {
    this.onmessage?.({ data: message } as MessageEvent<FromEngine>);
  }
}

let worker: Worker;
let others: Worker[] = [];
let problems: string[] = [];
let link: EngineLink;

beforeEach(() => {
  [worker, others, problems] = [new Worker(), [], []];
  const makeWorker = (): Worker => {
    others.push(new Worker());
    return others.at(-1)!;
  };
  link = new EngineLink(
    worker,
    { base: 'http://here/engine/', scenario: 'market', threads: 2 },
    makeWorker,
    (problem) => problems.push(problem),
  );
});

async function nextAsk(count: number): Promise<Extract<ToEngine, { kind: 'ask' }>> {
  await vi.waitFor(() => expect(worker.told.filter(({ kind }) => kind === 'ask')).toHaveLength(count));
  return worker.told.filter((one) => one.kind === 'ask').at(-1) as Extract<ToEngine, { kind: 'ask' }>;
}

function answer(id: number, text: string, status = 200): void {
  worker.say({ kind: 'answer', id, answer: { status, type: 'text/plain', bytes: new TextEncoder().encode(text) } });
}

it('starts the engine, and tells why it cannot run', () => {
  expect(worker.told[0]).toMatchObject({ kind: 'start', base: 'http://here/engine/', scenario: 'market', threads: 2 });
  worker.say({ kind: 'failed', problem: 'no WebAssembly' });
  expect(problems).toEqual(['no WebAssembly']);
});

it('answers each request with its own answer, in whatever order they come', async () => {
  const first = link.ask('takes');
  const one = await nextAsk(1);
  const second = link.ask('scenario?name=a', { method: 'POST', body: '{}' });
  const two = await nextAsk(2);
  expect([one.method, one.target]).toEqual(['GET', '/takes']);
  expect([two.method, two.target, new TextDecoder().decode(two.body)]).toEqual(['POST', '/scenario?name=a', '{}']);
  answer(two.id, 'second', 400);
  answer(one.id, 'first');
  expect(await (await first).text()).toBe('first');
  const refused = await second;
  expect([refused.ok, refused.status, await refused.text()]).toEqual([false, 400, 'second']);
});

it('makes exports in workers of their own, and ends them', async () => {
  const begun = link.ask('exports', { method: 'POST', body: '{"take":"a.take","format":"glb"}' });
  const asked = await nextAsk(1);
  expect(asked.target).toBe('/takes/a.take');
  answer(asked.id, 'MUSTAKE');
  expect(await (await begun).json()).toEqual({ number: '1' });
  const [maker] = others as [Worker];
  expect(maker.told[0]).toMatchObject({ kind: 'export', name: 'a.take' });
  maker.say({ kind: 'progress', share: 0.5 });
  expect(await (await link.ask('exports/1')).json()).toMatchObject({ state: 'running', share: 0.5 });
  expect((await link.ask('exports/1/file')).status).toBe(404);
  maker.say({ kind: 'exported', file: 'a.glb', bytes: new TextEncoder().encode('glTF') });
  expect(maker.ended).toBe(true);
  expect(await (await link.ask('exports/1')).json()).toMatchObject({ state: 'done', file: 'a.glb', bytes: 4 });
  expect(await (await link.ask('exports/1/file')).text()).toBe('glTF');
  await link.ask('exports/1', { method: 'DELETE' });
  expect((await link.ask('exports/1')).status).toBe(404);
});

it('hands on why an export fails', async () => {
  const gone = link.ask('exports', { method: 'POST', body: '{"take":"b.take"}' });
  answer((await nextAsk(1)).id, 'no take is called so', 404);
  expect((await gone).status).toBe(404);
  const begun = link.ask('exports', { method: 'POST', body: '{"take":"c.take"}' });
  answer((await nextAsk(2)).id, 'MUSTAKE');
  await begun;
  others[0]!.say({ kind: 'failed', problem: 'found no frames' });
  expect(await (await link.ask('exports/1')).json()).toMatchObject({ state: 'failed', problem: 'found no frames' });
});
