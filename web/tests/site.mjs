// The studio without a server: a folder of `muster site`, served by another web server, in Chromium. Usage:
//     node tests/site.mjs FOLDER [--only 'name']
import { existsSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import * as build from './cases/build.mjs';
import * as buildPeople from './cases/build_people.mjs';
import * as measures from './cases/measures.mjs';
import * as site from './cases/site.mjs';
import * as standby from './cases/standby.mjs';
import * as takes from './cases/takes.mjs';
import { openChromium } from './support/chromium.mjs';
import { serve } from './support/plain_server.mjs';
import { StudioPage } from './support/studio_page.mjs';

/** Scenarios stand in the address; the first one is that of the site. */
const kOpen = '#scenario=open';

/** Name, test, sizes, options of the page; `address` is what follows the site's. */
const kCases = [
  ['first load', site.firstLoad, ['desktop'], { fresh: true, touch: false }],
  ['touches', site.touches, ['phone', 'portrait'], {}],
  ['scenarios', site.scenarios, ['desktop'], { touch: false }],
  ['takes outlast the page', site.takesStay, ['desktop', 'phone'], { address: kOpen }],
  ['the same hashes as the program', site.sameHashes, ['desktop'], { address: kOpen }],
  ['links', site.links, ['desktop'], { address: kOpen }],
  ['scrub and trim', takes.scrubAndTrim, ['desktop'], { address: kOpen }],
  ['exports for JuPedSim', site.jupedsim, ['desktop'], { address: kOpen }],
  ['exports', takes.exports, ['desktop'], { address: kOpen }],
  ['build', build.numbers, ['wide'], { address: kOpen, touch: false, room: true }],
  ['measures', measures.doorOnSite, ['desktop'], { address: kOpen }],
  ['build: persons', buildPeople.persons, ['desktop'], { address: kOpen, room: true }],
  ['go on without the server', standby.goesOn, ['desktop', 'phone'], { fresh: true }],
  ['no engine, no button', standby.withoutEngine, ['desktop'], { fresh: true }],
  ['large crowds', site.largeCrowds, ['desktop'], { address: kOpen, touch: false }],
  ['threads', site.threads, ['desktop'], { address: kOpen, touch: false }],
  ['without a network', site.offline, ['desktop', 'phone'], {}],
];

async function attempt(browser, server, { test, size, options }) {
  if (options.fresh) return test(browser, server, size);
  const studio = await StudioPage.open(browser, `${server.url}${options.address ?? ''}`, { size, ...options });
  try {
    await studio.restart();
    await studio.fit();
    if (options.room) await studio.makeRoom();
    await test(studio, server);
    if (studio.errors.length > 0) throw new Error(`the page complained: ${studio.errors.join('; ')}`);
  } catch (error) {
    await studio.shot('failed-site').catch(() => undefined);
    throw error;
  } finally {
    await studio.close().catch(() => undefined);
  }
}

/** Each case has a second try, as on a machine that is busy with something else. */
async function runCase(browser, server, one) {
  for (let tried = 1; tried <= 2; ++tried) {
    const started = Date.now();
    try {
      await attempt(browser, server, one);
      console.log(`ok    site: ${one.name} (${one.size}, ${((Date.now() - started) / 1000).toFixed(1)} s)`);
      if (tried > 1) console.log(`measured: passed at the second try: site: ${one.name} (${one.size})`);
      return true;
    } catch (error) {
      console.log(`${tried === 1 ? 'again' : 'FAIL '} site: ${one.name} (${one.size}): ${error.message}`);
    }
  }
  return false;
}

const folder = process.argv[2];
if (!folder) {
  console.error('Name the folder of a site: node tests/site.mjs FOLDER');
  process.exit(2);
}
const at = process.argv.indexOf('--only');
const only = at > 0 ? process.argv[at + 1] : '';
const server = await serve(resolve(folder));
server.engine = join(resolve(folder), 'engine');
server.empty = mkdtempSync(join(tmpdir(), 'muster-no-engine-'));
const browser = await openChromium();
let [passed, failed] = [0, 0];
for (const [name, test, sizes, options] of kCases)
  for (const size of sizes) {
    if (!name.includes(only)) continue;
    if (name === 'threads' && !existsSync(join(server.engine, 'muster-engine-threads.wasm'))) continue;
    if (await runCase(browser, server, { name, test, size, options })) passed += 1;
    else failed += 1;
  }
await browser.close();
server.stop();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
