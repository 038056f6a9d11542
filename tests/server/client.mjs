// A raw client for the studio's server: bytes on a socket, so that it can also break every rule.
import net from 'node:net';
import { randomBytes } from 'node:crypto';
import { encode, fromClient, fromServer, kSubprotocol } from '../../schema/wire.mjs';

export { fromClient, fromServer, kSubprotocol };

/** How long a test waits for what must come [ms]: no measure of speed, only an end for what hangs. */
export const kPatience = 60000;

/** Waits until `test`, which may be asynchronous, holds, looking again every 20 ms; false where it does not in all that time. */
export async function eventually(test) {
  const end = Date.now() + kPatience;
  while (!(await test())) {
    if (Date.now() > end) return false;
    await new Promise((done) => setTimeout(done, 20));
  }
  return true;
}

/** Connects to the studio. */
export function dial(port) {
  return new Promise((resolve, reject) => {
    const socket = net.connect(port, '127.0.0.1', () => resolve(socket));
    socket.on('error', reject);
    socket.setNoDelay(true);
  });
}

/** Sends raw text and resolves with all that came until the other side closed. */
export async function exchange(port, text, body = null) {
  const socket = await dial(port);
  const chunks = [];
  socket.on('data', (chunk) => chunks.push(chunk));
  const began = Date.now();
  const closed = new Promise((resolve) => {
    socket.on('close', resolve);
    socket.on('error', resolve);
    socket.on('end', () => socket.end());
  });
  socket.write(text);
  if (body) socket.write(body);
  await closed;
  return { text: Buffer.concat(chunks).toString('latin1'), ms: Date.now() - began };
}

/** A request's status, headers and body. */
export async function request(port, method, path, headers = {}, body = null) {
  const all = { Host: `127.0.0.1:${port}`, Connection: 'close', ...headers };
  if (body && !('Content-Length' in all)) all['Content-Length'] = String(body.length);
  const lines = Object.entries(all).filter(([, value]) => value !== null).map(([name, value]) => `${name}: ${value}\r\n`);
  const answer = await exchange(port, `${method} ${path} HTTP/1.1\r\n${lines.join('')}\r\n`, body);
  const end = answer.text.indexOf('\r\n\r\n');
  const head = answer.text.slice(0, end).split('\r\n');
  const found = {};
  for (const line of head.slice(1)) found[line.slice(0, line.indexOf(':')).toLowerCase()] = line.slice(line.indexOf(':') + 2);
  return { status: Number(head[0].split(' ')[1] ?? 0), headers: found, body: answer.text.slice(end + 4), ms: answer.ms };
}

/** A WebSocket that keeps what it gets and answers pings unless told not to. */
export class RawSocket {
  messages = [];
  closeCode = null;
  closed = false;
  status = 0;
  pings = 0;
  answersPings = true;
  #buffer = Buffer.alloc(0);
  #waiting = [];

  /** Shakes hands; `status` says how it went. */
  static async open(port, headers = {}, path = '/ws') {
    const self = new RawSocket();
    self.socket = await dial(port);
    const all = {
      Host: `127.0.0.1:${port}`,
      Origin: `http://127.0.0.1:${port}`,
      Upgrade: 'websocket',
      Connection: 'Upgrade',
      'Sec-WebSocket-Key': randomBytes(16).toString('base64'),
      'Sec-WebSocket-Version': '13',
      'Sec-WebSocket-Protocol': kSubprotocol,
      ...headers,
    };
    const lines = Object.entries(all).filter(([, value]) => value !== null).map(([name, value]) => `${name}: ${value}\r\n`);
    await new Promise((resolve) => {
      self.socket.on('data', (chunk) => {
        self.#take(chunk);
        if (self.status) resolve();
      });
      self.socket.on('close', () => {
        self.closed = true;
        self.#wake();
        resolve();
      });
      self.socket.on('error', () => resolve());
      self.socket.write(`GET ${path} HTTP/1.1\r\n${lines.join('')}\r\n`);
    });
    return self;
  }

  #take(chunk) {
    this.#buffer = Buffer.concat([this.#buffer, chunk]);
    if (!this.status) {
      const end = this.#buffer.indexOf('\r\n\r\n');
      if (end < 0) return;
      this.head = this.#buffer.subarray(0, end).toString('latin1');
      this.status = Number(this.head.split(' ')[1]);
      this.#buffer = this.#buffer.subarray(end + 4);
    }
    if (this.status === 101) this.#frames();
  }

  #frames() {
    for (;;) {
      if (this.#buffer.length < 2) return;
      const opcode = this.#buffer[0] & 15;
      let length = this.#buffer[1] & 127;
      let from = 2;
      if (length === 126) {
        if (this.#buffer.length < 4) return;
        length = this.#buffer.readUInt16BE(2);
        from = 4;
      } else if (length === 127) {
        if (this.#buffer.length < 10) return;
        length = Number(this.#buffer.readBigUInt64BE(2));
        from = 10;
      }
      if (this.#buffer.length < from + length) return;
      const payload = Buffer.from(this.#buffer.subarray(from, from + length));
      this.#buffer = this.#buffer.subarray(from + length);
      if (opcode === 2) this.messages.push(payload);
      if (opcode === 8) this.closeCode = payload.length >= 2 ? payload.readUInt16BE(0) : 0;
      if (opcode === 9) {
        this.pings += 1;
        if (this.answersPings) this.write(payload, 10);
      }
      this.#wake();
    }
  }

  #wake() {
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const resolve of waiting) resolve();
  }

  /** Sends one frame; masked as clients must. */
  write(payload, opcode = 2, masked = true) {
    const data = Buffer.from(payload);
    const head =
      data.length < 126 ? Buffer.from([0x80 | opcode, data.length])
      : data.length < 65536 ? Buffer.from([0x80 | opcode, 126, data.length >> 8, data.length & 255])
      : Buffer.concat([Buffer.from([0x80 | opcode, 127, 0, 0, 0, 0]), Buffer.from([data.length >>> 24, (data.length >> 16) & 255, (data.length >> 8) & 255, data.length & 255])]);
    if (!masked) return this.socket.write(Buffer.concat([head, data]));
    head[1] |= 128;
    const mask = randomBytes(4);
    for (let i = 0; i < data.length; ++i) data[i] ^= mask[i & 3];
    return this.socket.write(Buffer.concat([head, mask, data]));
  }

  /** Waits until `test` holds of this socket; false after `ms`. */
  async until(test, ms = kPatience) {
    const end = Date.now() + ms;
    while (!test(this)) {
      const left = end - Date.now();
      if (left <= 0) return false;
      await new Promise((resolve) => {
        this.#waiting.push(resolve);
        setTimeout(resolve, left);
      });
    }
    return true;
  }

  /** The first message of that number, waited for. */
  async message(number, ms = kPatience) {
    const is = (bytes) => bytes[0] === number;
    await this.until((self) => self.messages.some(is), ms);
    return this.messages.find(is) ?? null;
  }

  /** Texts of all notices so far. */
  notices() {
    return this.messages.filter((bytes) => bytes[0] === fromServer.Notice).map(readNotice);
  }

  close() {
    this.socket.destroy();
  }
}

/** Code and text of a Notice. */
export function readNotice(bytes) {
  const codeLength = bytes.readUInt32LE(2);
  const code = bytes.subarray(6, 6 + codeLength).toString();
  const textLength = bytes.readUInt32LE(6 + codeLength);
  return `${code}: ${bytes.subarray(10 + codeLength, 10 + codeLength + textLength).toString()}`;
}

export const hello = () => encode('Hello', { name: 'a' });
/** Ping with a time. */
export const ping = (time) => encode('Ping', { time });
export const ack = (frame) => encode('FrameAck', { frame });
/** LoadScenario. */
export const load = (name) => encode('LoadScenario', { name });

/** Step of a Frame message. */
export function stepOf(bytes) {
  return bytes.readUInt32LE(5);
}

/** Whether a Frame message says that a demonstration runs: behind number, frame, step, time, playing, speed,
 * recordedSeconds and replaying. */
export function demonstrates(bytes) {
  return bytes[1 + 4 + 4 + 8 + 1 + 4 + 4 + 1] === 1;
}

/** Names of the scenarios in a Welcome message. */
export function scenarioNames(bytes) {
  let at = 5;
  const text = () => {
    const end = at + 4 + bytes.readUInt32LE(at);
    const value = bytes.subarray(at + 4, end).toString();
    at = end;
    return value;
  };
  text();  // The version.
  const names = [];
  let left = bytes.readUInt32LE(at);
  for (at += 4; left > 0; --left, at += 4) {
    names.push(text());
    text();
    text();
  }
  return names;
}
