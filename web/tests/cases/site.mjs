// The studio of a static site: it loads, is steered, keeps takes, plays as the program does, and needs no network.
import { readdirSync, readFileSync, mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join, relative } from 'node:path';
import { gzipSync } from 'node:zlib';
import initSqlJs from 'sql.js';
import { expect } from '../support/expect.mjs';
import { crowd, distance, extreme, points, shifted } from '../support/geometry.mjs';
import { jupedsimRows } from '../support/jupedsim_rows.mjs';
import { runProgram } from '../support/server.mjs';
import { serious } from './look.mjs';
import { play, record, stop } from './takes.mjs';

/** A first load may take so much over the wire, each file compressed by gzip. */
const kFirstLoad = 866_000;

/** What a first visit loads until the crowd is seen, on a page that has nothing yet; then it walks as it is touched. */
export async function firstLoad(browser, server, size) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
  const page = await context.newPage();
  const loaded = new Map();
  const outside = [];
  page.on('response', async (answer) => {
    if (!answer.url().startsWith(server.url)) return outside.push(answer.url());
    const name = relative(server.url, answer.url()) || 'index.html';
    loaded.set(name, Buffer.alloc(0));
    loaded.set(name, await answer.body().catch(() => Buffer.alloc(0)));
  });
  const began = Date.now();
  await page.goto(server.url);
  await page.waitForFunction(() => (globalThis.__muster?.view.stats.shownFrame ?? 0) > 0, null, { timeout: 60000 });
  // What is asked for from now on does not count: the rest comes while the crowd stands to be seen.
  const asked = new Set(loaded.keys());
  const standing = await page.evaluate(() => [...globalThis.__muster.frame.x]);
  const spot = await page.evaluate(() => globalThis.__muster.view.worldToScreen(globalThis.__muster.frame.groups[0]));
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.down();
  await page.mouse.move(spot.x + 120, spot.y - 40, { steps: 4 });
  const walked = (xs) => globalThis.__muster.frame.x.some((x, k) => Math.abs(x - xs[k]) > 0.1);
  await page.waitForFunction(walked, standing, { timeout: 60000, polling: 20 });
  const walking = Date.now() - began;
  await page.mouse.up();
  // Answers are read to their ends.
  await page.waitForTimeout(500);
  // Workers' own requests are not told to the page: everything of the site that is needed is counted.
  for (const name of ['engine/muster-engine.js', 'engine/muster-engine.wasm.xz', 'engine/scenarios.json'])
    loaded.set(name, readFileSync(join(server.folder, name)));
  const counted = [...loaded].filter(([name]) => asked.has(name) || /engine\.|scenarios/.test(name));
  const sizes = counted.map(([name, bytes]) => [name, gzipSync(bytes, { level: 9 }).length]);
  const sum = sizes.reduce((all, [, bytes]) => all + bytes, 0);
  console.log(
    `measured: first load of a site ${Math.round(sum / 1000)} kB with gzip, a walking crowd after ${walking} ms`,
  );
  for (const [name, bytes] of sizes.sort((a, b) => b[1] - a[1]).slice(0, 5))
    console.log(`measured: ${Math.round(bytes / 1000)} kB ${name} (${size})`);
  expect(outside.length === 0, `everything comes from the site: ${outside.join(', ')}`);
  expect(sum < kFirstLoad, `${sum} bytes`);
  const absolute = readdirSync(server.folder).filter((name) =>
    /["'(]\/(?!\/)[\w-]+\.(js|css)/.test(text(server, name)),
  );
  expect(absolute.length === 0, `relative paths only: ${absolute}`);
  await context.close();
}

function text(server, name) {
  return /\.(html|js|css)$/.test(name) ? readFileSync(join(server.folder, name), 'utf8') : '';
}

/** Fingers lead the formation's corner away, and people follow. `held` is called while the finger is down. */
export async function steer(studio, held = async () => {}) {
  await studio.makeRoom();
  const frame = await studio.frame();
  const corner = extreme(points(frame.groups[0].vertices), 1, 0);
  const [from, to] = await studio.screen([corner, shifted(corner, 4, 0)]);
  await studio.fingers.down({ 1: from });
  await studio.fingers.move({ 1: to }, { steps: 12, ms: 700 });
  await studio.until('a control', () => globalThis.__muster.frame.groups[0].controls.length > 0);
  await held();
  await studio.fingers.up();
  const before = crowd(frame);
  await studio.eventually(async () => {
    const now = crowd(await studio.frame());
    const walked = now.filter((at, i) => distance(at, before[i]) > 0.5).length;
    expect(walked > 20, `people follow: ${walked}`);
  });
}

/** Fingers steer the crowd. */
export async function touches(studio) {
  await steer(studio, () => studio.shot('site-touch'));
  await serious(studio, 'a site');
}

/** All scenarios are offered, and another one opens. */
export async function scenarios(studio) {
  await studio.send({ type: 'LoadScenario', name: 'paper/x08-congestion' });
  await studio.until('another scenario', () => globalThis.__muster.state.scenario.startsWith('paper/x08'));
  const offered = await studio.page.evaluate(() => globalThis.__muster.state.scenarios.length);
  expect(offered >= 19, `all are offered: ${offered}`);
}

const shelf = (studio) =>
  studio.page.evaluate(async () => (await (await globalThis.__muster.ask('takes')).json()).takes);

/** A take is in the browser's shelf after the page was closed, and plays. */
export async function takesStay(studio) {
  await record(studio, 1.5);
  await stop(studio);
  await studio.shot('site-take');
  const [kept] = await shelf(studio);
  expect(kept?.finished && kept.steps > 60, 'the take is on the shelf');
  await studio.wait(2500);
  await studio.page.reload();
  await studio.until('the first frame', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
  await studio.eventually(async () => {
    const [now] = await shelf(studio);
    expect(now?.name === kept.name && now.bytes === kept.bytes, `it is there again: ${now?.name}`);
  });
  const status = await studio.page.evaluate(
    async (name) => (await globalThis.__muster.ask(`takes/${name}/open`, { method: 'POST' })).status,
    kept.name,
  );
  expect(status === 200, `it opens: ${status}`);
  await studio.until('the replay', () => globalThis.__muster.frame.replaying);
}

/** Records a take of so many seconds; a copy of its file. */
async function newTake(studio, seconds) {
  await record(studio, seconds);
  await stop(studio);
  await play(studio);
  const [{ name }] = await shelf(studio);
  const bytes = await studio.page.evaluate(async (take) => {
    const answer = await globalThis.__muster.ask(`takes/${take}`);
    return [...new Uint8Array(await answer.arrayBuffer())];
  }, name);
  const file = join(mkdtempSync(join(tmpdir(), 'muster-site-')), name);
  writeFileSync(file, Buffer.from(bytes));
  return file;
}

/** JuPedSim's file is written by the page's SQLite and has the rows of the program's. */
export async function jupedsim(studio) {
  const take = await newTake(studio, 1.5);
  const bytes = await studio.page.evaluate(async (name) => {
    const { ask } = globalThis.__muster;
    const order = JSON.stringify({ take: name, format: 'jupedsim', fps: 30, from: 0, to: -1 });
    const { number } = await (await ask('exports', { method: 'POST', body: order })).json();
    for (;;) {
      const { state, problem } = await (await ask(`exports/${number}`)).json();
      if (state === 'failed') throw new Error(problem);
      if (state === 'done') return [...new Uint8Array(await (await ask(`exports/${number}/file`)).arrayBuffer())];
      await new Promise((done) => setTimeout(done, 100));
    }
  }, basename(take));
  const file = `${take}.sqlite`;
  const made = runProgram('export', take, '--format', 'jupedsim', '--fps', '30', '--out', file);
  expect(made.status === 0, `the program exports it: ${made.stderr}`);
  const library = await initSqlJs();
  const [ours, programs] = [Buffer.from(bytes), readFileSync(file)].map((all) => jupedsimRows(library, all));
  expect(ours[3].length > 1000, `trajectories: ${ours[3].length} rows`);
  const counts = (tables) => tables.map((rows) => rows.length).join();
  expect(counts(ours) === counts(programs), `as many rows: ${counts(ours)} and ${counts(programs)}`);
  const other = ours.findIndex((rows, k) => JSON.stringify(rows) !== JSON.stringify(programs[k]));
  expect(other < 0, `the same rows in table ${other}: ${JSON.stringify(ours[other]?.slice(0, 3))}`);
}

/** The program simulates a take of the page again and finds every hash. */
export async function sameHashes(studio) {
  const file = await newTake(studio, 4);
  const { status, stdout, stderr } = runProgram('replay', file);
  expect(status === 0, `the program finds the same hashes: ${stdout} ${stderr}`);
  console.log(`measured: a take of the site, replayed by the program: ${stdout.trim().split('\n').at(-1)}`);
}

/** What lies on the clipboard, as the page writes it. */
async function copied(studio, press) {
  await studio.page.evaluate(() => {
    globalThis.__copied = '';
    const clipboard = { writeText: async (words) => void (globalThis.__copied = words) };
    Object.defineProperty(globalThis.navigator, 'clipboard', { value: clipboard, configurable: true });
  });
  await press();
  await studio.until('a link', () => globalThis.__copied !== '');
  return studio.page.evaluate(() => globalThis.__copied);
}

/** A place and a take open from links, in a browser that has never been here. */
export async function links(studio, server) {
  await record(studio, 1.5);
  await stop(studio);
  const take = await copied(studio, () => studio.page.locator('.card-share').click());
  await studio.page.getByText('nothing is uploaded').waitFor();
  await studio.shot('site-link');
  await studio.page.locator('.card-close').click();
  console.log(`measured: a link to a take of 1.5 s has ${take.length} characters`);
  await opensElsewhere(studio, take, () => globalThis.__muster.frame.replaying);
  await studio.page.evaluate(async () => {
    const { ask } = globalThis.__muster;
    const place = await (await ask('scenario')).json();
    place.groups[0].count = 23;
    await ask('scenario?name=fewer', { method: 'POST', body: JSON.stringify(place) });
  });
  await studio.until('fewer people', () => globalThis.__muster.frame.x.length === 23);
  await studio.page.locator('.scenario-button').click();
  await studio.page.locator('.place-menu-item', { hasText: 'Save this place' }).click();
  const place = await copied(studio, () => studio.page.getByRole('button', { name: 'Copy link' }).click());
  await studio.shot('site-place-link');
  await opensElsewhere(studio, place, () => globalThis.__muster.frame.x.length === 23);
  await damaged(studio, `${server.url}#take=${take.split('=')[1].slice(0, 60)}`);
}

async function opensElsewhere(studio, link, test) {
  const context = await studio.context.browser().newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.goto(link);
  await page.waitForFunction(() => (globalThis.__muster?.frame?.groups.length ?? 0) > 0, null, { timeout: 30000 });
  await page.waitForFunction(test, null, { timeout: 15000 });
  await context.close();
}

/** A link that was cut off is told in one sentence, and the studio goes on. */
async function damaged(studio, link) {
  const context = await studio.context.browser().newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.goto(link);
  await page.getByText('The take in this link').waitFor({ timeout: 30000 });
  await page.waitForFunction(() => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
  await context.close();
}

/** Steps and pictures in a second, of large crowds that march while the page draws them. */
export async function largeCrowds(studio) {
  for (const count of [1000, 10000]) {
    const side = Math.ceil(Math.sqrt(count));
    const place = {
      format: 'muster-scenario',
      version: 1,
      name: `Crowd of ${count}`,
      box: [
        [-side, -side],
        [2.5 * side, side],
      ],
      groups: [{ count, formation: 'square', position: [0, 0] }],
    };
    const answer = await studio.page.evaluate(async (text) => {
      const opened = await globalThis.__muster.ask('scenario?name=large', { method: 'POST', body: text });
      return opened.ok ? '' : opened.text();
    }, JSON.stringify(place));
    expect(answer === '', answer);
    await studio.until('the crowd', (n) => globalThis.__muster.frame.x.length === n, count, 60000);
    await studio.send({ type: 'Commands', commands: [{ kind: 'order', group: 1, order: { target: [side, 0] } }] });
    await studio.wait(3000);
    const look = () =>
      studio.page.evaluate(() => {
        const { frame, view } = globalThis.__muster;
        return { step: frame.step, pictures: view.stats.pictures, at: performance.now() };
      });
    const before = await look();
    await studio.wait(6000);
    const after = await look();
    const seconds = (after.at - before.at) / 1000;
    const rate = (after.step - before.step) / seconds;
    console.log(
      `measured: ${count} characters in the page: ${rate.toFixed(1)} steps and ` +
        `${((after.pictures - before.pictures) / seconds).toFixed(1)} pictures a second`,
    );
    expect(rate > 1, `the world goes on: ${rate}`);
  }
}

/** Waits until the service worker has all files. */
async function filesKept(studio) {
  await studio.page.evaluate(() => globalThis.navigator.serviceWorker.ready);
  await studio.until('the files to be kept', () => globalThis.navigator.serviceWorker.controller !== null);
}

/** A visit that the service worker answers is isolated: worlds have threads there, and the same hashes. */
export async function threads(studio, server) {
  await filesKept(studio);
  await studio.page.goto(`${server.url}?threads=2#scenario=open`);
  await studio.page.reload();
  await studio.until('the first frame', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0, null, 30000);
  expect(await studio.page.evaluate(() => globalThis.crossOriginIsolated), 'the page is isolated');
  const workers = studio.page.workers().map((worker) => worker.url());
  expect(workers.filter((url) => /threads\.worker/.test(url)).length >= 1, `threads run: ${workers}`);
  // Worlds come and go with their threads.
  for (const name of ['paper/x08-congestion', 'market', 'open']) {
    await studio.send({ type: 'LoadScenario', name });
    await studio.until(name, (wanted) => globalThis.__muster.state.scenario === wanted, name);
  }
  await sameHashes(studio);
  await largeCrowds(studio);
}

/** After the first visit the site opens without a network. */
export async function offline(studio, server) {
  await filesKept(studio);
  await studio.context.setOffline(true);
  await studio.page.goto(server.url);
  await studio.page.reload();
  await studio.until('the first frame', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0, null, 30000);
  await studio.until('the first picture', () => globalThis.__muster.view.stats.shownFrame > 0);
  // In the market people patrol by themselves.
  await studio.send({ type: 'LoadScenario', name: 'market' });
  await studio.until('the market', () => globalThis.__muster.state.scenario === 'market');
  await studio.wait(500);
  const before = crowd(await studio.frame());
  await studio.wait(1500);
  const walked = crowd(await studio.frame()).filter((at, i) => distance(at, before[i]) > 0.3).length;
  expect(walked > 50, `people walk without a network: ${walked}`);
  await studio.shot('site-offline');
  await studio.context.setOffline(false);
}
