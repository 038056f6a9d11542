// Measuring: a line is drawn before a door, an area beside it, people leave, and the tables tell of them.
import { readFileSync } from 'node:fs';
import { expect } from '../support/expect.mjs';
import { readCsv } from '../support/csv.mjs';
import { drag } from './build.mjs';
import { serious } from './look.mjs';

const kPeople = 60;
const panel = (studio) => studio.page.locator('.measure-panel');
const card = (studio, name) => panel(studio).locator(`.measure-card[aria-label="${name}"]`);

const figure = (studio, name, label) =>
  card(studio, name).locator('.measure-figures > div', { hasText: label }).locator('dd').textContent();

async function draw(studio, tool, from, to) {
  await panel(studio).getByRole('button', { name: tool }).click();
  await drag(studio, from, to, { touch: studio.touch ?? true });
}

async function table(studio, press) {
  const [download] = await Promise.all([studio.page.waitForEvent('download'), press()]);
  const path = await download.path();
  return { name: download.suggestedFilename(), rows: readCsv(path), text: readFileSync(path, 'utf8') };
}

async function begin(studio) {
  await studio.send({ type: 'Playback', action: 1 });
  await studio.until('a pause', () => !globalThis.__muster.frame.playing);
  if (studio.size === 'phone') await studio.makeRoom(0.6);
  await studio.tab('view');
  await studio.page.getByRole('button', { name: 'Measures', exact: true }).click();
  await panel(studio).waitFor();
}

async function atDoor(studio) {
  await draw(studio, 'New line', { x: 1, y: -1.5 }, { x: 1, y: 1.5 });
  await card(studio, 'Line 1').waitFor();
  await draw(studio, 'New area', { x: -2, y: -1 }, { x: -0.5, y: 1 });
  await card(studio, 'Area 1').waitFor();
}

/** Restart keeps lines and areas, and begins to count anew. */
async function run(studio) {
  await studio.send({ type: 'Playback', action: 3 });
  await studio.send({ type: 'Playback', action: 0 });
  await studio.send({ type: 'SetSpeed', factor: 2 });
}

/** A finger draws a line before a door: everybody who goes through is counted, and stands in the tables. */
export async function door(studio) {
  const { page } = studio;
  await begin(studio);
  await atDoor(studio);
  await studio.shot('measures-drawn');
  await run(studio);
  await studio.until('half of them out', (n) => globalThis.__muster.frame.x.length < n / 2, kPeople, 90000);
  await studio.eventually(async () => {
    const seen = Number(await figure(studio, 'Line 1', 'Persons who crossed'));
    expect(seen > kPeople / 2 && seen < kPeople, `some have crossed: ${seen}`);
    const density = Number.parseFloat(await figure(studio, 'Area 1', 'Density'));
    expect(density > 0.3 && density < 7, `a density before the door: ${density}`);
  });
  await studio.pictures(2);
  await studio.shot('measures-running');
  await serious(studio, 'measuring');
  await studio.until('all of them out', () => globalThis.__muster.frame.x.length === 0, null, 120000);
  await studio.eventually(async () => {
    const labels = ['Persons who crossed', 'With the arrow'];
    const seen = (await Promise.all(labels.map((label) => figure(studio, 'Line 1', label)))).join();
    expect(seen === `${kPeople},${kPeople} / 0`, `everybody has crossed once, one way: ${seen}`);
  });
  await studio.shot('measures-out');
  await tables(studio);
  await card(studio, 'Line 1').getByRole('button', { name: 'Hide' }).click();
  await studio.eventually(async () => expect((await page.locator('.measure-line').count()) === 0, 'it is hidden'));
  await card(studio, 'Area 1').getByRole('button', { name: 'Remove' }).click();
  await studio.eventually(async () => expect((await page.locator('.measure-card').count()) === 2, 'it is gone'));
  await page.keyboard.press('Escape');
  await studio.until('no panel', () => document.querySelector('.measure-panel').hidden);
}

async function tables(studio) {
  const line = await table(studio, () => card(studio, 'Line 1').getByRole('button', { name: 'Save as CSV' }).click());
  expect(line.name === 'a-door-line-1.csv', line.name);
  expect(line.rows.length === kPeople, `a row for each: ${line.rows.length}`);
  const times = line.rows.map((row) => Number(row['time [s]']));
  expect(
    times.every((time, k) => time > 0 && time >= (times[k - 1] ?? 0)),
    'by their times',
  );
  expect(new Set(line.rows.map(({ person }) => person)).size === kPeople, 'each of them once');
  const flow = (kPeople - 1) / (times.at(-1) - times[0]);
  const shown = Number.parseFloat(await figure(studio, 'Line 1', 'Mean flow since'));
  expect(Math.abs(flow - shown) < 0.006, `the flow is that of the table: ${flow} and ${shown}`);
  console.log(
    `measured: ${kPeople} people through a door of 1.4 m, ${flow.toFixed(2)} /s, from ${times[0]} to ${times.at(-1)} s`,
  );
  const out = await table(studio, () => panel(studio).getByRole('button', { name: 'Save the evacuation' }).click());
  const last = out.rows.at(-1);
  expect(last['inside [persons]'] === '0' && last['out by Yard [persons]'] === `${kPeople}`, JSON.stringify(last));
  const all = await table(studio, () => panel(studio).getByRole('button', { name: 'Save all' }).click());
  const count = (name, quantity) => all.rows.filter((row) => row.measure === name && row.quantity === quantity);
  expect(count('Line 1', 'crossings with the arrow').length === kPeople, 'all crossings');
  expect(count('Area 1', 'density').length > 50 && count('Area 1', 'density')[0].unit === '1/m2', 'densities');
  expect(count('Evacuation', 'out').length > 50, 'the curve of evacuation');
}

/** The same on a site, where the engine is in the page. */
export async function doorOnSite(studio) {
  const text = readFileSync(new URL('../scenarios/door.json', import.meta.url), 'utf8');
  const status = await studio.page.evaluate(
    async (body) => (await globalThis.__muster.ask('scenario?name=door', { method: 'POST', body })).status,
    text,
  );
  expect(status === 200, `the place opens: ${status}`);
  await studio.until('its people', (n) => globalThis.__muster.frame.x.length === n, kPeople);
  await studio.fit();
  await door(studio);
}
