// The worker owns the connection: it decodes, acknowledges, and hands the newest frame to the page.

import { decodeServer, encodeClient } from '../protocol/encoding';
import { SUBPROTOCOL, type ClientMessage, type Frame } from '../protocol/messages';
import { problem } from '../protocol/problem';
import { Connection, type Socket, type Timers } from './connection';
import { PortSocket } from './engine/port_socket';
import { FrameGate } from './frame_gate';
import { FrameUnpacker } from './frame_unpacker';
import type { FromWorker, ToWorker } from './link_messages';
import { buffersOf } from '../model/studio_frame';

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
  /** Where to connect: to a server's address, or to the engine by a port. */
  private peer_: string | MessagePort = '';
  private unpacker_ = new FrameUnpacker();
  private readonly gate_ = new FrameGate((frame, receivedAt) => {
    self.postMessage({ kind: 'frame', frame, receivedAt } satisfies FromWorker, { transfer: buffersOf(frame) });
  });
  private readonly connection_ = new Connection(() => this.openSocket(), timers, {
    onBytes: (bytes) => this.receive(bytes),
    onState: (state) => {
      if (state.phase !== 'open') this.forget();
      if (state.phase === 'open') this.send({ type: 'Hello', name: '' });
      post({ kind: 'link', state });
    },
    ping: () => this.send({ type: 'Ping', time: epochMs() / 1000 }),
  });

  handle(message: ToWorker): void {
    switch (message.kind) {
      case 'open':
        this.peer_ = message.url;
        this.connection_.start();
        break;
      case 'engine':
        this.peer_ = message.port;
        this.connection_.start();
        break;
      case 'send':
        this.send(message.message);
        break;
      case 'ready':
        this.gate_.ready();
        break;
      case 'retry':
        this.connection_.retryNow();
        break;
    }
  }

  private openSocket(): Socket {
    if (this.peer_ instanceof MessagePort) return new PortSocket(this.peer_);
    return new WebSocket(this.peer_, SUBPROTOCOL) as unknown as Socket;
  }

  /** The server sends everything anew over a new connection. */
  private forget(): void {
    this.gate_.reset();
    this.unpacker_ = new FrameUnpacker();
  }

  private send(message: ClientMessage): void {
    this.connection_.send(encodeClient(message));
  }

  private receive(bytes: ArrayBuffer): void {
    const receivedAt = epochMs();
    try {
      const message = decodeServer(bytes);
      if (message.type === 'Frame') return this.receiveFrame(message, receivedAt);
      if (message.type === 'Motions') this.unpacker_.setMotions(message);
      if (message.type === 'GroupMesh') this.unpacker_.setMesh(message);
      post({ kind: 'message', message });
    } catch (error) {
      const text = `The page could not read a message of the server: ${String(error)}`;
      post({ kind: 'message', message: problem('decode', text) });
    }
  }

  private receiveFrame(frame: Frame, receivedAt: number): void {
    this.send({ type: 'FrameAck', frame: frame.frame });
    this.gate_.offer(this.unpacker_.unpack(frame), receivedAt);
  }
}

const worker = new LinkWorker();
self.onmessage = (event: MessageEvent<ToWorker>) => worker.handle(event.data);
