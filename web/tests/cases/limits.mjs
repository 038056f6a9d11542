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

/** In the page: counts the pictures that it draws. */
function countPictures() {
  globalThis.__pictures = 0;
  const draw = () => {
    globalThis.__pictures += 1;
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
}

/** Processor time of the page's main thread while `act` runs [ms]: other processes, such as one that draws in software, may
 * keep it waiting, which does not count. */
async function mainThreadTime(page, act) {
  const tracing = await page.context().browser().newBrowserCDPSession();
  const events = [];
  tracing.on('Tracing.dataCollected', ({ value }) => events.push(...value));
  const traceConfig = { includedCategories: ['toplevel'] };
  await tracing.send('Tracing.start', { transferMode: 'ReportEvents', traceConfig });
  await act();
  const complete = new Promise((resolve) => tracing.once('Tracing.tracingComplete', resolve));
  await tracing.send('Tracing.end');
  await complete;
  const mains = new Set(
    events.filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain').map(({ pid }) => pid),
  );
  const times = new Map();
  for (const { name, pid, tid, tdur = 0 } of events)
    if (name.endsWith('RunTask') && pid === tid && mains.has(pid))
      times.set(name + pid, (times.get(name + pid) ?? 0) + tdur);
  return Math.max(0, ...times.values()) / 1000;
}

/** Main thread per frame while an obstacle is dragged before a thousand people. */
export async function editingThousand(studio) {
  const { page } = studio;
  const count = await page.evaluate(() => globalThis.__muster.frame.x.length);
  expect(count === 1000, `a thousand people: ${count}`);
  await studio.tab('view');
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
  const path = Array.from({ length: 9 }, (_, i) => spot(0.725 - 0.04 * (i % 3), 0.83 - 0.03 * (i % 2)));
  await page.mouse.move(path[0].x, path[0].y);
  await page.mouse.down();
  await page.evaluate(countPictures);
  const busy = await mainThreadTime(page, async () => {
    for (const at of path.slice(1)) await page.mouse.move(at.x, at.y, { steps: 16 });
  });
  const pictures = await page.evaluate(() => globalThis.__pictures);
  await page.mouse.up();
  expect(pictures >= 60, `pictures while it is dragged: ${pictures}`);
  expect(busy > 0, 'the main thread has been seen');
  const each = busy / pictures;
  console.log(`measured: ${each.toFixed(1)} ms of the main thread for each of ${pictures} pictures of a drag`);
}
