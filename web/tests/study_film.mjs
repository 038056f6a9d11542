// Film strips of the study: for each environment one trial by touch and one by the mouse with the same items, side by side at
// the same times. node tests/study_film.mjs --db FILE [--out FOLDER] [--mouse SCHEME] [--columns 5] [--size wide] [--dark]
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openChromium } from './support/chromium.mjs';
import { readCsv } from './support/csv.mjs';
import { runProgram, startStudy } from './support/server.mjs';
import { StudyPerson, kStage } from './support/study_person.mjs';

const kTitles = {
  'single-block': 'Single Block',
  corridor: 'Corridor',
  'multiple-paths': 'Multiple Paths',
  'four-blocks': 'Four Blocks',
};

function option(name, fallback) {
  const at = process.argv.indexOf(`--${name}`);
  return at > 0 ? process.argv[at + 1] : fallback;
}

const db = option('db', '');
const out = option('out', new URL('../test-results/', import.meta.url).pathname);
const columns = Number(option('columns', 5));
const size = option('size', 'wide');
const colorScheme = process.argv.includes('--dark') ? 'dark' : 'light';
if (db === '') {
  console.error('Found no --db FILE, expected the database of a study.');
  process.exit(2);
}
mkdirSync(out, { recursive: true });

function storedTrials() {
  const folder = mkdtempSync(join(tmpdir(), 'muster-film-'));
  try {
    const { status, stderr } = runProgram('study', 'export', '--db', db, '-o', folder);
    if (status !== 0) throw new Error(stderr);
    const kinds = new Map(readCsv(join(folder, 'runs.csv')).map(({ run, kind }) => [run, kind]));
    return readCsv(join(folder, 'trials.csv'))
      .filter(
        ({ practice, state, setting }) => practice === '0' && state === 'complete' && /^(default)?$/.test(setting),
      )
      .map((trial) => ({ ...trial, kind: kinds.get(trial.run) }));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** A trial by touch and one by the mouse with the same items: of all such pairs the one in the middle by its times. */
function pairOf(trials, environment) {
  const wanted = option('mouse', '');
  const isMouse = ({ scheme }) => (wanted === '' ? scheme.startsWith('mouse-full') : scheme === wanted);
  const of = trials.filter((trial) => trial.environment === environment);
  const mice = of.some(isMouse) ? of.filter(isMouse) : of.filter(({ scheme }) => scheme.startsWith('mouse'));
  const pairs = of
    .filter(({ scheme }) => scheme === 'touch')
    .flatMap((touch) => {
      const same = ({ seed, crowd, kind }) => seed === touch.seed && crowd === touch.crowd && kind === touch.kind;
      const mouse = mice.filter(same).sort((a, b) => Number(a.seconds) - Number(b.seconds))[0];
      return mouse ? [[touch, mouse]] : [];
    })
    .sort((a, b) => Number(a[0].seconds) + Number(a[1].seconds) - Number(b[0].seconds) - Number(b[1].seconds));
  return pairs[Math.floor(pairs.length / 2)] ?? null;
}

async function playTo(watcher, time) {
  const speed = (factor) =>
    watcher.page.evaluate((one) => globalThis.__muster.client.send({ type: 'SetSpeed', factor: one }), factor);
  const playback = (action) =>
    watcher.page.evaluate((one) => globalThis.__muster.client.send({ type: 'Playback', action: one }), action);
  if ((await watcher.frame()).time >= time) return;
  await speed(8);
  await playback(0);
  await watcher.until('it to play', () => globalThis.__muster.frame.playing);
  await watcher.until(
    `second ${time}`,
    (t) => globalThis.__muster.frame.time >= t || !globalThis.__muster.frame.playing,
    time,
    600000,
  );
  await playback(1);
  await watcher.wait(400);
}

/** The part of the page that shows the ground. */
async function groundOf(watcher) {
  const [low, high] = await watcher.screen([
    { x: -20, y: -11.25 },
    { x: 20, y: 11.25 },
  ]);
  const [x, y] = [Math.min(low.x, high.x), Math.min(low.y, high.y)];
  return { x, y, width: Math.abs(high.x - low.x), height: Math.abs(high.y - low.y) };
}

/** Pictures of one trial at these times [s]; its last one from its end on. */
async function pictures(browser, trial, times) {
  const server = await startStudy('replay', '--db', db, '--trial', trial.trial, '--studio', '--port', '18780');
  try {
    const watcher = await StudyPerson.open(browser, server.url, { size, colorScheme });
    await watcher.untilStage(kStage.replay);
    await watcher.until('the first frame', () => globalThis.__muster.frame !== null);
    await watcher.page.evaluate(() => globalThis.__muster.client.send({ type: 'Playback', action: 1 }));
    await watcher.wait(600);
    const shots = [];
    for (const time of times) {
      await playTo(watcher, Math.min(time, Number(trial.seconds) - 0.05));
      await watcher.page.evaluate(() => (document.querySelector('.study-toast').hidden = true));
      const shot = await watcher.page.screenshot({ type: 'jpeg', quality: 88, clip: await groundOf(watcher) });
      shots.push(shot.toString('base64'));
    }
    if (watcher.errors.length > 0) throw new Error(watcher.errors.join('; '));
    await watcher.close();
    return shots;
  } finally {
    await server.stop();
  }
}

const kWho = { models: 'operator model', people: 'person', test: 'test' };

/** One picture of both rows. */
async function strip(browser, title, rows, times, file) {
  const ink = colorScheme === 'dark' ? '#eef1f4' : '#171b20';
  const ground = colorScheme === 'dark' ? '#1f2429' : '#ffffff';
  const cells = rows.map(({ trial, shots }) => {
    const words = `${trial.scheme}, ${kWho[trial.kind]}: ${Number(trial.seconds).toFixed(1)} s, ${trial.collected} of ${trial.items} items`;
    const pictures = shots.map((shot) => `<img src="data:image/jpeg;base64,${shot}">`).join('');
    return `<h2>${words}</h2><div class="row">${pictures}</div>`;
  });
  const heads = times.map((time) => `<span>${time.toFixed(0)} s</span>`).join('');
  const page = await browser.newPage({ viewport: { width: 480 * columns + 48, height: 800 } });
  await page.setContent(`<style>
    body { margin: 0; padding: 20px 24px; background: ${ground}; color: ${ink}; font: 16px/22px Inter, system-ui, sans-serif }
    h1 { margin: 0 0 4px; font-size: 22px } h2 { margin: 14px 0 6px; font-size: 16px }
    .row { display: grid; grid-template-columns: repeat(${columns}, 1fr); gap: 8px } img { width: 100%; border-radius: 8px }
    </style><h1>${title}</h1><div class="row">${heads}</div>${cells.join('')}`);
  await page.screenshot({ path: join(out, file), fullPage: true });
  await page.close();
  console.log(join(out, file));
}

const trials = storedTrials();
const browser = await openChromium();
try {
  for (const [environment, title] of Object.entries(kTitles)) {
    const pair = pairOf(trials, environment);
    if (!pair) {
      console.error(`${title}: no two trials with the same items by touch and by the mouse`);
      process.exitCode = 1;
      continue;
    }
    const longest = Math.max(...pair.map(({ seconds }) => Number(seconds)));
    const times = Array.from({ length: columns }, (_, i) => (longest * i) / (columns - 1));
    const rows = [];
    for (const trial of pair) rows.push({ trial, shots: await pictures(browser, trial, times) });
    await strip(browser, title, rows, times, `study-${environment}.png`);
  }
} finally {
  await browser.close();
}
