// A language model directs (muster mcp): a client of the Model Context Protocol that knows nothing of the program
// drives a studio through it, and another director watches.
//
//     node tests/server/mcp.mjs [PROGRAM]     alone
import { createHash } from 'node:crypto';
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { RawSocket, eventually, fromServer, hello, kPatience, kSubprotocol } from './client.mjs';

/** One session of the protocol: requests by their numbers, one line each. */
class McpClient {
  constructor(program, address) {
    this.child = spawn(program, ['mcp', '--studio', address], { stdio: ['pipe', 'pipe', 'inherit'] });
    this.waiting = new Map();
    this.lines = [];
    this.number = 0;
    let text = '';
    this.child.stdout.on('data', (chunk) => {
      text += chunk;
      for (let end = text.indexOf('\n'); end >= 0; end = text.indexOf('\n')) {
        this.came(text.slice(0, end));
        text = text.slice(end + 1);
      }
    });
  }

  came(line) {
    const message = JSON.parse(line);
    this.lines.push(message);
    this.waiting.get(message.id)?.(message);
    this.waiting.delete(message.id);
  }

  raw(line) {
    this.child.stdin.write(`${line}\n`);
  }

  ask(method, params) {
    const id = ++this.number;
    return new Promise((done) => {
      this.waiting.set(id, done);
      this.raw(JSON.stringify({ jsonrpc: '2.0', id, method, params }));
    });
  }

  async begin() {
    const { result } = await this.ask('initialize', {
      protocolVersion: '2025-06-18',
      capabilities: {},
      clientInfo: { name: 'test', version: '1' },
    });
    this.raw(JSON.stringify({ jsonrpc: '2.0', method: 'notifications/initialized' }));
    return result;
  }

  /** What a tool says, and whether it failed. */
  async call(name, args = {}) {
    const { result } = await this.ask('tools/call', { name, arguments: args });
    return { text: result.content[0].text, failed: result.isError };
  }

  end() {
    const code = new Promise((done) => this.child.on('exit', done));
    this.child.stdin.end();
    return code;
  }
}

const groupsOf = (text) => text.split('\n').filter((line) => line.startsWith('Group '));
const timeOf = (text) => Number(/Time: ([\d.]+) s/.exec(text)[1]);

export async function mcpTests({ test, check, start, program }) {
  const studio = await start('market', '--port', '18080');
  const model = new McpClient(program, `ws://127.0.0.1:${studio.port}`);
  const half = 'half of North to the fountain in a ring, the rest hold';
  const look = async () => (await model.call('look')).text;

  await test('mcp: greets, lists its tools, and names what is wrong with a request', async () => {
    const greeting = await model.begin();
    check(greeting.protocolVersion === '2025-06-18' && greeting.capabilities.tools, JSON.stringify(greeting));
    check(greeting.serverInfo.name === 'muster' && greeting.instructions.length > 50, 'who it is');
    const { tools } = (await model.ask('tools/list')).result;
    check(tools.map(({ name }) => name).join() === 'look,say,do,undo,redo,play,pause', 'tools');
    check(tools.every(({ inputSchema, description }) => inputSchema.type === 'object' && description), 'schemas');
    check(JSON.stringify((await model.ask('ping')).result) === '{}', 'ping');
    check((await model.ask('prompts/list')).error.code === -32601, 'a method that is not there');
    check((await model.ask('tools/call', { name: 'fly' })).error.code === -32602, 'a tool that is not there');
    model.raw('{"jsonrpc":');
    check(await eventually(() => model.lines.at(-1).error?.code === -32700), 'text that is no JSON');
    model.raw('[1]');
    check(await eventually(() => model.lines.at(-1).error?.code === -32600), 'what is no request');
  });

  await test('mcp: looks, and hears what a sentence would do', async () => {
    const seen = await look();
    check(groupsOf(seen).length === 2 && seen.includes('Fountain: at ('), seen);
    const { text, failed } = await model.call('say', { sentence: half, preview: true });
    check(!failed && text.includes('32 of North go to Fountain in a ring.') && text.includes('would arrive in'), text);
    check(groupsOf(await look()).length === 2, 'a preview changes nothing');
    const wrong = await model.call('say', { sentence: 'North go to the fountin' });
    check(wrong.failed && wrong.text === '“fountin”: did you mean Fountain?', wrong.text);
  });

  await test('mcp: directs by a sentence, as a director whom others see', async () => {
    const watcher = await RawSocket.open(studio.port);
    watcher.write(hello());
    const names = () => watcher.messages.filter((bytes) => bytes[0] === fromServer.Directors).at(-1)?.toString('utf8');
    check(await eventually(() => names()?.includes('Assistant')), 'others see the assistant');
    const { failed, text } = await model.call('say', { sentence: half });
    check(!failed, text);
    check(await eventually(async () => groupsOf(await look()).length === 3), 'a group for the part');
    const groups = groupsOf(await look());
    check(groups[0].includes('32 people') && groups[0].includes('holding'), groups[0]);
    check(groups[2].includes('32 people') && groups[2].includes('Orders: go to'), groups[2]);
    watcher.close();
  });

  await test('mcp: takes back its step, and does it again', async () => {
    check(!(await model.call('undo')).failed, 'undo');
    check(await eventually(async () => groupsOf(await look()).length === 2), 'one group again');
    check(!groupsOf(await look())[0].includes('holding'), 'it holds no more');
    await model.call('redo');
    check(await eventually(async () => groupsOf(await look()).length === 3), 'done again');
    await model.call('undo');
    const none = await model.call('undo');
    check(none.failed && none.text.includes('nothing to take back'), none.text);
  });

  await test('mcp: gives exact commands, stops time, and lets it go on', async () => {
    const group = Number(/^Group (\d+) South/.exec(groupsOf(await look())[1])[1]);
    const good = await model.call('do', { commands: [{ kind: 'move', group, x: 0, y: -20 }] });
    check(!good.failed, good.text);
    check(await eventually(async () => groupsOf(await look())[1].includes('go to (0, -20)')), 'the order is there');
    const bad = await model.call('do', { commands: [{ kind: 'move', group, x: 'far', y: 0 }] });
    check(bad.failed && bad.text.includes('.x'), bad.text);
    const gone = await model.call('do', { commands: [{ kind: 'move', group: 99, x: 0, y: 0 }] });
    check(gone.failed && gone.text.length > 5, gone.text);
    await model.call('pause');
    const stood = timeOf(await look());
    await model.call('say', { sentence: 'South face north', preview: true });
    check(timeOf(await look()) === stood, 'time stands');
    await model.call('play');
    check(await eventually(async () => timeOf(await look()) > stood), 'time goes on');
  });

  studio.child.removeAllListeners('exit');
  const ended = new Promise((done) => studio.child.on('exit', done));
  studio.child.kill('SIGINT');
  await ended;
  await test('mcp: tells that no studio answers, and ends with its input', async () => {
    check(await eventually(async () => (await model.call('look')).text.startsWith('No studio answers at')), 'no studio');
    check((await model.end()) === 0, 'exit code');
  });
  for (const [what, greet] of [
    ['takes the connection and says nothing', () => {}],
    ['shakes hands and says nothing', shakeHands],
  ])
    await test(`mcp: hears in bounded time that nobody answers where a server ${what}`, () => silence(program, greet, check));
}

/** The answer to a WebSocket's request. */
function shakeHands(socket) {
  socket.on('data', (bytes) => {
    const key = /Sec-WebSocket-Key: (.*)\r\n/i.exec(bytes.toString('latin1'))?.[1];
    if (!key) return;
    const accept = createHash('sha1').update(`${key}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`).digest('base64');
    const fields = ['Upgrade: websocket', 'Connection: Upgrade', `Sec-WebSocket-Accept: ${accept}`];
    socket.write(['HTTP/1.1 101 Switching Protocols', ...fields, `Sec-WebSocket-Protocol: ${kSubprotocol}`, '', ''].join('\r\n'));
  });
}

/** A server that greets and is silent: the assistant says so, and is still there. */
async function silence(program, greet, check) {
  const open = [];
  const server = createServer((socket) => {
    open.push(socket);
    socket.on('error', () => {});
    greet(socket);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const model = new McpClient(program, `ws://127.0.0.1:${server.address().port}`);
  await model.begin();
  const answered = await Promise.race([model.call('undo'), new Promise((done) => setTimeout(done, kPatience, null))]);
  if (!answered) model.child.kill('SIGKILL');
  const sentence = `What listens at 127.0.0.1:${server.address().port} does not answer as a studio does: start one with 'muster studio'.`;
  for (const socket of open) socket.destroy();
  server.close();
  check(answered?.failed && answered.text === sentence, answered?.text ?? 'no answer at all');
  check(JSON.stringify((await model.ask('ping')).result) === '{}', 'it is still there');
  check((await model.end()) === 0, 'exit code');
}

/** These tests alone. */
async function alone() {
  const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
  const program = resolve(process.argv[2] ?? join(root, 'build/release/muster'));
  const place = mkdtempSync(join(tmpdir(), 'muster-mcp-'));
  writeFileSync(join(place, 'index.html'), '<p>page</p>');
  let failed = 0;
  const test = async (name, run) => {
    await run().then(
      () => console.log(`passed ${name}`),
      (error) => console.log(`FAILED ${name}: ${error.message}`, (failed += 1)),
    );
  };
  const check = (condition, what) => {
    if (!condition) throw new Error(what);
  };
  const start = (...options) => {
    const child = spawn(program, ['studio', ...options, '--page', place, '--scenarios', join(root, 'scenarios')], { cwd: place });
    return new Promise((done) =>
      child.stdout.on('data', (chunk) => {
        const found = /127\.0\.0\.1:(\d+)/.exec(chunk);
        if (found) done({ child, port: Number(found[1]) });
      }),
    );
  };
  await mcpTests({ test, check, start, program });
  rmSync(place, { recursive: true, force: true });
  process.exit(failed === 0 ? 0 : 1);
}
if (process.argv[1] === fileURLToPath(import.meta.url)) await alone();
