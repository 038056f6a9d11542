// A socket to the engine, over a port: to the connection it is like a WebSocket.

import type { Socket } from '../connection';
import type { SocketMessage } from './engine_messages';

export class PortSocket implements Socket {
  binaryType = 'arraybuffer';
  onopen: ((event: never) => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: ((event: never) => void) | null = null;

  constructor(private readonly port_: MessagePort) {
    port_.onmessage = ({ data }: MessageEvent<SocketMessage>) => this.receive(data);
    this.post({ kind: 'open' });
  }

  send(bytes: ArrayBuffer): void {
    this.post({ kind: 'bytes', bytes }, [bytes]);
  }

  close(): void {
    this.post({ kind: 'close' });
  }

  private post(message: SocketMessage, transfer: Transferable[] = []): void {
    this.port_.postMessage(message, transfer);
  }

  private receive(message: SocketMessage): void {
    if (message.kind === 'open') this.onopen?.(undefined as never);
    if (message.kind === 'bytes') this.onmessage?.({ data: message.bytes });
    if (message.kind === 'close') this.onclose?.(undefined as never);
  }
}
