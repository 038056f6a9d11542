// The place over HTTP: its file, an edited one, opening others, and what is refused.
import { writeFileSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { RawSocket, eventually, fromClient, fromServer, hello, request } from './client.mjs';

const word = (value) => {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32LE(value, 0);
  return bytes;
};

/** The bytes of a PutThing that adds an item. */
function putItem(x, y, radius) {
  const item = Buffer.alloc(24);
  [x, y, radius].forEach((value, at) => item.writeDoubleLE(value, 8 * at));
  const [kPutThing, given, none] = [47, 1, 0];
  return Buffer.concat([Buffer.from([kPutThing]), word(0), Buffer.from([none, none, given]), item, Buffer.from([none, none]), word(0)]);
}

/** An Edit message with one command. */
function edit(label, command) {
  const text = Buffer.from(label);
  return Buffer.concat([Buffer.from([fromClient.Edit]), word(text.length), text, word(0), word(command.length), command, word(0)]);
}

/** Runs these tests; `start(...options)` starts a studio. */
export async function placesTests({ test, check, start, program, place }) {
  const studio = await start('--port', '18720');
  const origin = { Origin: `http://127.0.0.1:${studio.port}` };
  const get = (headers = {}) => request(studio.port, 'GET', '/scenario', headers);
  const post = (text, name = 'mine', headers = origin) => request(studio.port, 'POST', `/scenario?name=${name}`, { 'Content-Length': String(text.length), ...headers }, Buffer.from(text, 'latin1'));

  await test('places: the scenario is a file that the program plays', async () => {
    const file = await get();
    check(file.status === 200 && file.headers['content-type'] === 'application/json', `${file.status}`);
    check(/^attachment; filename="[\w-]+\.json"$/.test(file.headers['content-disposition']), file.headers['content-disposition']);
    const path = join(place, 'saved.json');
    writeFileSync(path, file.body);
    const played = spawnSync(program, ['play', path, '--seconds', '0.5', '--json'], { encoding: 'utf8' });
    check(played.status === 0, played.stderr);
  });

  await test('places: edits are in the file, which opens again under its name', async () => {
    const before = JSON.parse((await get()).body);
    const socket = await RawSocket.open(studio.port);
    socket.write(hello());
    await socket.message(fromServer.Frame);
    socket.write(edit('Add item', putItem(1, 1, 0.4)));
    const history = await socket.message(fromServer.EditHistory);
    check(history.readUInt32LE(1) === 1, 'one step can be taken back');
    const there = await eventually(async () => {
      const items = JSON.parse((await get()).body).items ?? [];
      return items.length === (before.items ?? []).length + 1;
    });
    check(there, 'the item is in the file');
    const { body } = await get();
    const answer = await post(body, 'my-place');
    check(answer.status === 200, answer.body);
    const again = await get();
    check(again.headers['content-disposition'] === 'attachment; filename="my-place.json"', again.headers['content-disposition']);
    check(again.body === body, 'the same file');
    socket.close();
  });

  await test('places: bad files are refused in one sentence, and the place stays', async () => {
    const before = (await get()).body;
    for (const text of ['', '{', '[]', '{"format":"muster-scenario","version":1,"groups":7}', '\xff\xfe']) {
      const answer = await post(text, 'bad');
      check(answer.status === 400 && answer.body.trim().split('\n').length === 1, `${answer.status} ${answer.body}`);
    }
    check((await get()).body === before, 'unchanged');
  });

  await test('places: other sites may neither read nor open', async () => {
    check((await get({ Origin: 'http://evil.example' })).status === 403, 'reading');
    check((await get({ 'Sec-Fetch-Site': 'cross-site' })).status === 403, 'reading by another site');
    check((await post('{}', 'x', {})).status === 403, 'without an origin');
    check((await post('{}', 'x', { Origin: 'http://evil.example' })).status === 403, 'from another origin');
  });
  studio.child.removeAllListeners('exit');
  studio.child.kill('SIGINT');
}
