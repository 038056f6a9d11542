// A battle as the page shows it, one picture every few seconds: node tests/battle_film.mjs [--out FOLDER]
// [--scenario FILE] [--seconds 60] [--every 5] [--size desktop] [--scheme dark] [--queues]. Its orders come from its gestures file.
import { mkdirSync } from 'node:fs';
import { openChromium } from './support/chromium.mjs';
import { startStudio } from './support/server.mjs';
import { StudioPage } from './support/studio_page.mjs';

function option(name, fallback) {
  const at = process.argv.indexOf(`--${name}`);
  return at > 0 ? process.argv[at + 1] : fallback;
}

const out = option('out', new URL('../test-results/', import.meta.url).pathname);
const [seconds, every] = [Number(option('seconds', 60)), Number(option('every', 5))];
const [size, colorScheme] = [option('size', 'desktop'), option('scheme', 'light')];
mkdirSync(out, { recursive: true });

/** Plays up to a time of the world, and stops there. */
async function playTo(studio, time) {
  await studio.send({ type: 'Playback', action: 0 });
  await studio.until(`second ${time}`, (t) => globalThis.__muster.frame.time >= t, time, 300000);
  await studio.send({ type: 'Playback', action: 1 });
  await studio.until('the pause', () => !globalThis.__muster.frame.playing);
  await studio.pictures(2);
}

/** In the page: brings all groups and their queues into view. */
function lookAtQueues() {
  const { frame, view } = globalThis.__muster;
  const spots = frame.groups.flatMap((group) => [group, ...group.orders.filter((order) => order.kind === 0)]);
  const range = (values) => [Math.min(...values), Math.max(...values)];
  const [left, right] = range(spots.map(({ x }) => x));
  const [low, high] = range(spots.map(({ y }) => y));
  const { camera } = view;
  const distance = (Math.max(right - left, high - low) + 30) / (2 * Math.tan(camera.fieldOfView / 2));
  camera.setPose({ ...camera.pose, targetX: (left + right) / 2, targetY: (low + high) / 2, distance });
}

const server = await startStudio({ scenario: option('scenario', 'scenarios/battle.json'), port: 18380 });
const browser = await openChromium();
try {
  const studio = await StudioPage.open(browser, `${server.url}?quality=full`, { size, colorScheme, touch: false });
  const revision = await studio.page.evaluate(() => globalThis.__muster.frame.sceneRevision);
  await studio.send({ type: 'Playback', action: 4 });
  await studio.until('the battle', (before) => globalThis.__muster.frame.sceneRevision > before, revision);
  await studio.fit();
  await studio.page.keyboard.press('a');
  for (let time = 0; time <= seconds; time += every) {
    await playTo(studio, Math.max(0.2, time));
    if (process.argv.includes('--queues')) {
      await studio.page.evaluate(lookAtQueues);
      await studio.pictures(3);
    }
    const file = `battle-${size}-${colorScheme}-${String(time).padStart(2, '0')}s.png`;
    await studio.page.screenshot({ path: `${out}/${file}` });
    const { groups, x } = await studio.frame();
    const orders = groups.map((group) => group.orders.length).join(' ');
    console.log(`${file}: ${x.length} characters, ${groups.length} groups, orders ${orders}`);
  }
  if (studio.errors.length > 0) throw new Error(studio.errors.join('; '));
} finally {
  await browser.close();
  await server.stop();
}
