// The player for other pages: its files read by its own code and compared with other exports, and the component in Chromium,
// served by a web server that knows nothing of Muster. Usage:
//     node tests/player.mjs FOLDER [--only 'name'] [--shots FOLDER]
import { spawn } from 'node:child_process';
import { createServer } from 'node:net';
import { cpSync, existsSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { chromium } from 'playwright-core';
import * as files from './cases/player_files.mjs';
import * as pages from './cases/player_pages.mjs';
import * as trouble from './cases/player_trouble.mjs';

const kFlags = ['--no-sandbox', '--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'];
const kDesktop = { viewport: { width: 840, height: 640 } };
const kPhone = { viewport: { width: 390, height: 780 }, deviceScaleFactor: 1.5, hasTouch: true, isMobile: true };

/** Name, test, options of the browser's context; without options the case needs no browser. */
const kCases = [
  ['sizes', files.sizes],
  ['places are those of the trajectories', files.places],
  ['bodies stand as the joints do', files.bodies],
  ['ground and things are those of the GLB', files.ground],
  ['a plain page', pages.plainPage, kDesktop],
  ['people are drawn where they are', pages.people, kDesktop],
  ['two players', pages.twoPlayers, kDesktop],
  ['many players', pages.manyPlayers, kDesktop],
  ['mouse, wheel and keys', pages.mouseAndKeys, kDesktop],
  ['touch', pages.touch, kPhone],
  ['attributes', pages.attributes, kDesktop],
  ['a dark page', pages.dark, { ...kDesktop, colorScheme: 'dark' }],
  ['a page from the disk', pages.fromDisk, kDesktop],
  ['a folder for a web host', pages.folder, kPhone],
  ['reduced motion', pages.reducedMotion, { ...kDesktop, reducedMotion: 'reduce' }],
  ['broken files', trouble.files, kDesktop],
  ['no WebGL', trouble.noWebGl, kDesktop],
  ['a lost context', trouble.lostContext, kDesktop],
  ['comings and goings', trouble.comings, kDesktop],
];

function freePort() {
  return new Promise((done) => {
    const probe = createServer().listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });
}

async function serve(folder) {
  const port = await freePort();
  const options = ['-m', 'http.server', String(port), '--bind', '127.0.0.1'];
  const child = spawn('python3', options, { cwd: folder, stdio: 'ignore' });
  const url = `http://127.0.0.1:${port}/`;
  for (let tries = 0; tries < 100; ++tries) {
    const answers = await fetch(url).then(
      (answer) => answer.ok,
      () => false,
    );
    if (answers) return { url, stop: () => child.kill() };
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error('The web server does not answer.');
}

async function attempt(browser, host, test, options) {
  if (!options) return test(host.folder);
  const context = await browser.newContext(options);
  try {
    const page = await context.newPage();
    const errors = [];
    page.on('pageerror', (error) => errors.push(error.message));
    await test(page, host);
    if (errors.length > 0) throw new Error(`the page complained: ${errors.join('; ')}`);
  } finally {
    await context.close();
  }
}

function option(name) {
  const at = process.argv.indexOf(name);
  return at > 0 ? process.argv[at + 1] : '';
}

const folder = resolve(process.argv[2] ?? '');
if (!existsSync(join(folder, 'market.muster-player'))) {
  console.error('Name a folder that tests/player/run.sh filled: node tests/player.mjs FOLDER');
  process.exit(2);
}
const script = new URL('../dist/player/muster-player.js', import.meta.url).pathname;
cpSync(script, join(folder, 'muster-player.js'));
writeFileSync(join(folder, 'plain.html'), pages.kPlain);
const host = { folder, shots: option('--shots'), ...(await serve(folder)) };
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: kFlags });
let [passed, failed] = [0, 0];
for (const [name, test, options] of kCases) {
  if (!name.includes(option('--only'))) continue;
  const began = Date.now();
  try {
    await attempt(browser, host, test, options);
    console.log(`ok    player: ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
    ++passed;
  } catch (error) {
    console.log(`FAIL  player: ${name}: ${error.message}`);
    ++failed;
  }
}
await browser.close();
host.stop();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
