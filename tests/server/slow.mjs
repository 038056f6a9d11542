// What takes long to see; each starts a studio of its own, so that all can go on beside the other tests.
import { writeFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { RawSocket, ack, dial, fromClient, fromServer, hello } from './client.mjs';

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

async function stop(studio) {
  studio.child.removeAllListeners('exit');
  studio.child.kill('SIGINT');
}

/** How two silent clients fare for half a minute, one that answers pings and one that does not. */
export async function watchSilence(start) {
  const studio = await start('--port', '18280');
  const alive = await RawSocket.open(studio.port);
  const dead = await RawSocket.open(studio.port);
  dead.answersPings = false;
  const began = Date.now();
  await dead.until((self) => self.closed, 120000);
  const result = { ms: Date.now() - began, pings: dead.pings, deadClosed: dead.closed, aliveClosed: alive.closed, alivePings: alive.pings };
  alive.close();
  stop(studio);
  return result;
}

/** Posts twelve bytes one by one, the last after `seconds`; the answer and when the connection ended. */
async function trickle(port, seconds) {
  const socket = await dial(port);
  const began = Date.now();
  let text = '';
  let ended = 0;
  const closed = new Promise((done) => {
    socket.on('data', (chunk) => (text += chunk));
    for (const event of ['end', 'close', 'error']) socket.on(event, () => { ended ||= Date.now(); done(); });
  });
  socket.write(`POST /take HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nOrigin: http://127.0.0.1:${port}\r\nConnection: close\r\nContent-Length: 12\r\n\r\n`);
  for (let i = 0; i < 12 && !ended; ++i) {
    if (i > 0) await Promise.race([sleep((seconds / 11) * 1000), closed]);
    if (!ended) socket.write('x');
  }
  await closed;
  socket.destroy();
  return { status: Number(text.split(' ')[1] ?? 0), ms: ended - began };
}

/** A body that comes within its minute, and one that does not. */
export async function watchBodies(start) {
  const studio = await start('--port', '18380');
  const [intime, late] = await Promise.all([trickle(studio.port, 50), trickle(studio.port, 66)]);
  stop(studio);
  return { intime, late };
}

/** SetOverlay of the potential field. */
const overlay = Buffer.from([fromClient.SetOverlay, 1, 0, 0, 0, 0]);

/** A client that asks for all it can get and reads nothing, beside one that reads: what the other had when the first was cut. */
export async function watchQueue(start, place) {
  const folder = join(place, 'wide');
  mkdirSync(folder);
  writeFileSync(join(folder, 'wide.json'), JSON.stringify({
    format: 'muster-scenario', version: 1, box: [[-32, -32], [32, 32]], cell: 0.25,
    obstacles: [{ centre: [9, 9], radius: 1 }], groups: [{ count: 1 }], parameters: { 'plan.mode': 2 },
  }));
  const studio = await start('--port', '18480', '--scenarios', folder);
  const reader = await RawSocket.open(studio.port);
  const stalled = await RawSocket.open(studio.port);
  stalled.socket.pause();
  for (const client of [reader, stalled]) client.write(hello()), client.write(overlay);
  const began = Date.now();
  // Frames are sent only where the one before is acknowledged: it guesses their numbers.
  for (let tick = 0; !stalled.closed && Date.now() - began < 90000; ++tick) {
    const newest = Math.floor(tick / 2) + 8;
    for (let frame = Math.max(1, newest - 15); frame <= newest && !stalled.closed; ++frame) stalled.write(ack(frame));
    await sleep(50);
    for (const message of reader.messages.splice(0)) {
      if (message[0] === fromServer.Frame) reader.write(ack(message.readUInt32LE(1)));
    }
  }
  const result = { cut: stalled.closed, mebibytes: reader.socket.bytesRead / 1048576, readerClosed: reader.closed };
  reader.close();
  stalled.close();
  stop(studio);
  return result;
}
