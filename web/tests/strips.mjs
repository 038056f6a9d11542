// Film strips of an animator's jobs, by real mouse and fingers: node tests/strips.mjs --out FOLDER [--only JOB] [--size SIZE]
// Six moments of each job side by side, on a desktop, a tablet and a phone. --each writes every moment in full size, too.
import { mkdirSync, writeFileSync } from 'node:fs';
import { openChromium } from './support/chromium.mjs';
import { writeStrip } from './support/film_strip.mjs';
import { Hand } from './support/hand.mjs';
import { startStudio } from './support/server.mjs';
import { kSizes, StudioPage } from './support/studio_page.mjs';
import * as crowds from './strips/crowds.mjs';
import * as direct from './strips/direct.mjs';
import * as directors from './strips/directors.mjs';
import * as firstVisit from './strips/first_visit.mjs';
import * as places from './strips/places.mjs';
import * as takes from './strips/takes.mjs';

const kJobs = { 'first-visit': firstVisit, place: places, crowd: crowds, direct, takes, directors };
/** Name of the size, whether it is touched, and width of a moment in the strip [px]. */
const kDevices = [
  ['wide', false, 640],
  ['portrait', true, 410],
  ['phone', true, 300],
];
const kMoments = 6;

function option(name, fallback) {
  const at = process.argv.indexOf(`--${name}`);
  return at > 0 ? process.argv[at + 1] : fallback;
}

const folder = option('out', '');
if (!folder) {
  console.error('Name a folder for the strips: npm run strips -- --out FOLDER');
  process.exit(2);
}
mkdirSync(folder, { recursive: true });

async function strip(browser, name, job, [size, touch, width]) {
  const server = await startStudio({ scenario: job.scenario, options: job.options });
  const studio = await StudioPage.open(browser, server.url, { size, touch, hint: job.hint });
  const pictures = [];
  const take = async (text, seen = studio) => {
    await seen.pictures(2);
    const png = await seen.page.screenshot();
    pictures.push({ data: png.toString('base64'), text });
    if (process.argv.includes('--each')) writeFileSync(`${folder}/${name}-${size}-${pictures.length}.png`, png);
  };
  try {
    await job.play({ studio, hand: new Hand(studio, touch), take, touch, size, server });
    if (pictures.length !== kMoments) throw new Error(`${pictures.length} moments instead of ${kMoments}`);
    if (studio.errors.length > 0) throw new Error(`the page complained: ${studio.errors.join('; ')}`);
  } catch (error) {
    await take('failed').catch(() => undefined);
    throw new Error(`${name} (${size}), after “${pictures.at(-2)?.text ?? 'opening'}”: ${error.message}`);
  } finally {
    const { width: w, height: h } = kSizes[size];
    const tile = { width, height: Math.round((width * h) / w) + 30, gap: 6, foot: 30 };
    if (pictures.length > 0) await writeStrip(studio.context, `${folder}/${name}-${size}.png`, pictures, tile);
    await studio.close();
    await server.stop();
  }
  console.log(`${name} (${size})`);
}

const browser = await openChromium();
const failed = [];
try {
  for (const [name, job] of Object.entries(kJobs).filter(([one]) => one.includes(option('only', ''))))
    for (const device of kDevices.filter(([size]) => size.includes(option('size', ''))))
      await strip(browser, name, job, device).catch((error) => failed.push(error.message));
} finally {
  await browser.close();
}
for (const one of failed) console.error(`failed: ${one}`);
process.exit(failed.length > 0 ? 1 : 0);
