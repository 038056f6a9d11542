// Film strips of the paper's experiments from the real page: node tests/film.mjs [--only WORD] [--out FOLDER]
// Six moments each, side by side, into docs/pictures. Takes minutes where there is no GPU.
import { fileURLToPath } from 'node:url';
import { openChromium } from './support/chromium.mjs';
import { writeStrip } from './support/film_strip.mjs';
import { startStudio } from './support/server.mjs';
import { kSizes, StudioPage } from './support/studio_page.mjs';

/** A moment as it is drawn, and in the strip [px]. */
const kTaken = { width: 592, height: 760 };
const kTile = { width: 296, height: 380, gap: 4 };

/** When [s], whom to look at (who plays this clip; all where empty), the height of the picture on the ground [m]. */
const kFilms = [
  {
    name: 'film-x04',
    scenario: 'paper/x04-woodland',
    turn: 0.33,
    moments: [
      [2.4, '', 10],
      [7.5, 'duck', 7.5],
      [13, 'duck', 7.5],
      [18.6, 'duck', 7.5],
      [25, 'duck', 7.5],
      [33, '', 10],
    ],
  },
  {
    name: 'film-x05',
    scenario: 'paper/x05-traffic',
    turn: 0.33,
    moments: [
      [0.8, '', 10],
      [3.2, 'jump', 8],
      [7, '', 10],
      [13.6, '', 11],
      [19.5, '', 11],
      [26.6, 'jump', 8],
    ],
  },
  {
    name: 'film-x06',
    scenario: 'paper/x06-course',
    turn: 0.6,
    moments: [
      [2.8, '', 10],
      [8.6, 'climb', 7],
      [34.4, 'jump-over', 7],
      [44, 'crawl', 7],
      [57, 'swim', 8],
      [63.9, 'swim-exit', 8],
    ],
  },
];

function option(name, fallback) {
  const at = process.argv.indexOf(`--${name}`);
  return at > 0 ? process.argv[at + 1] : fallback;
}

/** In the page: turns the camera to the middle of those who play a clip. */
function lookAt([clip, metres, turn]) {
  const { frame, view } = globalThis.__muster;
  const index = view.people.clips.indexOf(clip);
  const players = [...frame.clip.keys()].filter((i) => frame.clip[i] === index);
  const who = players.length > 0 ? players : [...frame.clip.keys()];
  const middle = (values) => who.map((i) => values[i]).sort((a, b) => a - b)[who.length >> 1];
  const { camera } = view;
  const distance = metres / (2 * Math.tan(camera.fieldOfView / 2));
  camera.setPose({ ...camera.pose, targetX: middle(frame.x), targetY: middle(frame.y), distance, turn });
}

async function playTo(studio, time) {
  await studio.send({ type: 'Playback', action: 0 });
  await studio.until(`second ${time}`, (t) => globalThis.__muster.frame.time >= t, time, 300000);
  await studio.send({ type: 'Playback', action: 1 });
}

async function shoot(studio, { scenario, moments, turn }) {
  await studio.page.addStyleTag({ content: '#ui, #overlay { visibility: hidden !important; }' });
  // The page's own camera stays out of it.
  await studio.page.evaluate(() =>
    Object.assign(globalThis.__muster.view, { fitCrowd: () => undefined, lookAt: () => undefined }),
  );
  await studio.restart();
  await studio.page.keyboard.press('w');
  await studio.until('the demonstration', () => globalThis.__muster.frame.demonstrating);
  await studio.page.keyboard.press('l');
  await studio.send({ type: 'SetSpeed', factor: 2 });
  const pictures = [];
  for (const [time, clip, metres] of moments) {
    await playTo(studio, time);
    for (let i = 0; i < 2; ++i) {
      await studio.page.evaluate(lookAt, [clip, metres, turn]);
      await studio.wait(1500);
    }
    const at = await studio.page.evaluate(() => globalThis.__muster.frame.time);
    pictures.push({ data: (await studio.page.screenshot()).toString('base64'), text: `${at.toFixed(0)} s` });
    console.log(`${scenario}: second ${at.toFixed(1)}`);
  }
  return pictures;
}

async function film(browser, one, folder) {
  const server = await startStudio({ scenario: `scenarios/${one.scenario}.json`, port: 18700 });
  try {
    const studio = await StudioPage.open(browser, `${server.url}?quality=full`, { size: 'film', touch: false });
    const pictures = await shoot(studio, one);
    await writeStrip(studio.context, `${folder}/${one.name}.png`, pictures, kTile);
    await studio.close();
  } finally {
    await server.stop();
  }
}

const folder = option('out', fileURLToPath(new URL('../../docs/pictures', import.meta.url)));
kSizes.film = kTaken;
const browser = await openChromium();
try {
  for (const one of kFilms) if (one.name.includes(option('only', ''))) await film(browser, one, folder);
} finally {
  await browser.close();
}
