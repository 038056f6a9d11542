// A small stand-in for `muster studio`: the real protocol, a toy world. For work on the page without the program:
// `npx vite-node tests/mock_server.ts [port]`, after `npm run build`.

import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { createServer, type Server } from 'node:http';
import { extname, join, normalize } from 'node:path';
import type { Duplex } from 'node:stream';
import { decodeClient, encodeServer, type ServerMessage } from '../src/protocol/messages';
import { ToyWorld } from './toy_world';

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.woff2': 'font/woff2',
};
const GUID = '258EAFA5-E914-47DA-95CA-C5AB0DC85B11';
const BINARY = 2;
const CLOSE = 8;

/** A message as one unmasked WebSocket frame. */
function framed(bytes: ArrayBuffer): Buffer {
  const payload = Buffer.from(bytes);
  const { length } = payload;
  // Browsers insist on the shortest form of the length.
  const head = Buffer.alloc(length < 126 ? 2 : length < 65536 ? 4 : 10);
  head[0] = 0x80 | BINARY;
  head[1] = length < 126 ? length : length < 65536 ? 126 : 127;
  if (head.length === 4) head.writeUInt16BE(length, 2);
  if (head.length === 10) head.writeBigUInt64BE(BigInt(length), 2);
  return Buffer.concat([head, payload]);
}

/** Takes whole client frames off the front of what came; returns the rest. */
function unframed(data: Buffer, each: (payload: Buffer, code: number) => void): Buffer {
  let rest = data;
  for (;;) {
    if (rest.length < 2) return rest;
    const short = rest[1]! & 127;
    const head = short < 126 ? 2 : short === 126 ? 4 : 10;
    if (rest.length < head + 4) return rest;
    const length = short < 126 ? short : short === 126 ? rest.readUInt16BE(2) : Number(rest.readBigUInt64BE(2));
    if (rest.length < head + 4 + length) return rest;
    const mask = rest.subarray(head, head + 4);
    const payload = Buffer.from(rest.subarray(head + 4, head + 4 + length));
    for (let i = 0; i < payload.length; ++i) payload[i]! ^= mask[i % 4]!;
    each(payload, rest[0]! & 15);
    rest = rest.subarray(head + 4 + length);
  }
}

function serveFile(server: Server, root: string): void {
  server.on('request', (request, response) => {
    const path = normalize(new URL(request.url ?? '/', 'http://here').pathname);
    readFile(join(root, path === '/' ? 'index.html' : path)).then(
      (body) => response.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'text/html' }).end(body),
      () => response.writeHead(404).end('not found'),
    );
  });
}

function talk(socket: Duplex): void {
  const send = (message: ServerMessage): void => {
    if (socket.writable) socket.write(framed(encodeServer(message)));
  };
  const world = new ToyWorld();
  for (const message of world.greeting()) send(message);
  const timer = setInterval(() => send(world.step()), 1000 / 60);
  let rest: Buffer = Buffer.alloc(0);
  socket.on('data', (data: Buffer) => {
    rest = unframed(Buffer.concat([rest, data]), (payload, code) => {
      if (code === CLOSE) socket.end();
      if (code !== BINARY) return;
      const bytes = payload.buffer.slice(payload.byteOffset, payload.byteOffset + payload.length) as ArrayBuffer;
      for (const answer of world.receive(decodeClient(bytes))) send(answer);
    });
  });
  const stop = (): void => clearInterval(timer);
  socket.on('close', stop);
  socket.on('error', stop);
}

/** Serves the built page and the toy world. */
export function startMock(root: string, port: number): Promise<Server> {
  const server = createServer();
  serveFile(server, root);
  server.on('upgrade', (request, socket) => {
    const accept = createHash('sha1').update(`${request.headers['sec-websocket-key']}${GUID}`).digest('base64');
    socket.write(
      'HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n' +
        `Sec-WebSocket-Accept: ${accept}\r\nSec-WebSocket-Protocol: muster.v1\r\n\r\n`,
    );
    talk(socket);
  });
  return new Promise((resolve) => server.listen(port, '127.0.0.1', () => resolve(server)));
}

const port = Number(process.argv[2] ?? 8090);
void startMock(new URL('../dist', import.meta.url).pathname, port).then(() => console.log(`http://127.0.0.1:${port}/`));
