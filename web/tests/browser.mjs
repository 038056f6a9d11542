// The studio in a real browser: node tests/browser.mjs [--only WORD] (MUSTER=path names the program)
import { chromium } from 'playwright-core';
import * as look from './cases/look.mjs';
import * as mouseAndKeys from './cases/mouse_and_keys.mjs';
import * as realMaps from './cases/real_maps.mjs';
import * as session from './cases/session.mjs';
import * as touch from './cases/touch.mjs';
import { startStudio } from './support/server.mjs';
import { StudioPage } from './support/studio_page.mjs';

const FLAGS = ['--no-sandbox', '--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'];
const TABLETS = ['desktop', 'landscape', 'portrait'];

/** Name, test, sizes, and options of the page. */
const CASES = [
  ['latency', session.latency, ['desktop'], {}],
  ['point', touch.pointDrag, TABLETS, { room: true }],
  ['line', touch.lineDrag, TABLETS, { room: true }],
  ['area', touch.areaDrag, TABLETS, { room: true }],
  ['line and area together', touch.lineAndArea, TABLETS, { room: true }],
  ['drawing ahead and lifting', touch.drawAheadAndLift, TABLETS, { room: true }],
  ['another formation on the way', touch.formationOnTheWay, TABLETS, { room: true }],
  ['pinch on empty ground', touch.pinchOnGround, TABLETS, { room: true }],
  ['ten fingers', touch.tenFingers, ['desktop'], {}],
  ['mouse: point', mouseAndKeys.mousePoint, ['desktop'], { touch: false, room: true }],
  ['mouse: line', mouseAndKeys.mouseLine, ['desktop'], { touch: false, room: true }],
  ['mouse: area', mouseAndKeys.mouseArea, ['desktop'], { touch: false, room: true }],
  ['mouse: pin', mouseAndKeys.mousePin, ['desktop'], { touch: false, room: true }],
  ['mouse: camera', mouseAndKeys.mouseCamera, ['desktop'], { touch: false }],
  ['keyboard only', mouseAndKeys.keyboardOnly, ['desktop'], { touch: false, room: true }],
  ['record and replay', session.recordAndReplay, ['desktop'], { room: true }],
  ['a page that hangs', session.stalledPage, ['desktop'], {}],
  ['first visit', look.firstVisit, [...TABLETS, 'phone'], { hint: true }],
  ['layout', look.layout, [...TABLETS, 'phone'], {}],
  ['access', look.accessible, [...TABLETS, 'phone'], {}],
  ['lost and found', session.lostAndFound, ['landscape'], {}],
  // Minutes long: MUSTER_REAL_MAPS=1 asks for them.
  ...(process.env.MUSTER_REAL_MAPS ? realMaps.cases() : []),
];

const at = process.argv.indexOf('--only');
const only = at > 0 ? process.argv[at + 1] : '';
let server = await startStudio();
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: FLAGS });
let passed = 0;
const failed = [];

async function runCase(name, test, size, options) {
  const started = Date.now();
  let studio = null;
  try {
    studio = await StudioPage.open(browser, server.url, { size, ...options });
    await studio.restart();
    if (options.room) await studio.makeRoom();
    server = (await test(studio, server)) ?? server;
    if (studio.errors.length > 0) throw new Error(`the page complained: ${studio.errors.join('; ')}`);
    passed += 1;
    console.log(`ok    ${name} (${size}, ${((Date.now() - started) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed.push(`${name} (${size})`);
    console.log(`FAIL  ${name} (${size}): ${error.message}`);
    await studio?.shot(`failed-${name.replace(/\W+/g, '-')}`).catch(() => undefined);
  } finally {
    await studio?.close().catch(() => undefined);
  }
}

try {
  for (const [name, test, sizes, options] of CASES) {
    if (!name.includes(only)) continue;
    for (const size of sizes) await runCase(name, test, size, options);
  }
} finally {
  await browser.close();
  await server.stop();
}
for (const name of failed) console.log(`failed: ${name}`);
console.log(`${passed} passed, ${failed.length} failed`);
process.exit(failed.length > 0 ? 1 : 0);
