// What the page may cost: until it can be seen and used, and while a place with a thousand people is edited.
import { expect } from '../support/expect.mjs';
import { percentile } from '../support/geometry.mjs';
import { kSizes } from '../support/studio_page.mjs';

const kVisits = 5;

/** In a page that loads: when the crowd is seen first. */
function watchFirstFrame() {
  const look = () => {
    if ((globalThis.__muster?.view.stats.shownFrame ?? 0) > 0) globalThis.__firstFrame = performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** A browser that has never been here: first picture, first frame with the crowd [ms], and what it complained of. */
async function visit(browser, url, size) {
  const context = await browser.newContext({ viewport: kSizes[size] });
  try {
    const page = await context.newPage();
    const errors = [];
    page.on('pageerror', (error) => errors.push(error.message));
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
    await page.addInitScript(watchFirstFrame);
    await page.goto(url);
    await page.waitForFunction(() => globalThis.__firstFrame > 0, null, { timeout: 20000, polling: 50 });
    const picture = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
    return { picture, frame: await page.evaluate(() => globalThis.__firstFrame), errors };
  } finally {
    await context.close();
  }
}

/** Cold pages on a warm server. */
export async function firstPicture(studio, server) {
  const browser = studio.context.browser();
  // Another page that draws would take the processor.
  await studio.page.close();
  const visits = [];
  for (let i = 0; i < kVisits; ++i) visits.push(await visit(browser, server.url, studio.size));
  const errors = visits.flatMap((one) => one.errors);
  expect(errors.length === 0, `the console is quiet: ${errors.join('; ')}`);
  const [picture, frame] = ['picture', 'frame'].map((key) => visits.map((one) => one[key]));
  const told = (values) => `${percentile(values, 0.5).toFixed(0)} ms (most ${Math.max(...values).toFixed(0)} ms)`;
  console.log(`measured: first picture after ${told(picture)}, first frame with the crowd after ${told(frame)}`);
}

/** In the page: counts the frames before which the pointer has moved. */
function countFrames() {
  globalThis.__frames = 0;
  let due = false;
  globalThis.addEventListener(
    'pointermove',
    () => {
      if (due) return;
      due = true;
      requestAnimationFrame(() => {
        due = false;
        globalThis.__frames += 1;
      });
    },
    true,
  );
}

/** Main thread per frame while an obstacle is dragged before a thousand people. */
export async function editingThousand(studio) {
  const { page, cdp } = studio;
  const count = await page.evaluate(() => globalThis.__muster.frame.x.length);
  expect(count === 1000, `a thousand people: ${count}`);
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await page.locator('.build-panel').waitFor();
  const tool = (name) => page.locator('.build-panel').getByRole('button', { name, exact: true }).click();
  const { width, height } = page.viewportSize();
  const spot = (x, y) => ({ x: width * x, y: height * y });
  const draw = async (spots, steps) => {
    await page.mouse.move(spots[0].x, spots[0].y);
    await page.mouse.down();
    for (const at of spots.slice(1)) await page.mouse.move(at.x, at.y, { steps });
    await page.mouse.up();
  };
  await tool('Box');
  await draw([spot(0.7, 0.8), spot(0.75, 0.86)], 4);
  await tool('Select');
  await studio.wait(1500);
  await page.evaluate(countFrames);
  await cdp.send('Performance.enable');
  const read = async () => {
    const { metrics } = await cdp.send('Performance.getMetrics');
    const frames = await page.evaluate(() => globalThis.__frames);
    return { busy: metrics.find(({ name }) => name === 'TaskDuration').value * 1000, frames };
  };
  const before = await read();
  const path = Array.from({ length: 9 }, (_, i) => spot(0.725 - 0.04 * (i % 3), 0.83 - 0.03 * (i % 2)));
  await page.mouse.move(path[0].x, path[0].y);
  await page.mouse.down();
  for (const at of path.slice(1)) await page.mouse.move(at.x, at.y, { steps: 16 });
  const after = await read();
  await page.mouse.up();
  const frames = after.frames - before.frames;
  expect(frames >= 60, `frames while it is dragged: ${frames}`);
  const each = (after.busy - before.busy) / frames;
  console.log(`measured: ${each.toFixed(1)} ms of the main thread for each of ${frames} frames of a drag`);
}
