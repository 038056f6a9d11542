// The player for other pages: its files read by its own code and compared with other exports, and the component in Chromium,
// served by a web server that knows nothing of Muster. Usage:
//     node tests/player.mjs FOLDER [--only 'name'] [--shots FOLDER]
import { cpSync, existsSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import * as files from './cases/player_files.mjs';
import * as pages from './cases/player_pages.mjs';
import * as trouble from './cases/player_trouble.mjs';
import { openChromium } from './support/chromium.mjs';
import { serve } from './support/plain_server.mjs';

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
const host = { shots: option('--shots'), ...(await serve(folder)) };
const browser = await openChromium();
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
