// Exports by choice: of a group, of a part, with their size told before; tables, and people without background.
import { readFile, writeFile } from 'node:fs/promises';
import { expect } from '../support/expect.mjs';
import { pause, play, record, stop } from './takes.mjs';

const kDialog = '.export-dialog';

async function openExport(studio, seconds) {
  await record(studio, seconds, 1);
  await stop(studio);
  await play(studio);
  await pause(studio);
  await studio.page.locator('.time-export').click();
}

const choose = (studio, kind) => studio.page.locator(`${kDialog} input[value="${kind}"][type="radio"]`).check();

/** A number in one of the dialog's fields. */
const type = (studio, label, value) => studio.page.locator(`${kDialog} [aria-label="${label}"]`).fill(String(value));

/** The bytes and people that the dialog tells of. */
async function told(studio) {
  await studio.until('the size', () => /^About/.test(document.querySelector('.export-size')?.textContent ?? ''));
  const text = await studio.page.locator('.export-size').textContent();
  const [, number, unit, people] = /^About ([\d.]+) (bytes|kB|MB), (\d+) (?:people|person)$/.exec(text) ?? [];
  expect(number !== undefined, `what is told of the size: “${text}”`);
  return { bytes: Number(number) * { bytes: 1, kB: 1e3, MB: 1e6 }[unit], people: Number(people) };
}

async function save(studio) {
  const [download] = await Promise.all([
    studio.page.waitForEvent('download', { timeout: 120000 }),
    studio.page.locator('.export-begin').click(),
  ]);
  const bytes = await readFile(await download.path());
  await studio.until('the word', () => /^Saved /.test(document.querySelector('.export-said').textContent));
  return { bytes, name: download.suggestedFilename() };
}

/** A table of all, then of one group in a part of the time: the size is told before, and what was chosen is in it. */
export async function chosenPart(studio) {
  await openExport(studio, 1.5);
  await choose(studio, 'csv');
  const all = await told(studio);
  const table = (await save(studio)).bytes;
  expect(all.people === 61, `all are in it: ${all.people}`);
  expect(Math.abs(all.bytes / table.length - 1) < 0.2, `told ${all.bytes}, has ${table.length} bytes`);
  const ember = await studio.page.evaluate(
    () => globalThis.__muster.state.groups.find((one) => one.name === 'Ember').id,
  );
  await studio.page.locator(`.export-groups input[value="${ember}"]`).check();
  await type(studio, 'Seconds from', 0.5);
  await type(studio, 'Seconds to', 1);
  await type(studio, 'Persons to', 55);
  await studio.until(
    'less',
    (most) => {
      const text = document.querySelector('.export-size').textContent;
      return /^About/.test(text) && !text.endsWith(`${most} people`);
    },
    all.people,
  );
  await studio.shot('export-chosen');
  const some = await told(studio);
  const part = await save(studio);
  expect(
    part.name.endsWith('.csv') && part.bytes.length < table.length / 4,
    `a smaller file: ${part.bytes.length} bytes`,
  );
  expect(Math.abs(some.bytes / part.bytes.length - 1) < 0.2, `told ${some.bytes}, has ${part.bytes.length} bytes`);
  const [head, ...rows] = part.bytes.toString().trim().split('\n');
  expect(head === 'time_s,person,group,group_name,x_m,y_m,heading_deg,speed_m_s,motion,goal', head);
  const cells = rows.map((row) => row.split(','));
  expect(cells.length === 16 * some.people, `${cells.length} rows of ${some.people} people at 16 moments`);
  // Seconds are those of the take's part; the table has the time since the world began.
  const began = Number(table.toString().split('\n')[1].split(',')[0]);
  const within = (time) => time - began > 0.499 && time - began < 1.001;
  expect(
    cells.every((row) => row[3] === 'Ember' && Number(row[1]) <= 55 && within(row[0])),
    'only of whom and when it was asked for',
  );
  await studio.page.locator('.export-begin').press('Escape');
  await studio.until('the end of the export', () => !document.querySelector('.export-dialog[open]'));
}

/** Nobody is in the choice: it is said before anything is made. */
export async function nobodyChosen(studio) {
  await openExport(studio, 0.6);
  await choose(studio, 'pedpy');
  await type(studio, 'Persons from', 900);
  await studio.until('a sentence', () => /nobody/.test(document.querySelector('.export-size').textContent));
}

/** Two bytes or four at a place, the smallest first. */
const half = (bytes, at) => bytes.readUInt16LE(at);
const word = (bytes, at) => bytes.readUInt32LE(at);

/** The files of a ZIP that does not pack them. */
function filesOf(zip) {
  const files = [];
  for (let at = 0; word(zip, at) === 0x04034b50;) {
    const [size, name] = [word(zip, at + 18), half(zip, at + 26)];
    const from = at + 30 + name;
    files.push({ name: zip.toString('latin1', at + 30, from), bytes: zip.subarray(from, from + size) });
    at = from + size;
  }
  return files;
}

/** People without background: each picture is a PNG in which most is clear and people are not. */
export async function clearPictures(studio) {
  await openExport(studio, 0.8);
  await choose(studio, 'pictures');
  await type(studio, 'Seconds from', 0.7);
  await type(studio, 'Seconds to', 0.6);
  await studio.until('a word', () => /ends before/.test(document.querySelector('.export-size').textContent));
  await type(studio, 'Seconds to', 0.8);
  await studio.page.locator(`${kDialog} select[aria-label="Frames a second"]`).selectOption('24');
  await studio.page.locator(`${kDialog} select[aria-label="Size"]`).selectOption('1280 × 720');
  await studio.shot('export-pictures');
  const zip = await save(studio);
  const files = filesOf(zip.bytes);
  expect(
    files.length === 3 && files[0].name === 'picture-00001.png',
    `three pictures: ${files.map(({ name }) => name)}`,
  );
  const seen = await studio.page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(globalThis.atob(base64), (c) => c.charCodeAt(0));
    const picture = await globalThis.createImageBitmap(new globalThis.Blob([bytes], { type: 'image/png' }));
    const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
    const pen = canvas.getContext('2d');
    pen.drawImage(picture, 0, 0);
    const { data } = pen.getImageData(0, 0, picture.width, picture.height);
    const share = (test) => {
      let count = 0;
      for (let i = 3; i < data.length; i += 4) count += test(data[i]) ? 1 : 0;
      return count / (data.length / 4);
    };
    pen.globalCompositeOperation = 'destination-over';
    pen.fillStyle = '#c8f';
    pen.fillRect(0, 0, picture.width, picture.height);
    return {
      size: [picture.width, picture.height],
      clear: share((alpha) => alpha === 0),
      solid: share((alpha) => alpha === 255),
      soft: share((alpha) => alpha > 0 && alpha < 255),
      shown: canvas.toDataURL('image/png').split(',')[1],
    };
  }, files[0].bytes.toString('base64'));
  await writeFile(
    new URL(`../../test-results/export-people-${studio.size}.png`, import.meta.url),
    seen.shown,
    'base64',
  );
  expect(seen.size.join() === '1280,720', seen.size.join());
  expect(seen.clear > 0.6, `most is clear: ${seen.clear}`);
  expect(seen.solid > 0.004, `people are not: ${seen.solid}`);
  expect(seen.soft > 0.001, `shadows and edges are between: ${seen.soft}`);
}

/** Rows of a picture: how blue they are. */
const rowsOf = (studio, png) =>
  studio.page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(globalThis.atob(base64), (c) => c.charCodeAt(0));
    const picture = await globalThis.createImageBitmap(new globalThis.Blob([bytes], { type: 'image/png' }));
    const canvas = Object.assign(document.createElement('canvas'), { width: 1, height: picture.height });
    const pen = canvas.getContext('2d');
    pen.drawImage(picture, 0, 0, 1, picture.height);
    const { data } = pen.getImageData(0, 0, 1, picture.height);
    return Array.from({ length: picture.height }, (_, y) => data[4 * y + 2] - data[4 * y]);
  }, png.toString('base64'));

/** A flat view of a take has a horizon, and a blue sky above it, where that is wanted. */
export async function skyAndHorizon(studio) {
  await openExport(studio, 0.6);
  await studio.page.evaluate(() => globalThis.__muster.view.camera.orbit(0, -2));
  await choose(studio, 'picture');
  const sky = (await save(studio)).bytes;
  await writeFile(new URL(`../../test-results/export-sky-${studio.size}.png`, import.meta.url), sky);
  await studio.page.locator(`${kDialog} label`, { hasText: 'Sky and horizon' }).locator('input').uncheck();
  const plain = (await save(studio)).bytes;
  const [above, none] = [await rowsOf(studio, sky), await rowsOf(studio, plain)];
  const ground = (rows) => rows.at(-20);
  expect(above[10] > ground(above) + 15, `the sky is bluer than the ground: ${above[10]}, ${ground(above)}`);
  expect(Math.abs(none[10] - ground(none)) < 10, `without it all is ground: ${none[10]}, ${ground(none)}`);
  await studio.page.keyboard.press('Escape');
  await studio.page.evaluate(() => document.querySelector('.time-close').click());
  await studio.until('steering again', () => globalThis.__muster.view.camera.pose.pitch > 0.43);
}

const kGroups = { scenario: 'web/tests/scenarios/two-groups.json' };

export const kExportCases = [
  ['exports: of a group and a part', chosenPart, ['desktop', 'phone'], kGroups],
  ['exports: of nobody', nobodyChosen, ['desktop'], kGroups],
  ['exports: sky and horizon', skyAndHorizon, ['desktop'], kGroups],
  ['exports: people without background', clearPictures, ['desktop', 'portrait'], kGroups],
];
