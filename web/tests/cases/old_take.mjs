// A take of another version of Muster, whose simulation gives other bits: it plays from its stored frames.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from '../support/expect.mjs';
import { pause, record, stop, timeLine } from './takes.mjs';

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let k = 0; k < 8; ++k) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/** The same take with other hashes, as a version with other results would have written it. */
export function ofAnotherVersion(take) {
  const bytes = Buffer.from(take);
  for (let at = 12; at + 9 < bytes.length;) {
    const length = bytes.readUInt32LE(at);
    const payload = bytes.subarray(at + 9, at + 9 + length);
    if (bytes[at + 4] === 3 || bytes[at + 4] === 4) {
      payload[4] ^= 1;
      bytes.writeUInt32LE(crc32(payload), at + 9 + length);
    }
    at += 13 + length;
  }
  return bytes;
}

export async function oldTake(studio, server) {
  await record(studio, 2);
  await stop(studio);
  await studio.page.locator('.card-close').click();
  const name = readdirSync(server.takes).find((one) => one.endsWith('.take'));
  const file = join(server.takes, `older-${name}`);
  writeFileSync(file, ofAnotherVersion(readFileSync(join(server.takes, name))));
  const opened = await studio.page.evaluate(
    async (path) => (await fetch(path, { method: 'POST' })).status,
    `takes/older-${name}/open`,
  );
  expect(opened === 200, `it opens: ${opened}`);
  await studio.until('the time line', () => document.querySelector('.time-line')?.hidden === false);
  await studio.until('the words', () => document.querySelector('.time-stored').checkVisibility());
  for (const button of ['.time-again', '.time-layer', '.time-path'])
    expect(!(await studio.page.locator(button).isVisible()), `${button} is absent`);
  await pause(studio);
  await studio.wait(300);
  await studio.shot('takes-stored');
  // Both ways, by a finger on the time line.
  const line = await timeLine(studio);
  const at = (share) => ({ x: line.left + line.width * share, y: line.y });
  const places = () => studio.frame().then((frame) => [...frame.x, ...frame.y]);
  const shows = (share) =>
    studio.eventually(async () => {
      const { step } = await studio.frame();
      expect(Math.abs(step - share * line.steps) <= line.steps * 0.01 + 2, `it shows ${share}: ${step}`);
    });
  await studio.fingers.down({ 1: at(0.5) });
  await shows(0.5);
  const first = await places();
  await studio.fingers.move({ 1: at(0.9) }, { steps: 6, ms: 200 });
  await shows(0.9);
  const later = await places();
  await studio.fingers.move({ 1: at(0.5) }, { steps: 6, ms: 200 });
  await studio.fingers.up();
  await shows(0.5);
  const moved = Math.max(...later.map((value, k) => Math.abs(value - first[k])));
  expect(moved > 0.3, `people move in it: ${moved}`);
  await studio.page.keyboard.press('Shift+P');
  expect((await studio.page.locator('.path-bar').count()) === 0, 'its paths cannot be changed');
  await studio.send({ type: 'Seek', step: line.to - 20 });
  await studio.send({ type: 'Playback', action: 0 });
  await studio.until('its end', () => globalThis.__muster.state.notice?.code === 'replay-end', null, 30000);
  const { text } = await studio.page.evaluate(() => globalThis.__muster.state.notice);
  expect(/stored frames/.test(text), text);
}
