// The server of the study: its page, what it has not, and runs that begin, are lost and come back over real sockets.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { RawSocket, fromClient, fromServer, hello, readNotice, request } from './client.mjs';

const text = (words) => {
  const bytes = Buffer.from(words);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(bytes.length);
  return Buffer.concat([length, bytes]);
};
const enter = (token = '') => Buffer.concat([Buffer.from([fromClient.EnterStudy]), text(token)]);
const act = (number) => Buffer.from([fromClient.DoInStudy, number]);

/** Consent with that answer. */
function consent(answer) {
  const count = Buffer.from([1, 0, 0, 0]);
  const number = Buffer.alloc(8);
  return Buffer.concat([Buffer.from([fromClient.AnswerForm]), text('consent'), count, text('agree'), text(answer), number]);
}

/** Stage, token and number of the newest StudyState. */
function stateOf(socket) {
  const bytes = socket.messages.findLast((one) => one[0] === fromServer.StudyState);
  if (!bytes) return null;
  const length = bytes.readUInt32LE(2);
  return { stage: bytes[1], token: bytes.subarray(6, 6 + length).toString(), run: bytes.readUInt32LE(6 + length) };
}

/** Runs these tests with the program. */
export async function studyTests({ test, check, program, place }) {
  const page = join(place, 'study-page');
  mkdirSync(page, { recursive: true });
  writeFileSync(join(page, 'index.html'), '<!doctype html><html lang="en"><p>page</p></html>');
  const db = join(place, 'study.db');
  const child = spawn(program, ['study', 'run', '--db', db, '--test', '--json', '--page', page, '--port', '18580']);
  const port = await new Promise((resolve, reject) => {
    let out = '';
    child.stdout.on('data', (chunk) => {
      out += chunk;
      if (out.includes('\n')) resolve(JSON.parse(out).port);
    });
    child.on('exit', (code) => reject(new Error(`the study ended with ${code}`)));
  });
  const here = `http://127.0.0.1:${port}`;
  const open = async (token) => {
    const socket = await RawSocket.open(port);
    check(socket.status === 101, `handshake: ${socket.status}`);
    socket.write(hello());
    socket.write(enter(token));
    check(await socket.message(fromServer.StudyState), 'no state came');
    return socket;
  };

  await test('study: the page learns what it shows; there are no takes', async () => {
    for (const path of ['/', '/index.html']) {
      const index = await request(port, 'GET', path);
      check(index.status === 200 && index.body.includes('<html data-mode="study" lang="en">'), `${path}: ${index.body}`);
    }
    check((await request(port, 'GET', '/take')).status === 404, 'GET /take');
    check((await request(port, 'GET', '/takes')).status === 404, 'GET /takes');
    const upload = await request(port, 'POST', '/take', { Origin: here }, Buffer.from('x'));
    check(upload.status === 404, `POST /take: ${upload.status}`);
  });

  await test('study: the same doors as the studio', async () => {
    check((await request(port, 'GET', '/', { Host: `evil.example:${port}` })).status === 403, 'Host');
    check((await RawSocket.open(port, { Origin: 'http://evil.example' })).status === 403, 'Origin');
    check((await RawSocket.open(port, { 'Sec-WebSocket-Protocol': 'muster.v1' })).status === 400, 'subprotocol');
  });

  await test('study: a run begins with consent and comes back by its token alone', async () => {
    const socket = await open();
    check(stateOf(socket).run === 0 && stateOf(socket).token === '', 'nothing has begun');
    socket.write(consent('no'));
    check(await socket.until((self) => self.notices().length === 1), 'a wrong answer is told');
    check(readNotice(socket.messages.find((one) => one[0] === fromServer.Notice)).includes('none of its choices'), 'by a sentence');
    socket.write(consent('yes'));
    check(await socket.until((self) => stateOf(self).run === 1), 'the run begins');
    const { token } = stateOf(socket);
    check(/^[0-9a-f]{32}$/.test(token), `a token of 128 bits: ${token}`);
    socket.close();
    const guess = await open(token.slice(1));
    check(stateOf(guess).run === 0, 'another token is no way in');
    const back = await open(token);
    check(stateOf(back).run === 1, 'its token is');
    guess.close();
    back.close();
  });

  await test('study: what is not due is refused, and large messages close', async () => {
    const socket = await open();
    socket.write(act(0));
    check(await socket.until((self) => self.notices().length >= 1), 'no trial waits');
    socket.write(Buffer.from([fromClient.LoadScenario, 0, 0, 0, 0]));
    check(await socket.until((self) => self.notices().length >= 2), 'a message of the studio');
    socket.write(Buffer.alloc(64 * 1024 + 1, fromClient.Inputs));
    check(await socket.until((self) => self.closed || self.closeCode === 1009), 'too large a message');
  });

  await test('study: the end of the server marks runs as broken off', async () => {
    child.removeAllListeners('exit');
    const ended = new Promise((resolve) => child.on('exit', resolve));
    child.kill('SIGINT');
    check((await ended) === 0, 'it ends well');
    const out = join(place, 'study-csv');
    const { status, stderr } = spawnSync(program, ['study', 'export', '--db', db, '-o', out], { encoding: 'utf8' });
    check(status === 0, `export: ${stderr}`);
    const { stdout } = spawnSync('cat', [join(out, 'runs.csv')], { encoding: 'utf8' });
    check(/^1,test,broken-off,/m.test(stdout), stdout);
  });
}
