// The studio as a process: what it tells, what it starts, how it ends.
import { spawn } from 'node:child_process';
import { chmodSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import net from 'node:net';
import { networkInterfaces } from 'node:os';
import { join } from 'node:path';
import { RawSocket, dial, eventually, fromClient, fromServer, hello, ping } from './client.mjs';

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** Runs the program to its end. */
function ended(child) {
  return new Promise((done) => {
    let error = '';
    child.stderr?.on('data', (chunk) => (error += chunk));
    child.on('exit', (code) => done({ code, error }));
  });
}

/** A LoadScenario message. */
function load(name) {
  const bytes = Buffer.alloc(5 + name.length);
  bytes[0] = fromClient.LoadScenario;
  bytes.writeUInt32LE(name.length, 1);
  bytes.write(name, 5);
  return bytes;
}

async function greeted(port) {
  const socket = await RawSocket.open(port);
  socket.write(hello());
  await socket.message(fromServer.Frame);
  return socket;
}

/** Whether nobody takes a connection there. */
function refused(port, address) {
  return new Promise((done) => {
    const socket = net.connect(port, address, () => { socket.destroy(); done(false); });
    socket.on('error', () => done(true));
  });
}

/** Ends a studio with signals 100 ms apart; its exit code and how long it took. */
async function interrupt(studio, signals) {
  studio.child.removeAllListeners('exit');
  const end = new Promise((done) => studio.child.on('exit', done));
  const began = Date.now();
  for (let i = 0; i < signals; ++i) {
    studio.child.kill('SIGINT');
    await sleep(100);
  }
  return { code: await end, ms: Date.now() - began };
}

/** Runs these tests; `start(...options)` starts a studio, `common` are the options that it always gets. */
export async function processTests({ test, check, start, program, common, place }) {
  await test('--json tells address and port as one value', async () => {
    const child = spawn(program, ['studio', '--port', '18580', '--json', ...common], { cwd: place, stdio: ['ignore', 'pipe', 'inherit'] });
    let text = '';
    child.stdout.on('data', (chunk) => (text += chunk));
    await eventually(() => text.includes('}'));
    const value = JSON.parse(text);
    check(value.address === `http://127.0.0.1:${value.port}/` && value.port >= 18580, text);
    const end = ended(child);
    child.kill('SIGINT');
    check((await end).code === 0, 'exit code');
  });

  await test('without its page the studio says so and does not start', async () => {
    mkdirSync(join(place, 'empty'), { recursive: true });
    const options = common.map((option, i) => (common[i - 1] === '--page' ? join(place, 'empty') : option));
    const { code, error } = await ended(spawn(program, ['studio', '--port', '18580', ...options], { cwd: place, stdio: ['ignore', 'ignore', 'pipe'] }));
    check(code === 1 && /^muster studio: .*index\.html.*\n$/.test(error), `${code}: ${error}`);
  });

  await test('the browser gets a session of its own and none of our files', async () => {
    const bin = join(place, 'bin');
    const told = join(place, 'browser.txt');
    mkdirSync(bin, { recursive: true });
    writeFileSync(join(bin, 'xdg-open'), `#!/bin/sh\n{ echo "address $1"; cut -d' ' -f6 /proc/$$/stat; ls -l /proc/$$/fd; } >'${told}.part'\nmv '${told}.part' '${told}'\n`);
    chmodSync(join(bin, 'xdg-open'), 0o755);
    const env = { ...process.env, DISPLAY: ':9', PATH: `${bin}:${process.env.PATH}` };
    const studio = await start({ env }, '--port', '18580', '--open');
    const other = await dial(studio.port);
    check(await eventually(() => existsSync(told)), 'the browser was not started');
    const [address, session, ...files] = readFileSync(told, 'latin1').trim().split('\n');
    check(address === `address http://127.0.0.1:${studio.port}/`, address);
    const ours = readFileSync(`/proc/${studio.child.pid}/stat`, 'latin1').split(' ')[5];
    check(session !== ours, `the session ${session}`);
    check(!files.some((line) => /socket:|eventpoll|pipe:/.test(line)), files.join('\n'));  // Its own script and file only.
    other.destroy();
    await interrupt(studio, 1);
  });

  await test('scenarios loaded without end neither freeze the studio nor hold up Ctrl+C', async () => {
    const studio = await start('--port', '18580');
    const socket = await greeted(studio.port);
    for (let i = 0; i < 700; ++i) socket.write(load(i % 2 ? 'course' : 'woodland'));
    const asked = Date.now();
    socket.write(ping(5));
    check(await socket.message(fromServer.Pong), 'no answer');
    console.log(`measured: answered ${Date.now() - asked} ms after 700 scenarios were asked for`);
    for (let i = 0; i < 90; ++i) socket.write(load(i % 2 ? 'course' : 'woodland'));
    const { code, ms } = await interrupt(studio, 1);
    check(code === 0, `ended with ${code}`);
    console.log(`measured: ended ${ms} ms after Ctrl+C, with 90 scenarios waiting`);
  });

  await test('Ctrl+C twice ends it at once, whatever it does', async () => {
    const folder = join(place, 'vast');
    mkdirSync(folder, { recursive: true });
    const vast = { format: 'muster-scenario', version: 1, box: [[-500, -500], [500, 500]], cell: 0.5, groups: [{ count: 9 }] };
    for (let i = 0; i < 300; ++i) (vast.obstacles ??= []).push({ centre: [(i % 20) * 45 - 430, Math.floor(i / 20) * 60 - 430], radius: 5 });
    writeFileSync(join(folder, 'vast.json'), JSON.stringify(vast));
    writeFileSync(join(folder, 'open.json'), JSON.stringify({ format: 'muster-scenario', version: 1, groups: [{ count: 1 }] }));
    const studio = await start('--port', '18580', '--scenarios', folder);
    const socket = await greeted(studio.port);
    socket.write(load('vast'));
    await sleep(300);
    const { code, ms } = await interrupt(studio, 2);
    check(code === 130 || code === 0, `ended with ${code}`);
    console.log(`measured: ended ${ms} ms after the first of two Ctrl+C, while a vast scenario was made ready`);
  });

  await test('nobody listens but on the loopback address', async () => {
    const studio = await start('--port', '18580');
    const others = Object.values(networkInterfaces()).flat().filter((address) => address.family === 'IPv4' && !address.internal);
    for (const { address } of others) check(await refused(studio.port, address), address);
    check(await refused(studio.port, '127.0.0.2') && !(await refused(studio.port, '127.0.0.1')), '127.0.0.2');
    await interrupt(studio, 1);
  });

  await test('connections: 128 stay, one more is closed at once, and where one goes there is room', async () => {
    const studio = await start('--port', '18580');
    const open = [];
    const add = async () => {
      const socket = await dial(studio.port);
      socket.on('close', () => (socket.gone = true));
      socket.on('end', () => socket.destroy());
      socket.on('error', () => undefined);
      socket.resume();
      open.push(socket);
      return socket;
    };
    for (let i = 0; i < 128; ++i) await add();
    const extra = await add();
    check(await eventually(() => extra.gone), 'the 129th stays');
    check(open.filter((socket) => socket.gone).length === 1, 'another one was closed');
    open[0].destroy();
    // The studio sees that one has gone when it gets to it; until then it closes newcomers.
    let next = await add();
    for (let i = 0; i < 50 && (await sleep(100), next.gone); ++i) next = await add();
    check(!next.gone, 'there is no room again');
    for (const socket of open) socket.destroy();
    await interrupt(studio, 1);
  });
}
