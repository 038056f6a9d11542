// A studio without a world: serves the page, and frames of any number of people who walk, as docs/protocol.md has them.
import { createHash } from 'node:crypto';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const dist = fileURLToPath(new URL('../../dist/', import.meta.url));
const source = fileURLToPath(new URL('../../src/protocol/messages.ts', import.meta.url));
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.woff2': 'font/woff2' };
const kQuantum = 1 / 256;
const kFrameMs = 1000 / 30;

/** The page's own encoder, so that there is no second one to keep. */
async function protocol() {
  const { outputFiles } = await build({ entryPoints: [source], bundle: true, format: 'esm', write: false });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
}

function sceneOf(count) {
  const half = Math.ceil(0.75 * Math.sqrt(count)) + 20;
  return {
    name: 'made',
    title: 'Made',
    box: { min: [-half, -half], max: [half, half] },
    cell: 1,
    radius: 0.25,
    groups: [0, 1].map((k) => ({
      id: k + 1,
      name: ['Blue', 'Ember'][k],
      count: count / 2,
      formation: 'square',
      colour: k,
    })),
    parameters: [{ name: 'plan.exponent', value: 2 }],
  };
}

/** Two clips of a few poses: enough for the page to have something to mix. */
function motions(type) {
  const clip = (name) => ({
    name,
    motion: name,
    rate: 10,
    cyclic: true,
    poses: 8,
    hips: Float32Array.from({ length: 24 }, (_, i) => (i % 3 === 2 ? 0.95 : 0)),
    rotations: Int16Array.from({ length: 8 * 21 * 4 }, (_, i) => (i % 4 === 3 ? 32767 : 0)),
  });
  return { type, joints: [], clips: [clip('idle'), clip('run')] };
}

/** A square mesh of 20 by 20 corners with `count` places on it. */
function meshOf(group, count) {
  const triangles = [];
  for (let j = 0; j < 19; ++j)
    for (let i = 0; i < 19; ++i) {
      const a = 20 * j + i;
      triangles.push(a, a + 1, a + 21, a, a + 21, a + 20);
    }
  const rim = [
    ...Array(19).keys(),
    ...Array.from({ length: 19 }, (_, k) => 19 + 20 * k),
    ...Array.from({ length: 19 }, (_, k) => 399 - k),
    ...Array.from({ length: 19 }, (_, k) => 380 - 20 * k),
  ];
  return {
    type: 'GroupMesh',
    group,
    version: 1,
    formation: 'square',
    triangles: Uint32Array.from(triangles),
    boundary: Uint32Array.of(rim.length, ...rim),
    spacing: 1,
    rest: new Float32Array(0),
    placeTriangles: Uint32Array.from({ length: count }, (_, k) => Math.floor((k * 722) / count)),
    placeWeights: new Float32Array(2 * count).fill(0.33),
  };
}

class Walkers {
  constructor(count) {
    this.count = count;
    this.across = Math.ceil(Math.sqrt(count));
    this.x = new Float64Array(count);
    this.y = new Float64Array(count);
    this.told = [new Uint16Array(count), new Uint16Array(count)];
    this.clip = new Uint8Array(count);
    for (let i = 0; i < count; ++i) {
      this.x[i] = 1.2 * ((i % this.across) - this.across / 2);
      this.y[i] = 1.2 * (Math.floor(i / this.across) - this.across / 2);
    }
  }

  packed(k) {
    const from = k === 0 ? this.x : this.y;
    return Uint16Array.from(from, (one) => Math.round((one + 128) / kQuantum));
  }

  /** The crowd after another thirtieth of a second; whole for a new page. */
  crowd(frame, near) {
    const { count } = this;
    const time = frame / 30;
    for (let i = 0; i < count; ++i) {
      this.x[i] += 0.05 * Math.cos(0.4 * time + 0.001 * i);
      this.y[i] += 0.05 * Math.sin(0.4 * time + 0.001 * i);
    }
    const now = [this.packed(0), this.packed(1)];
    const whole = frame === 1;
    const steps = now.map((list, k) =>
      whole ? new Int8Array(0) : Int8Array.from(list, (one, i) => one - this.told[k][i]),
    );
    this.told = now;
    const changed = whole
      ? []
      : Array.from({ length: Math.round(count * 0.04) }, (_, k) => (frame * 7919 + k * 25) % count);
    for (const who of changed) this.clip[who] ^= 1;
    const heading = Math.floor(((0.4 * time) / (2 * Math.PI)) * 256);
    return {
      count,
      x0: -128,
      y0: -128,
      quantum: kQuantum,
      x: whole ? now[0] : new Uint16Array(0),
      y: whole ? now[1] : new Uint16Array(0),
      stepX: steps[0],
      stepY: steps[1],
      jumped: new Uint32Array(0),
      jumpedX: new Uint16Array(0),
      jumpedY: new Uint16Array(0),
      heading: new Uint8Array(count).fill(heading),
      headingFine: new Uint8Array(0),
      changed: Uint32Array.from(new Set(changed)),
      clip: whole ? this.clip.slice() : Uint8Array.from(new Set(changed), (who) => this.clip[who]),
      phase: Uint8Array.from({ length: count }, (_, i) => frame * 7 + i),
      phaseFine: new Uint8Array(0),
      near: Uint32Array.from({ length: near }, (_, k) => k),
      nearPlaces: Float32Array.from({ length: 3 * near }, (_, k) => [this.x, this.y, this.x][k % 3][Math.floor(k / 3)]),
      nearPoses: new Int16Array(66 * near).fill(6),
    };
  }
}

/** Of a whole binary WebSocket frame, its length as short as can be. */
function headOf(length) {
  if (length < 126) return Buffer.of(0x82, length);
  const head = Buffer.alloc(length < 65536 ? 4 : 10);
  head[0] = 0x82;
  head[1] = length < 65536 ? 126 : 127;
  if (length < 65536) head.writeUInt16BE(length, 2);
  else head.writeBigUInt64BE(BigInt(length), 2);
  return head;
}

/** One page's frames. */
class Conversation {
  constructor(socket, { encodeServer, decodeClient }, count, near) {
    Object.assign(this, { socket, encodeServer, decodeClient, count, near, frame: 0, waiting: false });
    this.walkers = new Walkers(count);
    this.sizes = [];
  }

  send(message) {
    const body = Buffer.from(this.encodeServer(message));
    this.socket.write(Buffer.concat([headOf(body.length), body]));
    return body.length;
  }

  hear(payload) {
    const message = this.decodeClient(payload);
    if (message.type === 'Hello') this.greet();
    if (message.type === 'FrameAck') this.waiting = false;
  }

  greet() {
    this.send({ type: 'Welcome', client: 1001, version: 'made', scenarios: [], schemes: [] });
    this.send({ type: 'Scene', revision: 1, json: JSON.stringify(sceneOf(this.count)) });
    this.send(motions('Motions'));
    for (const group of [1, 2]) this.send(meshOf(group, this.count / 2));
    this.timer = setInterval(() => this.tick(), kFrameMs);
  }

  tick() {
    if (this.waiting) return;
    this.waiting = true;
    const frame = ++this.frame;
    const first = frame === 1;
    const half = this.count / 2;
    const side = 1.2 * Math.sqrt(this.count);
    const corners = (k) =>
      Float32Array.from({ length: 800 }, (_, n) => {
        const i = Math.floor(n / 2);
        return n % 2 === 0
          ? side * ((i % 20) / 19 - 0.5)
          : side * (0.5 * (Math.floor(i / 20) / 19) - 0.5 + 0.5 * k) + Math.sin(frame / 30);
      });
    const groups = [0, 1].map((k) => ({
      id: k + 1,
      meshVersion: 1,
      lag: 1,
      walkSum: 3 * half,
      walkSquares: 12 * half,
      walkLongest: 9,
      vertices: corners(k),
      moved: new Uint32Array(0),
      offsets: new Int16Array(0),
      unfit: new Uint8Array(0),
      standings: new Uint32Array([half, 0, 0, 0, 0, 0, 0, 0, 0]),
      controls: [],
      x: 0,
      y: 0,
      facing: 0,
      orders: [],
      way: new Float32Array(0),
      held: false,
      patrols: false,
      stance: 0,
      cohesion: 0,
      squeeze: 1,
      avoids: false,
    }));
    this.sizes.push(
      this.send({
        type: 'Frame',
        frame,
        step: 2 * frame,
        time: frame / 30,
        playing: true,
        speed: 1,
        recordedSeconds: -1,
        replaying: false,
        demonstrating: false,
        touchEcho: 0,
        sceneRevision: 1,
        unitClass: new Uint8Array(0),
        radius: new Uint8Array(0),
        ids: first ? Uint32Array.from({ length: this.count }, (_, i) => i + 1) : new Uint32Array(0),
        group: first ? Uint8Array.from({ length: this.count }, (_, i) => (i < half ? 0 : 1)) : new Uint8Array(0),
        crowd: this.walkers.crowd(frame, this.near),
        groups,
        moving: [],
        collected: new Uint8Array(0),
        stepMs: 8,
        lagP95: 1.5,
        swapsPerSecond: 0.3,
        events: [],
      }),
    );
  }

  end() {
    clearInterval(this.timer);
    this.socket.destroy();
  }
}

/** Reads a client's masked frames; hands on whole binary ones. */
function listen(socket, hear) {
  let kept = Buffer.alloc(0);
  socket.on('data', (data) => {
    kept = Buffer.concat([kept, data]);
    while (kept.length >= 6) {
      const short = kept[1] & 127;
      const at = short === 126 ? 4 : short === 127 ? 10 : 2;
      if (kept.length < at + 4) return;
      const size = short === 126 ? kept.readUInt16BE(2) : short === 127 ? Number(kept.readBigUInt64BE(2)) : short;
      if (kept.length < at + 4 + size) return;
      const mask = kept.subarray(at, at + 4);
      const payload = Uint8Array.from(kept.subarray(at + 4, at + 4 + size), (byte, i) => byte ^ mask[i % 4]);
      if ((kept[0] & 15) === 2) hear(payload.buffer);
      if ((kept[0] & 15) === 8) socket.end();
      kept = kept.subarray(at + 4 + size);
    }
  });
}

/** Serves `count` walkers, `near` of them with whole poses, on a free port; `bodies`: address of a studio that has them. */
export async function startMadeCrowd({ count = 10000, near = 100, bodies = '' } = {}) {
  const messages = await protocol();
  const conversations = [];
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, 'http://made').pathname;
    if (path.startsWith('/bodies/') && bodies) {
      const answer = await fetch(new URL(path, bodies));
      return response.writeHead(answer.status).end(Buffer.from(await answer.arrayBuffer()));
    }
    const nothing = { '/takes': { takes: [] }, '/invitation.json': { links: [], code: [] } }[path];
    if (nothing) return response.writeHead(200, { 'Content-Type': 'application/json' }).end(JSON.stringify(nothing));
    const file = `${dist}${path === '/' ? 'index.html' : path.slice(1)}`;
    if (path.includes('..') || !existsSync(file)) return response.writeHead(404).end();
    response
      .writeHead(200, { 'Content-Type': kTypes[extname(file)] ?? 'application/octet-stream' })
      .end(readFileSync(file));
  });
  server.on('upgrade', (request, socket) => {
    const accept = createHash('sha1')
      .update(`${request.headers['sec-websocket-key']}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`)
      .digest('base64');
    socket.write(
      `HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accept}\r\nSec-WebSocket-Protocol: ${messages.SUBPROTOCOL}\r\n\r\n`,
    );
    socket.on('error', () => {});
    const talk = new Conversation(socket, messages, count, near);
    conversations.push(talk);
    socket.on('close', () => talk.end());
    listen(socket, (payload) => talk.hear(payload));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const stop = () =>
    new Promise((resolve) => {
      for (const talk of conversations) talk.end();
      server.close(resolve);
    });
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    sizes: () => conversations.flatMap((talk) => talk.sizes.slice(1)),
    stop,
  };
}
