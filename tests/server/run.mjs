// Tests of the studio's server: who may connect, each limit at its edge. Starts the program itself.
//
//     node tests/server/run.mjs [PROGRAM]     default: build/release/muster
import { spawn } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync, mkdirSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { demonstrationTests } from './demonstration.mjs';
import { lanTests } from './lan.mjs';
import { mcpTests } from './mcp.mjs';
import { processTests } from './process.mjs';
import { watchBodies, watchQueue, watchSilence } from './slow.mjs';
import { studyTests } from './study.mjs';
import { placesTests } from './places.mjs';
import { takesTests } from './takes.mjs';
import { RawSocket, ack, dial, eventually, exchange, fromClient, fromServer, hello, kSubprotocol, ping, request, stepOf } from './client.mjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const program = resolve(process.argv[2] ?? join(root, 'build/release/muster'));
const place = mkdtempSync(join(tmpdir(), 'muster-server-'));
const page = join(place, 'page');
mkdirSync(join(page, 'assets'), { recursive: true });
writeFileSync(join(page, 'index.html'), '<p>page</p>');
writeFileSync(join(page, 'assets', 'app-1.js'), 'let a');
writeFileSync(join(page, 'font.woff2'), 'f');
writeFileSync(join(place, 'secret.txt'), 'secret');
symlinkSync(join(place, 'secret.txt'), join(page, 'link.txt'));

let passed = 0;
let failed = 0;

function check(condition, what) {
  if (!condition) throw new Error(what);
}

async function test(name, run) {
  try {
    await run();
    passed += 1;
  } catch (error) {
    failed += 1;
    console.log(`FAILED ${name}: ${error.message}`);
  }
}

/** Starts a studio; resolves when it tells its address. The first option may be settings of the process. */
function start(...options) {
  const settings = typeof options[0] === 'object' ? options.shift() : {};
  const own = common.filter((_, i) => !options.includes(common[i - i % 2]));
  const child = spawn(program, ['studio', ...own, ...options], { cwd: place, stdio: ['ignore', 'pipe', 'inherit'], ...settings });
  return new Promise((done, fail) => {
    let text = '';
    child.on('exit', (code) => fail(new Error(`the studio ended with ${code}`)));
    child.stdout.on('data', (chunk) => {
      text += chunk;
      const match = /Muster studio: http:\/\/127\.0\.0\.1:(\d+)\/\n/.exec(text);
      if (match) done({ child, port: Number(match[1]) });
    });
  });
}

const common = ['--page', page, '--scenarios', join(root, 'scenarios')];
const { child, port } = await start('--port', '18080');
const here = `http://127.0.0.1:${port}`;
const get = (path, headers) => request(port, 'GET', path, headers);
const post = (body, headers = {}) => request(port, 'POST', '/take', { Origin: here, ...headers }, body);
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** A client that has said Hello and seen the first frame. */
async function client() {
  const socket = await RawSocket.open(port);
  check(socket.status === 101, `handshake: ${socket.status}`);
  socket.write(hello());
  check(await socket.message(fromServer.Frame), 'no frame came');
  return socket;
}

const silence = watchSilence(start);
const bodies = watchBodies(start);
const queue = watchQueue(start, place);

await test('files, types and caching', async () => {
  const index = await get('/');
  check(index.status === 200 && index.body === '<p>page</p>', `index: ${index.status}`);
  check(index.headers['content-type'] === 'text/html; charset=utf-8', index.headers['content-type']);
  check(index.headers['cache-control'] === 'no-cache', index.headers['cache-control']);
  const script = await get('/assets/app-1.js?v=1');
  check(script.status === 200 && script.headers['content-type'].startsWith('text/javascript'), 'script');
  check(script.headers['cache-control'].includes('immutable'), 'assets may be kept');
  check((await get('/font.woff2')).headers['content-type'] === 'font/woff2', 'font');
  check((await get('/none.js')).status === 404, 'missing file');
  const head = await request(port, 'HEAD', '/');
  check(head.status === 200 && head.body === '' && head.headers['content-length'] === '11', 'HEAD');
});

await test('security headers', async () => {
  const { headers } = await get('/');
  check(headers['content-security-policy'].includes("default-src 'self'"), 'CSP');
  check(headers['content-security-policy'].includes("frame-ancestors 'none'"), 'CSP frames');
  check(headers['x-content-type-options'] === 'nosniff', 'nosniff');
  check(headers['cross-origin-resource-policy'] === 'same-origin', 'CORP');
});

await test('health', async () => {
  const answer = await get('/health');
  check(answer.status === 200 && JSON.parse(answer.body).status === 'ok', answer.body);
});

await test('no way out of the page folder', async () => {
  const tries = ['/../secret.txt', '/assets/../../secret.txt', '/..%2fsecret.txt', '/%2e%2e/secret.txt', '/..\\secret.txt',
    '/link.txt', '//secret.txt', '/./index.html', '/.hidden', 'secret.txt', '/assets', '/index.html%00', `${here}/index.html`];
  for (const path of tries) {
    const answer = await get(path);
    check(answer.status === 404 || answer.status === 400, `${path}: ${answer.status}`);
    check(!answer.body.includes('secret\n') && answer.body !== 'secret', path);
  }
});

await test('exact Host', async () => {
  for (const host of [`127.0.0.1:${port}`, `localhost:${port}`]) check((await get('/', { Host: host })).status === 200, host);
  const bad = ['127.0.0.1', 'localhost', `127.0.0.1:${port + 1}`, `127.0.0.1:${port}0`, `evil.example:${port}`, `127.0.0.1.evil.example:${port}`,
    `LOCALHOST:${port}.`, '', `[::1]:${port}`, `0.0.0.0:${port}`];
  for (const host of bad) check((await get('/', { Host: host })).status === 403, `Host ${host}`);
  check((await get('/', { Host: null })).status === 403, 'no Host');
  const twice = await exchange(port, `GET / HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nHost: 127.0.0.1:${port}\r\n\r\n`);
  check(/ 40[03] /.test(twice.text.split('\r\n')[0]), 'two Hosts');
  const socket = await RawSocket.open(port, { Host: `evil.example:${port}` });
  check(socket.status === 403, `WebSocket Host: ${socket.status}`);
});

await test('exact Origin of WebSockets', async () => {
  for (const origin of [here, `http://localhost:${port}`]) {
    const socket = await RawSocket.open(port, { Origin: origin });
    check(socket.status === 101, origin);
    socket.close();
  }
  const bad = [null, '', 'null', `https://127.0.0.1:${port}`, `${here}/`, 'http://127.0.0.1', `http://evil.example:${port}`, `${here}.evil.example`,
    `http://127.0.0.1:${port + 1}`];
  for (const origin of bad) check((await RawSocket.open(port, { Origin: origin })).status === 403, `Origin ${origin}`);
});

await test('subprotocol', async () => {
  const two = await RawSocket.open(port, { 'Sec-WebSocket-Protocol': `other, ${kSubprotocol}` });
  check(two.status === 101 && two.head.toLowerCase().includes(`sec-websocket-protocol: ${kSubprotocol}`), 'one of two');
  two.close();
  for (const name of [null, 'muster.v1', 'muster', `${kSubprotocol}x`]) {
    check((await RawSocket.open(port, { 'Sec-WebSocket-Protocol': name })).status === 400, `subprotocol ${name}`);
  }
  check((await RawSocket.open(port, {}, '/other')).status === 404, 'path');
  check((await RawSocket.open(port, { 'Sec-WebSocket-Version': '12' })).status !== 101, 'version');
});

await test('header size: the limit passes, one byte more does not', async () => {
  const limit = 8192;
  const base = `GET / HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nConnection: close\r\nX: `;
  const of = (size) => `${base}${'a'.repeat(size - base.length - 4)}\r\n\r\n`;
  check((await exchange(port, of(limit))).text.startsWith('HTTP/1.1 200'), 'at the limit');
  const over = await exchange(port, of(limit + 1));
  check(over.text.startsWith('HTTP/1.1 431'), `over it: ${over.text.slice(0, 30)}`);
});

await test('handshake timeout', async () => {
  const silent = exchange(port, '');
  const slow = exchange(port, 'GET / HTTP/1.1\r\nHost: ');
  for (const answer of await Promise.all([silent, slow])) {
    check(answer.text === '', 'no answer is due');
    check(answer.ms > 4000, `closed after ${answer.ms} ms, before its time`);
    console.log(`measured: a handshake that does not come is given up after ${answer.ms} ms`);
  }
});

await test('methods and bodies', async () => {
  check((await request(port, 'DELETE', '/')).status === 405, 'DELETE');
  check((await request(port, 'POST', '/other', { Origin: here }, Buffer.from('x'))).status === 404, 'POST elsewhere');
  check((await request(port, 'GET', '/', {}, Buffer.from('x'))).status === 413, 'a body with GET');
  check((await exchange(port, 'nonsense\r\n\r\n')).text.startsWith('HTTP/1.1 400'), 'no HTTP');
});

await test('a client steers nothing by malformed messages and stays connected', async () => {
  const socket = await client();
  for (const bytes of [[], [99], [1, 255, 255, 255, 255], [8, 9], [9, 0, 0, 192, 127]]) socket.write(Buffer.from(bytes));
  check(await socket.until((self) => self.notices().length >= 4), `notices: ${socket.notices().join(' | ')}`);
  socket.write('text', 1);
  socket.write(ping(42));
  const pong = await socket.message(fromServer.Pong);
  check(pong && pong.readDoubleLE(1) === 42 && !socket.closed, 'still there');
  socket.close();
});

await test('unmasked and reserved frames end the connection, not the studio', async () => {
  const unmasked = await client();
  unmasked.write(hello(), 2, false);
  check(await unmasked.until((self) => self.closed || self.closeCode !== null), 'unmasked');
  unmasked.close();
  const reserved = await client();
  reserved.write(hello(), 3);
  check(await reserved.until((self) => self.closed || self.closeCode !== null), 'reserved opcode');
  reserved.close();
  (await client()).close();
});

await test('message size: the limit passes, one byte more does not', async () => {
  const socket = await client();
  socket.write(Buffer.alloc(65536, 99));
  check(await socket.until((self) => self.notices().some((text) => text.startsWith('malformed'))), 'heard at the limit');
  check(!socket.closed && socket.closeCode === null, 'open at the limit');
  socket.write(Buffer.alloc(65537, 99));
  check(await socket.until((self) => self.closeCode === 1009), `close code ${socket.closeCode}`);
  socket.close();
});

await test('message rate: a burst passes, more is dropped with a notice, and the connection stays', async () => {
  const socket = await client();
  await sleep(2200); // Whatever the first messages took is back.
  for (let i = 0; i < 800; ++i) socket.write(ping(i));
  const pongs = (self) => self.messages.filter((bytes) => bytes[0] === fromServer.Pong).length;
  check(await socket.until((self) => pongs(self) === 800), `pongs within the limit: ${pongs(socket)}`);
  check(!socket.notices().some((text) => text.startsWith('rate')), 'no notice within the limit');
  await sleep(2200);
  for (let i = 0; i < 4000; ++i) socket.write(ping(i));
  check(await socket.until((self) => self.notices().some((text) => text.startsWith('rate'))), 'a notice beyond it');
  await sleep(2200); // All that was sent has been read, and some of the limit is back.
  check(pongs(socket) < 800 + 4000, 'some are dropped');
  const before = pongs(socket);
  socket.write(ping(7));
  check(await socket.until((self) => pongs(self) > before), 'heard again');
  socket.close();
});

await test('clients: sixteen pass, the seventeenth does not', async () => {
  const sockets = [];
  for (let i = 0; i < 16; ++i) sockets.push(await RawSocket.open(port));
  check(sockets.every((socket) => socket.status === 101), sockets.map((socket) => socket.status).join(' '));
  check((await RawSocket.open(port)).status === 503, 'one more');
  sockets.pop().close();
  let again = await RawSocket.open(port);
  for (let i = 0; i < 50 && again.status !== 101; ++i) {
    await sleep(100);
    again = await RawSocket.open(port);
  }
  check(again.status === 101, 'room again');
  for (const socket of [...sockets, again]) socket.close();
  await sleep(200);
});

/** Steps that the world makes and frames that a client gets in so many milliseconds, when it acknowledges each. */
async function watchFrames(lively, milliseconds) {
  const steps = [];
  const end = Date.now() + milliseconds;
  let seen = lively.messages.length;
  const frames = lively.messages.filter((bytes) => bytes[0] === fromServer.Frame);
  lively.write(ack(frames.at(-1).readUInt32LE(1)));
  while (Date.now() < end) {
    await lively.until((self) => self.messages.length > seen, 100);
    for (; seen < lively.messages.length; ++seen) {
      const bytes = lively.messages[seen];
      if (bytes[0] !== fromServer.Frame) continue;
      steps.push(stepOf(bytes));
      lively.write(ack(bytes.readUInt32LE(1)));
    }
  }
  return { steps: steps.at(-1) - steps[0], frames: steps.length };
}

await test('a client that neither acknowledges nor reads does not slow another', async () => {
  const lively = await client();
  const alone = await watchFrames(lively, 2000);
  const stalled = await client();
  stalled.socket.pause();
  const together = await watchFrames(lively, 2000);
  console.log(`measured: in 2 s ${alone.steps} steps and ${alone.frames} frames alone, ${together.steps} and ${together.frames} beside a stalled client`);
  check(together.steps > 0.5 * alone.steps && together.frames > 0.5 * alone.frames, `${together.steps} steps against ${alone.steps}`);
  check(stalled.messages.filter((bytes) => bytes[0] === fromServer.Frame).length === 1, 'the stalled one got one frame');
  stalled.close();
  lively.close();
});

/** Starts a studio that tells what it is as JSON. */
async function begin(...options) {
  const own = spawn(program, ['studio', '--port', '18680', ...options, ...common], { cwd: place, stdio: ['ignore', 'pipe', 'inherit'] });
  let text = '';
  own.stdout.on('data', (chunk) => (text += chunk));
  check(await eventually(() => text.trimEnd().endsWith('}')), `no address: ${text}`);
  const ended = new Promise((done) => own.on('exit', done));
  return { said: JSON.parse(text), end: () => (own.kill('SIGINT'), ended) };
}
await lanTests({ test, check, begin, closed: port });
await demonstrationTests({ test, check, client, get, program, place });

let take = null;
await test('GET /take gives the whole take', async () => {
  const answer = await get('/take');
  check(answer.status === 200 && answer.body.startsWith('MUSTAKE\n'), `${answer.status}`);
  check(/attachment; filename="[a-z-]+\.take"/.test(answer.headers['content-disposition']), answer.headers['content-disposition']);
  take = Buffer.from(answer.body, 'latin1');
});

await test('GET /take and GET /handover are for our own page and for programs of this machine', async () => {
  for (const path of ['/take', '/handover?world=1&take=0']) {
    for (const site of ['cross-site', 'same-site', 'nonsense']) check((await get(path, { 'Sec-Fetch-Site': site })).status === 403, site);
    for (const site of ['same-origin', 'none']) check((await get(path, { 'Sec-Fetch-Site': site })).status === 200, site);
    check((await get(path, { Origin: 'http://evil.example' })).status === 403, 'foreign Origin');
    check((await get(path, { Origin: here })).status === 200, 'own Origin');
  }
});

await test('GET /handover gives what is new of the take, whatever it is asked', async () => {
  const sizes = [];
  const world = (await get('/handover')).body.charCodeAt(12);
  for (const query of ['', '?world=0&take=0', `?world=${world}&take=99999999`, '?take=x&world=-1', `?world=${world}&take=64`]) {
    const answer = await get(`/handover${query}`);
    check(answer.status === 200 && answer.body.startsWith('MUSTHAND'), query);
    sizes.push(answer.body.length);
  }
  check(sizes.at(-1) < sizes[0], `less where something is known: ${sizes}`);
});

await test('POST /take: Origin, length, contents', async () => {
  check((await post(take, { Origin: null })).status === 403, 'no Origin');
  check((await post(take, { Origin: 'http://evil.example' })).status === 403, 'foreign Origin');
  check((await post(Buffer.from('nonsense'))).status === 400, 'nonsense');
  const torn = Buffer.from(take);
  torn[40] ^= 1;
  const answer = await post(torn);
  check(answer.status === 400 && /offset \d+/.test(answer.body), `a damaged take: ${answer.status} ${answer.body}`);
  const chunked = await exchange(port, `POST /take HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nOrigin: ${here}\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n`);
  check(chunked.text.startsWith('HTTP/1.1 411'), 'no length');
  const limit = 64 * 1024 * 1024;
  check((await post(null, { 'Content-Length': String(limit + 1) })).status === 413, 'one byte too many');
  check((await post(Buffer.alloc(limit))).status === 400, 'at the limit it is read');
});

await test('POST /take replays', async () => {
  const answer = await post(take);
  check(answer.status === 200, `${answer.status} ${answer.body}`);
  const socket = await client();
  const frame = socket.messages.find((bytes) => bytes[0] === fromServer.Frame);
  // Number, frame, step, time, playing, speed, recordedSeconds: then replaying.
  check(frame[1 + 4 + 4 + 8 + 1 + 4 + 4] === 1, 'frames say that a take is replayed');
  const same = await get('/take');
  check(Buffer.from(same.body, 'latin1').equals(take), 'the opened take is what one downloads');
  socket.write(Buffer.from([fromClient.Playback, 3]));
  socket.close();
});

await test('a second studio takes the next port', async () => {
  const second = await start('--port', String(port));
  check(second.port > port, `port ${second.port}`);
  second.child.removeAllListeners('exit');
  const code = new Promise((done) => second.child.on('exit', done));
  second.child.kill('SIGINT');
  check((await code) === 0, 'SIGINT ends it with 0');
});

await test('SIGTERM finishes a running recording and ends with 0', async () => {
  const { child: other, port: otherPort } = await start('--port', '18180');
  const socket = await RawSocket.open(otherPort);
  socket.write(hello());
  check(await socket.message(fromServer.Frame), 'no frame');
  socket.write(Buffer.from([fromClient.Record, 1]));
  await sleep(1500);
  other.removeAllListeners('exit');
  const code = new Promise((done) => other.on('exit', done));
  other.kill('SIGTERM');
  check((await code) === 0, 'exit code');
  const files = readdirSync(join(place, 'takes')).filter((name) => name.endsWith('.take'));
  check(files.length === 1, files.join(' '));
  const bytes = readFileSync(join(place, 'takes', files[0]));
  // The last record is an end: u32 length 12, kind 4.
  const end = bytes.subarray(bytes.length - 25);
  check(end.readUInt32LE(0) === 12 && end[4] === 4, 'the take is finished');
  socket.close();
});

await test('silent clients are pinged; who does not answer is closed', async () => {
  const { ms, pings, deadClosed, aliveClosed, alivePings } = await silence;
  check(deadClosed && ms > 25000, `closed after ${ms} ms`);
  console.log(`measured: a silent client was closed after ${ms} ms`);
  check(pings >= 1 && alivePings >= 1, `pings: ${pings} and ${alivePings}`);
  check(!aliveClosed, 'who answers stays');
});

await test('a body has a minute', async () => {
  const { intime, late } = await bodies;
  check(intime.status === 400, `in time: ${intime.status} after ${intime.ms} ms`);
  check(late.status === 0 && late.ms > 58000, `late: ${late.status} after ${late.ms} ms`);
  console.log(`measured: a body that does not end is given up after ${late.ms} ms`);
});

await test('who takes nothing is cut when 32 MiB wait', async () => {
  const { cut, mebibytes, readerClosed } = await queue;
  console.log(`measured: a client that reads nothing was cut when another had ${mebibytes.toFixed(0)} MiB`);
  check(cut && !readerClosed, 'cut, and the other not');
  check(mebibytes > 31 && mebibytes < 60, `${mebibytes} MiB`);  // The kernel's buffers hold some, too.
});

await test('the studio still answers', async () => {
  check((await get('/health')).status === 200, 'health');
  const idle = await dial(port);
  idle.destroy();
});

await takesTests({ test, check, start, place });
await placesTests({ test, check, start, program, place });
await mcpTests({ test, check, start, program });
await studyTests({ test, check, program, place });
await processTests({ test, check, start, program, common, place });

child.removeAllListeners('exit');
const code = new Promise((done) => child.on('exit', done));
child.kill('SIGINT');
await test('Ctrl+C ends it with 0', async () => check((await code) === 0, 'exit code'));
rmSync(place, { recursive: true, force: true });
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
