// Scenarios in folders, and watching what one carries.
import { spawnSync } from 'node:child_process';
import { readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ack, demonstrates, fromClient, fromServer, load, scenarioNames, stepOf } from './client.mjs';

const kName = 'paper/x01-area';
const kRestart = Buffer.from([fromClient.Playback, 3]);
const kDemonstrate = Buffer.from([fromClient.Playback, 4]);

/** Acknowledges frames until `test` holds of one; null after `most`. */
async function frameWith(socket, test, most = 200) {
  const frames = (self) => self.messages.filter((bytes) => bytes[0] === fromServer.Frame);
  for (let i = 0; i < most; ++i) {
    const seen = frames(socket).length;
    socket.write(ack(frames(socket).at(-1).readUInt32LE(1)));
    if (!await socket.until((self) => frames(self).length > seen)) return null;
    const newest = frames(socket).at(-1);
    if (test(newest)) return newest;
  }
  return null;
}

export async function demonstrationTests({ test, check, client, get, program, place }) {
  await test('scenarios of folders stand behind the others, under the names of both', async () => {
    const socket = await client();
    const names = scenarioNames(await socket.message(fromServer.Welcome));
    check(names.indexOf(kName) > names.indexOf('woodland') && names.includes('woodland'), names.join(' '));
    check(!names.some((name) => /gestures|schema/.test(name)), names.join(' '));
    socket.close();
  });

  await test('what a scenario carries is watched by all, and its take replays', async () => {
    const [asking, watching] = [await client(), await client()];
    asking.write(load(kName));
    asking.write(kDemonstrate);
    const runs = (frame) => demonstrates(frame) && stepOf(frame) > 40;
    check(await frameWith(watching, runs), 'another sees it run');
    const answer = await get('/take');
    check(/filename="paper-x01-area\.take"/.test(answer.headers['content-disposition']), answer.headers['content-disposition']);
    const file = join(place, 'watched.take');
    writeFileSync(file, answer.body, 'latin1');
    const replayed = spawnSync(program, ['replay', file], { encoding: 'utf8' });
    check(replayed.status === 0, `replay: ${replayed.status} ${replayed.stderr}`);
    watching.write(kRestart);
    check(await frameWith(asking, (frame) => !demonstrates(frame)), 'restarting ends it');
    watching.write(Buffer.from([fromClient.Record, 1]));
    check(await frameWith(asking, (frame) => frame.readFloatLE(22) >= 0), 'recording');
    const kept = readdirSync(join(place, 'takes')).filter((name) => name.startsWith('paper-x01-area-'));
    check(kept.length === 1, `takes: ${kept}`);
    asking.write(load('open'));
    check(await frameWith(watching, (frame) => !demonstrates(frame) && stepOf(frame) > 30), 'another scenario');
    asking.write(Buffer.from([fromClient.Playback, 9]));
    check(await asking.until((self) => self.notices().some((text) => text.startsWith('malformed'))), 'an unknown action');
    // The recording went on with the other scenario; what it had of this one was too short to be kept.
    asking.write(Buffer.from([fromClient.Record, 0]));
    check(await frameWith(watching, (frame) => frame.readFloatLE(22) < 0), 'not recording');
    rmSync(join(place, 'takes'), { recursive: true, force: true });
    asking.close();
    watching.close();
  });
}
