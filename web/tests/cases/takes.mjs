// Takes: kept, found again, scrubbed, trimmed, directed again, exported, and safe from a killed server.
import { readFile } from 'node:fs/promises';
import validator from 'gltf-validator';
import { expect } from '../support/expect.mjs';
import { extreme, points, shifted } from '../support/geometry.mjs';
import { startStudio } from '../support/server.mjs';
import { StudioPage } from '../support/studio_page.mjs';

const now = (studio) => studio.page.evaluate(() => globalThis.__muster.frame.step);
const visible = (studio, selector) => studio.page.locator(selector).isVisible();

/** One finger drags a corner of a group for so long. */
async function drag(studio, group = 0, metres = 2.5, ms = 600) {
  const corner = extreme(points((await studio.frame()).groups[group].vertices), 1, 0);
  const [from, to] = await studio.screen([corner, shifted(corner, metres, 0.4)]);
  await studio.fingers.down({ 1: from });
  await studio.fingers.move({ 1: to }, { steps: 10, ms });
  await studio.fingers.up();
}

export async function record(studio, seconds = 1.5, group = 0) {
  await studio.page.locator('.record').click();
  await studio.until('the record clock', () => globalThis.__muster.frame.recordedSeconds >= 0);
  await drag(studio, group);
  await studio.until('so much of it', (least) => globalThis.__muster.frame.recordedSeconds >= least, seconds);
}

export async function stop(studio) {
  await studio.page.locator('.record').click();
  await studio.until('the card', () => document.querySelector('.take-card')?.hidden === false);
}

/** Opens the take of the card. */
export async function play(studio) {
  await studio.page.locator('.card-play').click();
  await studio.until('the time line', () => document.querySelector('.time-line')?.hidden === false);
}

export async function pause(studio) {
  await studio.send({ type: 'Playback', action: 1 });
  await studio.until('a pause', () => !globalThis.__muster.frame.playing);
}

/** What the time line's handles say. */
export const timeLine = (studio) =>
  studio.page.evaluate(() => {
    const value = (name) => Number(document.querySelector(name).getAttribute('aria-valuenow'));
    const box = document.querySelector('.time-track').getBoundingClientRect();
    return {
      head: value('.time-playhead'),
      from: value('.time-from'),
      to: value('.time-to'),
      steps: Number(document.querySelector('.time-playhead').getAttribute('aria-valuemax')),
      left: box.left,
      width: box.width,
      y: box.top + box.height / 2,
    };
  });

async function takesOf(studio) {
  return (await studio.page.evaluate(async () => (await globalThis.__muster.ask('takes')).json())).takes;
}

async function openShelf(studio) {
  if (await visible(studio, '.playback .takes')) {
    await studio.page.locator('.playback .takes').click();
    await studio.page.locator('.take-list .menu-item', { hasText: 'All takes' }).click();
  } else {
    await studio.page.locator('.phone-bar button[aria-label="More"]').click();
    await studio.page.locator('.phone-menu .menu-item', { hasText: 'All takes' }).click();
  }
  await studio.until('the shelf', () => document.querySelector('.take-shelf')?.hidden === false);
}

/** Record, card, name, shelf, reload, play, remove and bring back. */
export async function life(studio, server) {
  const before = await now(studio);
  await record(studio, 1.5);
  expect((await takesOf(studio))[0]?.recording, 'the take is on the shelf from its first moment');
  await studio.shot('takes-recording');
  await stop(studio);
  await studio.eventually(async () => {
    const width = await studio.page.evaluate(() => document.querySelector('.card-picture').naturalWidth);
    expect(width === 320, `the card has a picture: ${width}`);
  });
  await studio.wait(250);
  await studio.shot('takes-card');
  const name = studio.page.locator('.card-name');
  await name.fill('A “wave”');
  await name.press('Enter');
  await studio.eventually(async () => expect((await takesOf(studio))[0].title === 'A “wave”', 'it has its name'));
  const [take] = await takesOf(studio);
  expect(take.from >= before && take.finished, `it begins where Record was pressed: ${take.from} from ${before} on`);
  await studio.page.locator('.card-close').click();

  await studio.page.goto(server.url);
  await studio.until('the page again', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
  await openShelf(studio);
  const item = studio.page.locator('.shelf-item', { hasText: 'A “wave”' });
  await item.waitFor();
  await studio.wait(200);
  await studio.shot('takes-shelf');
  await item.locator('.shelf-item-open').click();
  await studio.until('the take', () => document.querySelector('.time-line')?.hidden === false);
  await studio.until('its beginning', (from) => globalThis.__muster.frame.step >= from, take.from);
  expect(!(await visible(studio, '.take-shelf')), 'the shelf makes room');
  await studio.wait(300);
  await studio.shot('takes-time-line');
  await studio.page.locator('.time-close').click();
  await studio.until('the scenario', () => !globalThis.__muster.frame.replaying);

  await openShelf(studio);
  await studio.page.locator('[aria-label="Remove A “wave”"]').click();
  await studio.eventually(async () => expect((await takesOf(studio)).length === 0, 'it is removed'));
  await studio.page.locator('.shelf-undo button').click();
  await studio.eventually(async () => expect((await takesOf(studio)).length === 1, 'it is back'));
  await studio.page.keyboard.press('Escape');
  expect(!(await visible(studio, '.take-shelf')), 'Escape closes the shelf');
}

/** Real fingers on the time line: both ways, and the ends of the part. */
export async function scrubAndTrim(studio) {
  await record(studio, 2.5);
  await stop(studio);
  await play(studio);
  await pause(studio);
  const line = await timeLine(studio);
  const at = (share) => ({ x: line.left + line.width * share, y: line.y });
  const shows = (share) =>
    studio.eventually(async () => {
      const step = await now(studio);
      expect(
        Math.abs(step - share * line.steps) <= line.steps * 0.01 + 2,
        `it shows ${share}: ${step} of ${line.steps}`,
      );
    });
  const inside = (share) => (line.from + share * (line.to - line.from)) / line.steps;
  await studio.fingers.down({ 1: at(inside(0.4)) });
  await shows(inside(0.4));
  await studio.fingers.move({ 1: at(inside(0.8)) }, { steps: 12, ms: 400 });
  await shows(inside(0.8));
  await studio.fingers.move({ 1: at(inside(0.25)) }, { steps: 12, ms: 400 });
  await studio.fingers.up();
  await shows(inside(0.25));
  // Seeks there and back show the same people at the same places.
  const places = () => studio.frame().then((frame) => [...frame.x.slice(0, 20), ...frame.y.slice(0, 20)].join(' '));
  const moment = Math.round(inside(0.25) * line.steps);
  const seek = async () => {
    await studio.send({ type: 'Seek', step: moment });
    await studio.eventually(async () => expect((await now(studio)) === moment, 'it shows the moment'));
  };
  await seek();
  const first = await places();
  await studio.page.locator('.time-playhead').press('End');
  await shows(1);
  const { head } = await timeLine(studio);
  await seek();
  expect(head === line.steps, 'End goes to the end');
  expect((await places()) === first, 'a moment looks the same from both sides');

  await studio.fingers.down({ 1: { x: at(line.to / line.steps).x + 14, y: line.y } });
  await studio.fingers.move({ 1: at(inside(0.7)) }, { steps: 8, ms: 300 });
  await studio.fingers.up();
  await studio.eventually(async () => {
    const { to } = await timeLine(studio);
    expect(Math.abs(to - inside(0.7) * line.steps) < line.steps * 0.05, `the part ends there: ${to}`);
  });
  await studio.eventually(async () => {
    const [take] = await takesOf(studio);
    expect(take.to < line.to, `the file knows: ${take.to} of ${line.to}`);
  });
  const part = await timeLine(studio);
  await studio.page.locator('.time-loop').click();
  await studio.page.locator('.time-speed').click();
  await studio.page.locator('.speed-add button').first().click();
  await studio.page.locator('.speed-piece').waitFor();
  await studio.shot('takes-speeds');
  await studio.page.keyboard.press('Escape');
  await studio.send({ type: 'Seek', step: part.to - 10 });
  await studio.send({ type: 'Playback', action: 0 });
  await studio.until('the part again', (middle) => globalThis.__muster.frame.step < middle, (part.from + part.to) / 2);
  expect(await studio.page.evaluate(() => globalThis.__muster.frame.playing), 'it plays over and over');
  await studio.shot('takes-trimmed');
  const overlaps = await studio.page.evaluate(() => {
    const { left, right } = document.querySelector('.time-line').getBoundingClientRect();
    const small = [...document.querySelectorAll('.time-line button')].filter(
      (button) => button.offsetParent && (button.offsetHeight < 44 || button.offsetWidth < 40),
    );
    return { out: left < 0 || right > innerWidth, small: small.map((button) => button.className) };
  });
  expect(!overlaps.out && overlaps.small.length === 0, `it fits and can be hit: ${JSON.stringify(overlaps)}`);
}

/** Directed again from its middle, and on top of what was recorded. */
export async function againAndOnTop(studio) {
  await record(studio, 2);
  await stop(studio);
  await play(studio);
  await pause(studio);
  const line = await timeLine(studio);
  const middle = Math.round((line.from + line.to) / 2);
  await studio.send({ type: 'Seek', step: middle });
  await studio.until('the middle', (step) => globalThis.__muster.frame.step === step, middle);
  await studio.page.locator('.time-again').click();
  await studio.until('live again', () => !globalThis.__muster.frame.replaying);
  await studio.wait(300);
  expect((await now(studio)) === middle, 'it waits for a hand');
  await drag(studio, 0, -2);
  await studio.until('it goes on', (step) => globalThis.__muster.frame.step > step + 60, middle);
  expect((await studio.frame()).recordedSeconds > 0.5, 'it is recorded');
  await stop(studio);
  expect((await takesOf(studio)).length === 2, 'both takes are kept');
  // On top: the second group is directed while the first does what was recorded.
  await studio.page.locator('.card-close').click();
  await openShelf(studio);
  await studio.page.locator('.shelf-item-open').last().click();
  await studio.until(
    'the first take',
    (from) => globalThis.__muster.frame.step >= from && globalThis.__muster.frame.replaying,
    line.from,
  );
  await pause(studio);
  await studio.send({ type: 'Seek', step: line.from });
  await studio.until('its beginning', (step) => globalThis.__muster.frame.step === step, line.from);
  await studio.page.locator('.time-layer').click();
  await studio.until('live again', () => !globalThis.__muster.frame.replaying);
  await studio.fit();
  await drag(studio, 1, 2);
  await studio.until('fingers of both', (from) => globalThis.__muster.frame.step > from + 90, line.from);
  await stop(studio);
  expect((await takesOf(studio)).length === 3, 'three takes are kept');
  const replayed = await studio.page.evaluate(async () => {
    const { takes } = await (await globalThis.__muster.ask('takes')).json();
    return (await globalThis.__muster.ask(`takes/${takes[0].name}/open`, { method: 'POST' })).status;
  });
  expect(replayed === 200, 'the layered take opens');
  await studio.until('its replay', () => globalThis.__muster.frame.replaying);
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await studio.until('its end', () => globalThis.__muster.state.notice?.code === 'replay-end', null, 30000);
  const { text } = await studio.page.evaluate(() => globalThis.__muster.state.notice);
  expect(!text.includes('differs'), text);
}

async function exportOf(studio, kind, settings = {}) {
  await studio.page.locator('.time-export').click();
  await studio.page.locator(`.export-dialog input[value="${kind}"]`).check();
  for (const [label, value] of Object.entries(settings))
    await studio.page.locator(`.export-dialog select[aria-label="${label}"]`).selectOption(value);
  if (kind === 'film') await studio.shot('takes-export');
  const began = Date.now();
  const [download] = await Promise.all([
    studio.page.waitForEvent('download', { timeout: 120000 }),
    studio.page.locator('.export-begin').click(),
  ]);
  const bytes = await readFile(await download.path());
  await studio.until('the word', () => /^Saved /.test(document.querySelector('.export-said').textContent));
  await studio.page.locator('.export-dialog [aria-label="Close the export"]').click();
  return { bytes, name: download.suggestedFilename(), ms: Date.now() - began };
}

/** Files for other programs from the server, pictures and films from the page. */
export async function exports(studio) {
  await record(studio, 1.5);
  await stop(studio);
  await play(studio);
  await pause(studio);
  const glb = await exportOf(studio, 'glb');
  const report = await validator.validateBytes(new Uint8Array(glb.bytes));
  expect(report.issues.numErrors === 0, `the GLB is valid: ${JSON.stringify(report.issues.messages.slice(0, 3))}`);
  expect(report.info.animationCount > 0, 'the GLB moves');
  const bvh = await exportOf(studio, 'bvh', { 'Frames a second': '24' });
  expect(bvh.bytes.subarray(0, 4).toString('latin1') === 'PK\u0003\u0004', 'the BVH files come in a ZIP');
  expect(bvh.bytes.includes('HIERARCHY') && bvh.name.endsWith('-bvh.zip'), bvh.name);
  const usd = await exportOf(studio, 'usda');
  expect(usd.bytes.subarray(0, 5).toString() === '#usda', 'USD');
  const binary = await exportOf(studio, 'usdc');
  expect(
    binary.bytes.subarray(0, 8).toString() === 'PXR-USDC' && binary.bytes.length < usd.bytes.length / 2,
    'binary USD',
  );
  const pedpy = await exportOf(studio, 'pedpy');
  expect(/^#/.test(pedpy.bytes.toString()), 'PedPy');
  const jupedsim = await exportOf(studio, 'jupedsim');
  expect(jupedsim.bytes.subarray(0, 15).toString() === 'SQLite format 3', 'JuPedSim');
  const page = await exportOf(studio, 'player-page');
  const html = page.bytes.toString();
  expect(
    page.name.endsWith('.html') && html.includes('customElements.define("muster-player"'),
    'a page with the script',
  );
  expect(/<muster-player src="data:[^"]*;base64,TVVTVEVSUEw/.test(html), 'and the crowd');
  const folder = await exportOf(studio, 'player-folder');
  expect(folder.name.endsWith('-player.zip') && folder.bytes.includes('crowd.muster-player'), folder.name);
  expect(folder.bytes.includes('MUSTERPL') && folder.bytes.includes('index.html'), 'page and crowd are in the ZIP');
  const png = await exportOf(studio, 'picture');
  expect(png.bytes.subarray(1, 4).toString() === 'PNG' && png.bytes.length > 5000, 'a picture');
  await studio.page.locator('.time-to').press('Home');
  await studio.eventually(async () => {
    const { from, to } = await timeLine(studio);
    expect(to - from < 20, `a short part: ${from} to ${to}`);
  });
  if ((await studio.page.locator('.export-dialog input[value="film"]').count()) === 0) return;
  const film = await exportOf(studio, 'film', { 'Frames a second': '24' });
  console.log(`measured: ${film.name}, ${film.bytes.length} bytes, made in ${film.ms} ms`);
  const played = await studio.page.evaluate(
    async ([base64, type]) => {
      const bytes = Uint8Array.from(globalThis.atob(base64), (c) => c.charCodeAt(0));
      const video = document.createElement('video');
      video.muted = true;
      video.src = URL.createObjectURL(new globalThis.Blob([bytes], { type }));
      await new Promise((done, fail) => {
        video.onseeked = done;
        video.onloadeddata = () => (video.currentTime = Math.min(0.1, video.duration / 2));
        video.onerror = () => fail(new Error(video.error?.message ?? 'no film'));
      });
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [64, 36];
      const context = canvas.getContext('2d');
      const colours = new Set();
      // A decoder may be done with a picture some time after the seek is.
      for (let tries = 0; tries < 100 && colours.size < 2; ++tries) {
        await new Promise((done) => requestAnimationFrame(done));
        context.drawImage(video, 0, 0, 64, 36);
        const { data } = context.getImageData(0, 0, 64, 36);
        for (let i = 0; i < data.length; i += 4) colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      }
      return { width: video.videoWidth, height: video.videoHeight, duration: video.duration, colours: colours.size };
    },
    [film.bytes.toString('base64'), film.name.endsWith('mp4') ? 'video/mp4' : 'video/webm'],
  );
  expect(played.width === 1280 && played.height === 720, `its size: ${played.width} × ${played.height}`);
  expect(played.duration > 0.15 && played.duration < 1, `its length: ${played.duration}`);
  expect(played.colours > 30, `it shows something: ${played.colours} colours`);
}

/** A killed server's recording is offered when it is back. */
export async function cutOff(studio, server) {
  await record(studio, 1.5);
  const other = await StudioPage.open(studio.context.browser(), server.url, { size: studio.size });
  await studio.until('another device', () => globalThis.__muster.state.directors.length === 2);
  server.kill();
  await studio.until('the banner', () => document.documentElement.hasAttribute('data-lost'));
  const again = await startStudio({ port: server.port, scenario: server.scenario, takes: server.takes });
  try {
    await studio.until('the offer', () => document.querySelector('.take-card')?.hidden === false, null, 30000);
    const heading = await studio.page.locator('.card-heading').textContent();
    expect(/cut off/.test(heading), heading);
    await other.connected();
    await other.wait(3500);
    expect(!(await visible(other, '.take-card')), 'only who recorded is told');
    await other.close();
    await studio.wait(250);
    await studio.shot('takes-cut-off');
    await studio.page.goto(server.url);
    await studio.until('the page again', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
    await openShelf(studio);
    await studio.wait(600);
    expect(!(await visible(studio, '.take-card')), 'it is offered once');
    await studio.page.locator('.shelf-item-open').first().click();
    await studio.until('the time line', () => document.querySelector('.time-line')?.hidden === false);
    await studio.until('its end', () => globalThis.__muster.state.notice?.code === 'replay-end', null, 30000);
    expect((await takesOf(studio))[0].finished === false, 'it has no end record');
  } finally {
    await again.stop();
  }
}

/** A take that is recorded late fills its time line; who leaves it is back in the world they left, as it was. */
export async function lateAndLeft(studio) {
  const wall = { kind: 'putThing', obstacle: { name: 'Wall', centre: [5, 5], radius: 0.5 } };
  await studio.send({ type: 'Edit', label: 'Wall', gesture: 0, commands: [wall], bodies: [] });
  await studio.send({ type: 'SetSpeed', factor: 8 });
  await studio.until('half a minute', () => globalThis.__muster.frame.step > 1800, null, 60000);
  await studio.send({ type: 'SetSpeed', factor: 1 });
  await record(studio, 2);
  await stop(studio);
  const left = await now(studio);
  await play(studio);
  await studio.until('the part', () => /^0:0\d\.\d of 0:0\d/.test(document.querySelector('.time-clock').textContent));
  await pause(studio);
  const ends = await studio.page.evaluate(() =>
    ['.time-from', '.time-to'].map((name) => parseFloat(document.querySelector(name).style.left)),
  );
  expect(ends[1] - ends[0] > 60, `the part fills most of the line: ${ends}`);
  await studio.shot('takes-late');
  await studio.page.locator('.time-close').click();
  await studio.until('the world', () => !globalThis.__muster.frame.replaying);
  expect((await now(studio)) >= left, 'it goes on where it was left');
  const { obstacles } = await studio.page.evaluate(async () => (await globalThis.__muster.ask('scenario')).json());
  expect(
    obstacles?.some(({ name }) => name === 'Wall'),
    'what was built stands',
  );
}
