// The worker owns the connection: it decodes, acknowledges, and hands the newest frame to the page.

import { SUBPROTOCOL, decodeServer, encodeClient, type ClientMessage, type Frame } from '../protocol/messages';
import { problem } from '../protocol/problem';
import { Connection, type Socket, type Timers } from './connection';
import { FrameGate } from './frame_gate';
import { FrameUnpacker } from './frame_unpacker';
import type { FromWorker, ToWorker } from './link_messages';
import { buffersOf } from './studio_frame';

const timers: Timers = {
  now: () => Date.now(),
  after: (ms, action) => self.setTimeout(action, ms),
  cancel: (handle) => self.clearTimeout(handle),
};

function post(message: FromWorker): void {
  self.postMessage(message);
}

function epochMs(): number {
  return performance.timeOrigin + performance.now();
}

class LinkWorker {
  private url = '';
  private unpacker = new FrameUnpacker();
  private readonly gate = new FrameGate((frame, receivedAt) => {
    self.postMessage({ kind: 'frame', frame, receivedAt } satisfies FromWorker, { transfer: buffersOf(frame) });
  });
  private readonly connection = new Connection(
    () => new WebSocket(this.url, SUBPROTOCOL) as unknown as Socket,
    timers,
    {
      onBytes: (bytes) => this.receive(bytes),
      onState: (state) => {
        if (state.phase !== 'open') this.forget();
        if (state.phase === 'open') this.send({ type: 'Hello', name: 'Studio' });
        post({ kind: 'link', state });
      },
      ping: () => this.send({ type: 'Ping', time: epochMs() / 1000 }),
    },
  );

  handle(message: ToWorker): void {
    switch (message.kind) {
      case 'open':
        this.url = message.url;
        this.connection.start();
        break;
      case 'send':
        this.send(message.message);
        break;
      case 'ready':
        this.gate.ready();
        break;
      case 'retry':
        this.connection.retryNow();
        break;
    }
  }

  /** A new connection tells everything anew. */
  private forget(): void {
    this.gate.reset();
    this.unpacker = new FrameUnpacker();
  }

  private send(message: ClientMessage): void {
    this.connection.send(encodeClient(message));
  }

  private receive(bytes: ArrayBuffer): void {
    const receivedAt = epochMs();
    try {
      const message = decodeServer(bytes);
      if (message.type === 'Frame') return this.receiveFrame(message, receivedAt);
      if (message.type === 'Motions') this.unpacker.setMotions(message);
      if (message.type === 'GroupMesh') this.unpacker.setMesh(message);
      post({ kind: 'message', message });
    } catch (error) {
      const text = `The page could not read a message of the server: ${String(error)}`;
      post({ kind: 'message', message: problem('decode', text) });
    }
  }

  private receiveFrame(frame: Frame, receivedAt: number): void {
    this.send({ type: 'FrameAck', frame: frame.frame });
    this.gate.offer(this.unpacker.unpack(frame), receivedAt);
  }
}

const worker = new LinkWorker();
self.onmessage = (event: MessageEvent<ToWorker>) => worker.handle(event.data);
