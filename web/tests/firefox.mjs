// The studio in Firefox, by WebDriver BiDi: node tests/firefox.mjs (MUSTER=path names the program, FIREFOX=path the browser).
// Firefox draws WebGL only where there is a display; `npm run firefox` brings a virtual one. Fingers are tested in
// Chromium alone: Firefox refuses them over WebDriver where there is no touch screen.
import { spawnSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import puppeteer from 'puppeteer-core';
import { expect } from './support/expect.mjs';
import { startStudio } from './support/server.mjs';

const kFirefox = process.env.FIREFOX ?? '/usr/bin/firefox-esr';
const kSizes = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 760 } };
const kWait = { timeout: 60000 };
const kPreferences = { 'webgl.force-enabled': true };

const shots = fileURLToPath(new URL('../test-results/', import.meta.url));
mkdirSync(shots, { recursive: true });

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

async function openPage(browser, server, size) {
  const page = await browser.newPage();
  const errors = [];
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  await page.setViewport(kSizes[size]);
  await page.goto(server.url);
  await page.waitForFunction(() => (globalThis.__muster?.view.stats.shownFrame ?? 0) > 0, kWait);
  await page.evaluate(() => localStorage.setItem('muster.hint', 'seen'));
  return { page, errors };
}

/** Where the first group's formation has its centre [m], and a spot on it [client px]. */
const crowdOn = (page) =>
  page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const { x, y } = frame.groups[0];
    return { ground: { x, y }, at: view.worldToScreen({ x, y }) };
  });

async function movedFrom(page, before) {
  await page.waitForFunction(
    ({ x, y }) => {
      const group = globalThis.__muster.frame.groups[0];
      return Math.hypot(group.x - x, group.y - y) > 1;
    },
    kWait,
    before,
  );
}

/** A drag by the mouse moves the crowd; the wheel zooms. */
async function byMouse({ page }) {
  const { ground, at } = await crowdOn(page);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  for (let i = 1; i <= 12; ++i) {
    await page.mouse.move(at.x + 12 * i, at.y - 4 * i);
    await wait(40);
  }
  await page.mouse.up();
  await movedFrom(page, ground);
  const distance = () => page.evaluate(() => globalThis.__muster.view.camera.pose.distance);
  const far = await distance();
  await page.mouse.move(300, 300);
  await page.mouse.wheel({ deltaY: -300 });
  await wait(600);
  expect((await distance()) < far, 'the wheel brings the camera nearer');
}

/** Another formation, keys, and a take that is recorded, kept and played. */
async function formationAndTake({ page }) {
  await page.keyboard.press('5');
  await page.waitForFunction(() => globalThis.__muster.state.groups[0].formation === 'ring', kWait);
  await page.click('.record');
  await page.waitForFunction(() => globalThis.__muster.frame.recordedSeconds > 1, kWait);
  await page.click('.record');
  await page.waitForFunction(() => document.querySelector('.take-card')?.hidden === false, kWait);
  await page.click('.card-play');
  await page.waitForFunction(
    () => globalThis.__muster.frame.replaying && document.querySelector('.time-line')?.hidden === false,
    kWait,
  );
  await page.click('.time-close');
  await page.waitForFunction(() => !globalThis.__muster.frame.replaying, kWait);
}

const kCases = [
  ['by mouse', byMouse, 'desktop'],
  ['by mouse on a small window', byMouse, 'phone'],
  ['formation and take', formationAndTake, 'desktop'],
];

if (spawnSync(kFirefox, ['--version']).error) {
  console.error(`There is no ${kFirefox}: install firefox-esr, or name another by FIREFOX=...`);
  process.exit(2);
}
const server = await startStudio({ scenario: 'scenarios/open.json', port: 18480 });
const browser = await puppeteer.launch({
  browser: 'firefox',
  executablePath: kFirefox,
  headless: process.env.DISPLAY === undefined,
  extraPrefsFirefox: kPreferences,
});
let passed = 0;
let failed = 0;
for (const [name, test, size] of kCases) {
  const started = Date.now();
  let opened = null;
  try {
    opened = await openPage(browser, server, size);
    await test(opened);
    expect(opened.errors.length === 0, `the page complained: ${opened.errors.join('; ')}`);
    passed += 1;
    console.log(`ok    firefox: ${name} (${size}, ${((Date.now() - started) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed += 1;
    console.log(`FAIL  firefox: ${name} (${size}): ${error.message}`);
  }
  await opened?.page.screenshot({ path: `${shots}firefox-${name.replace(/\W+/g, '-')}.png` }).catch(() => undefined);
  await opened?.page.close().catch(() => undefined);
}
await browser.close();
await server.stop();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
