import { describe, expect, it } from 'vitest';
import type { Welcome } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import type { FromWorker, ToWorker } from './link_messages';
import { StudioClient, type WorkerPort } from './studio_client';

class FakeWorker implements WorkerPort {
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null = null;
  readonly posted: ToWorker[] = [];
  postMessage(message: ToWorker): void {
    this.posted.push(message);
  }
  say(message: FromWorker): void {
    this.onmessage!({ data: message } as MessageEvent<FromWorker>);
  }
}

describe('StudioClient', () => {
  it('asks for the next frame with each one and translates its time', () => {
    const worker = new FakeWorker();
    const client = new StudioClient(worker, 1000);
    const times: number[] = [];
    client.on('frame', ({ receivedAt }) => times.push(receivedAt));
    worker.say({ kind: 'frame', frame: { type: 'Frame' } as StudioFrame, receivedAt: 1250 });
    expect(times).toEqual([250]);
    expect(worker.posted).toEqual([{ kind: 'ready' }]);
  });
  it('learns its number from the welcome and ends subscriptions', () => {
    const worker = new FakeWorker();
    const client = new StudioClient(worker, 0);
    let welcomes = 0;
    const end = client.on('welcome', () => (welcomes += 1));
    const message: Welcome = { type: 'Welcome', client: 3, version: '1', scenarios: [], schemes: [] };
    worker.say({ kind: 'message', message });
    end();
    worker.say({ kind: 'message', message });
    expect(client.clientId).toBe(3);
    expect(welcomes).toBe(1);
  });
  it('hands messages to the worker', () => {
    const worker = new FakeWorker();
    const client = new StudioClient(worker, 0);
    client.connect('ws://here/ws');
    client.send({ type: 'Record', on: true });
    client.retry();
    expect(worker.posted.map((message) => message.kind)).toEqual(['open', 'send', 'retry']);
  });
});
