// The shelf of takes and exports over HTTP: who may, each limit at its edge, and what is kept.
import { mkdirSync, readFileSync, readdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { RawSocket, ack, eventually, fromClient, fromServer, hello, request } from './client.mjs';

const kPng = Buffer.from('89504e470d0a1a0a0000000d49484452', 'hex');

/** A Record message. */
const record = (on) => Buffer.from([fromClient.Record, on ? 1 : 0]);

/** Lets the world play for so long, with a client that looks at it. */
async function playFor(socket, ms) {
  const end = Date.now() + ms;
  await socket.message(fromServer.Frame);
  while (Date.now() < end) {
    const frame = socket.messages.findLast((bytes) => bytes[0] === fromServer.Frame);
    socket.write(ack(frame.readUInt32LE(1)));
    await new Promise((done) => setTimeout(done, 20));
  }
}

/** Runs these tests; `start(...options)` starts a studio. */
export async function takesTests({ test, check, start, place }) {
  const folder = join(place, 'shelf');
  mkdirSync(folder, { recursive: true });
  let studio = await start('--port', '18680', '--takes', folder);
  const ask = (method, path, body, headers = {}) =>
    request(studio.port, method, path, { Origin: `http://127.0.0.1:${studio.port}`, ...headers }, body);
  const json = (method, path, value, headers) => ask(method, path, value === undefined ? undefined : JSON.stringify(value), headers);
  const takes = async () => JSON.parse((await ask('GET', '/takes')).body).takes;

  /** Records for so long; the name of the take. */
  async function recordTake(ms) {
    const socket = await RawSocket.open(studio.port);
    socket.write(hello());
    await playFor(socket, 100);
    socket.write(record(true));
    await playFor(socket, ms);
    socket.write(record(false));
    check(await socket.message(fromServer.TakeKept), 'it is told that the take is kept');
    socket.close();
    return (await takes())[0].name;
  }

  await test('takes: a recording is on the shelf, whole, from the moment it was begun', async () => {
    check((await takes()).length === 0, 'an empty shelf');
    const name = await recordTake(600);
    const [take] = await takes();
    check(take.finished && !take.recording && take.from > 0 && take.seconds > 0.3, JSON.stringify(take));
    const file = await ask('GET', `/takes/${name}`);
    check(file.status === 200 && file.body.startsWith('MUSTAKE'), 'its file');
    check(file.headers['content-disposition'] === `attachment; filename="${name}"`, file.headers['content-disposition']);
    check(file.headers['x-content-type-options'] === 'nosniff', 'files have the security headers');
    const head = await ask('HEAD', `/takes/${name}`);
    check(head.status === 200 && head.body === '' && Number(head.headers['content-length']) > 100, 'HEAD');
    check((await ask('POST', `/takes/${name}/open`, '')).status === 200, 'it opens');
  });

  await test('takes: title and part are kept with the file', async () => {
    const [{ name, steps }] = await takes();
    check((await json('PATCH', `/takes/${name}`, { title: 'Rain', from: 3, to: 20, speeds: [{ from: 0, to: 1, speed: 0.5, ease: 0 }] })).status === 200, 'PATCH');
    const [take] = await takes();
    check(take.title === 'Rain' && take.from === 3 && take.to === 20 && take.steps === steps, JSON.stringify(take));
    check(take.speeds.length === 1 && take.speeds[0].speed === 0.5, 'speeds');
    for (const [value, words] of [[{ title: 'a'.repeat(201) }, 'title'], [{ from: 9, to: 9 }, 'to'], [[], 'object'], [{ speeds: [{ from: 0, to: 1, speed: 99 }] }, 'speed']]) {
      const answer = await json('PATCH', `/takes/${name}`, value);
      check(answer.status === 400 && answer.body.includes(words), `${JSON.stringify(value)}: ${answer.status} ${answer.body}`);
    }
    check((await ask('PATCH', `/takes/${name}`, 'x'.repeat(16 * 1024 + 1))).status === 413, 'too long a text');
    check((await takes())[0].title === 'Rain', 'what is refused changes nothing');
  });

  await test('takes: pictures are PNG and small', async () => {
    const [{ name }] = await takes();
    const path = `/takes/${name}/picture`;
    check((await ask('GET', path)).status === 404, 'no picture yet');
    check((await ask('PUT', path, kPng)).status === 200, 'a picture');
    const picture = await ask('GET', path);
    check(picture.status === 200 && picture.headers['content-type'] === 'image/png', 'it comes back');
    check((await takes())[0].picture, 'the list knows');
    check((await ask('PUT', path, '<svg onload="alert(1)"/>')).status === 400, 'no other kind');
    const most = 512 * 1024;
    check((await ask('PUT', path, Buffer.concat([kPng, Buffer.alloc(most - kPng.length)]))).status === 200, 'the limit');
    check((await ask('PUT', path, Buffer.concat([kPng, Buffer.alloc(most - kPng.length + 1)]))).status === 413, 'one byte more');
  });

  await test('takes: removed and brought back', async () => {
    const [{ name }] = await takes();
    check((await ask('DELETE', `/takes/${name}`)).status === 200, 'DELETE');
    check((await takes()).length === 0 && (await ask('GET', `/takes/${name}`)).status === 404, 'it is gone');
    check(readdirSync(join(folder, 'removed')).includes(name), 'its file is not');
    check((await ask('POST', `/takes/${name}/restore`, '')).status === 200, 'restore');
    check((await takes())[0].name === name && (await takes())[0].picture, 'it is back, with its picture');
    check((await ask('POST', `/takes/${name}/restore`, '')).status === 404, 'once only');
  });

  await test('takes: a file is put on the shelf once, and only a take', async () => {
    const [{ name }] = await takes();
    const bytes = readFileSync(join(folder, name));
    const again = await ask('POST', '/takes', bytes);
    check(again.status === 200 && JSON.parse(again.body).name === name, `the same file is there already: ${again.body}`);
    check((await ask('POST', '/takes', 'no take')).status === 400, 'no take');
    check((await takes()).length === 1, 'one take');
  });

  await test('takes: only from this page', async () => {
    const [{ name }] = await takes();
    const foreign = { Origin: 'http://evil.example' };
    for (const [method, path, body] of [['POST', '/takes', 'x'], ['PATCH', `/takes/${name}`, '{}'], ['DELETE', `/takes/${name}`], ['POST', `/takes/${name}/open`, ''],
      ['PUT', `/takes/${name}/picture`, kPng], ['POST', '/exports', '{}'], ['DELETE', '/exports/1']]) {
      check((await ask(method, path, body, foreign)).status === 403, `${method} ${path} of another origin`);
      check((await ask(method, path, body, { Origin: null })).status === 403, `${method} ${path} of none`);
    }
    for (const path of ['/takes', `/takes/${name}`, `/takes/${name}/picture`, '/exports/1', '/exports/1/file']) {
      check((await request(studio.port, 'GET', path, { 'Sec-Fetch-Site': 'cross-site' })).status === 403, `${path} of another site`);
      check((await ask('GET', path, undefined, foreign)).status === 403, `${path} of another origin`);
    }
    check((await request(studio.port, 'GET', '/takes', { Host: 'evil.example' })).status === 403, 'another Host');
    check((await takes()).length === 1, 'nothing was changed');
  });

  await test('takes: names lead nowhere else', async () => {
    writeFileSync(join(place, 'secret.take'), 'MUSTAKE secret');
    symlinkSync(join(place, 'secret.take'), join(folder, 'link.take'));
    for (const name of ['../secret.take', '..%2fsecret.take', 'link.take', '.take', 'removed', 'a.png', 'secret', '..', 'a b.take', 'a.take%00']) {
      for (const path of [`/takes/${name}`, `/takes/${name}/picture`]) {
        const answer = await ask('GET', path);
        check(answer.status >= 400 && !answer.body.includes('secret\n') && !answer.body.startsWith('MUSTAKE'), `${path}: ${answer.status}`);
      }
      check((await ask('DELETE', `/takes/${name}`)).status >= 400, `DELETE ${name}`);
    }
    check(readFileSync(join(place, 'secret.take'), 'utf8') === 'MUSTAKE secret', 'the secret is as it was');
    for (const [method, path] of [['PUT', '/takes'], ['GET', '/takes/'], ['TRACE', '/takes'], ['POST', '/takes/a.take/none'], ['DELETE', '/exports']])
      check((await ask(method, path, '')).status === 405, `${method} ${path}`);
  });

  await test('exports: made, followed, fetched and cancelled', async () => {
    const [{ name }] = await takes();
    const begun = await json('POST', '/exports', { take: name, format: 'pedpy', fps: 10 });
    check(begun.status === 200, begun.body);
    const { number } = JSON.parse(begun.body);
    const report = async () => JSON.parse((await ask('GET', `/exports/${number}`)).body);
    check(await eventually(async () => (await report()).state === 'done'), 'it is done');
    const done = await report();
    check(done.share === 1 && done.bytes > 50 && done.file === 'Rain.txt', JSON.stringify(done));
    const file = await ask('GET', `/exports/${number}/file`);
    check(file.status === 200 && file.headers['content-disposition'].includes('Rain.txt'), 'its file');
    check((await ask('DELETE', `/exports/${number}`)).status === 200, 'it is forgotten');
    check((await ask('GET', `/exports/${number}`)).status === 404 && (await ask('GET', `/exports/${number}/file`)).status === 404, 'and gone');
    for (const [value, words] of [[{ take: name, format: 'doc' }, 'format'], [{ take: 'none.take', format: 'glb' }, 'none.take'], [{ take: name }, 'format'],
      [{ take: name, format: 'glb', fps: 'x' }, 'fps'], [3, 'object']]) {
      const answer = await json('POST', '/exports', value);
      check(answer.status >= 400 && answer.body.includes(words), `${JSON.stringify(value)}: ${answer.status} ${answer.body}`);
    }
    const bad = JSON.parse((await json('POST', '/exports', { take: name, format: 'glb', fps: 999 })).body);
    const failed = async () => JSON.parse((await ask('GET', `/exports/${bad.number}`)).body);
    check(await eventually(async () => (await failed()).state === 'failed'), 'a bad part fails');
    check((await failed()).problem.includes('fps'), 'and says why');
  });

  await test('takes: a killed server loses none, and says which was cut off', async () => {
    const socket = await RawSocket.open(studio.port);
    socket.write(hello());
    socket.write(Buffer.concat([Buffer.from([fromClient.LoadScenario, 4, 0, 0, 0]), Buffer.from('open')]));
    await playFor(socket, 200);
    socket.write(record(true));
    await playFor(socket, 1500);
    const recording = (await takes())[0];
    check(recording.recording && !recording.finished, JSON.stringify(recording));
    check((await ask('DELETE', `/takes/${recording.name}`)).status === 400, 'nobody removes what is being recorded');
    check((await json('PATCH', `/takes/${recording.name}`, { title: 'x' })).status === 400, 'nor names it');
    studio.child.removeAllListeners('exit');
    studio.child.kill('SIGKILL');
    await new Promise((done) => studio.child.on('exit', done));
    studio = await start('--port', '18690', '--takes', folder);
    const all = await takes();
    check(all.length === 2 && all.some((take) => take.finished && take.title === 'Rain'), JSON.stringify(all));
    const cut = all.find((take) => !take.finished);
    check(cut && !cut.recording && cut.name === recording.name && cut.steps > 30, JSON.stringify(cut));
    check((await json('PATCH', `/takes/${cut.name}`, { title: 'Saved' })).status === 200, 'it takes a name');
    check((await ask('POST', `/takes/${cut.name}/open`, '')).status === 200, 'it plays');
    const begun = JSON.parse((await json('POST', '/exports', { take: cut.name, format: 'pedpy' })).body);
    check(await eventually(async () => JSON.parse((await ask('GET', `/exports/${begun.number}`)).body).state === 'done'), 'it is exported');
  });
  studio.child.removeAllListeners('exit');
  studio.child.kill('SIGINT');
}
