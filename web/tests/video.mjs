// A film of ten seconds that the page itself makes: node tests/video.mjs --out FILE [--scenario FILE] [--from 22]
// The scenario's demonstration is recorded, two views are kept on the time line, and Export makes the film.
import { mkdirSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { dirname } from 'node:path';
import { openChromium } from './support/chromium.mjs';
import { startStudio } from './support/server.mjs';
import { StudioPage } from './support/studio_page.mjs';

const kSeconds = 10;

function option(name, fallback) {
  const at = process.argv.indexOf(`--${name}`);
  return at > 0 ? process.argv[at + 1] : fallback;
}

const out = option('out', '');
if (!out) {
  console.error('Name a file for the film: npm run video -- --out film.mp4');
  process.exit(2);
}
const from = Number(option('from', 22));

/** Records the demonstration until that second. */
async function recordUntil(studio, second) {
  await studio.page.locator('.record').click();
  await studio.send({ type: 'Playback', action: 4 });
  await studio.send({ type: 'SetSpeed', factor: 8 });
  await studio.until('so much of it', (end) => globalThis.__muster.frame.time > end, second, 180000);
  await studio.page.locator('.record').click();
  await studio.until('the card', () => document.querySelector('.take-card')?.hidden === false);
  await studio.page.locator('.card-play').click();
  await studio.until('the time line', () => document.querySelector('.time-line')?.hidden === false);
  await studio.send({ type: 'SetSpeed', factor: 1 });
  await studio.send({ type: 'Playback', action: 1 });
}

async function keepView(studio, step) {
  await studio.send({ type: 'Seek', step });
  await studio.until('the moment', (wished) => globalThis.__muster.frame.step === wished, step, 60000);
  await studio.fit();
  await studio.wait(800);
  const menu = studio.page.locator('.camera-keys');
  if (!(await menu.isVisible())) await studio.page.locator('.time-camera').click();
  await menu.locator('.camera-keep').click();
}

const server = await startStudio({ scenario: option('scenario', 'scenarios/course.json') });
const browser = await openChromium();
const studio = await StudioPage.open(browser, server.url, { size: 'desktop', touch: false });
try {
  await recordUntil(studio, from + kSeconds + 0.5);
  const [first, last] = [from, from + kSeconds].map((second) => Math.round(second * 60));
  await keepView(studio, first);
  await keepView(studio, last);
  const state = await studio.page.evaluate(() => globalThis.__muster.state.title);
  await studio.send({ type: 'EditTake', title: state, from: first, to: last, loop: false, speeds: [], camera: [] });
  await studio.wait(500);
  await studio.page.locator('.time-export').click();
  await studio.page.locator('.export-dialog input[value="film"]').check();
  const began = Date.now();
  const [download] = await Promise.all([
    studio.page.waitForEvent('download', { timeout: 900000 }),
    studio.page.locator('.export-begin').click(),
  ]);
  const bytes = await readFile(await download.path());
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, bytes);
  console.log(
    `${download.suggestedFilename()}: ${bytes.length} bytes, made in ${((Date.now() - began) / 1000).toFixed(0)} s`,
  );
} finally {
  await studio.close();
  await browser.close();
  await server.stop();
}
