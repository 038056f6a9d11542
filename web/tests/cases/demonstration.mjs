// Watching what a scenario shows: chosen from the list by touch, begun and ended by its button.
import { expect } from '../support/expect.mjs';
import { crowd, distance } from '../support/geometry.mjs';
import { layout } from './look.mjs';

const kName = 'paper/x04-woodland';

const watchButton = (studio) => studio.page.locator('.playback .watch');

async function tap(studio, locator) {
  const box = await locator.boundingBox();
  await studio.fingers.down({ 1: { x: box.x + box.width / 2, y: box.y + box.height / 2 } });
  await studio.wait(50);
  await studio.fingers.up();
}

/** Waits until the list scrolls no more. */
async function atRest(studio) {
  let last = -1;
  await studio.eventually(async () => {
    const at = await studio.page.evaluate(() => document.querySelector('.scenario-scroll').scrollTop);
    const still = at === last;
    last = at;
    expect(still, 'the list comes to rest');
  });
}

/** Drags the list up until the item stands inside it, above the ways to one's own places. */
async function scrollTo(studio, item) {
  const list = await studio.page.locator('.scenario-scroll').boundingBox();
  for (let i = 0; i < 12; ++i) {
    const box = await item.boundingBox();
    const places = await studio.page.locator('.scenario-places').boundingBox();
    if (box.y + box.height < places.y) return;
    const x = list.x + list.width / 2;
    await studio.fingers.down({ 1: { x, y: list.y + 0.8 * list.height } });
    await studio.fingers.move({ 1: { x, y: list.y + 0.3 * list.height } }, { steps: 8, ms: 160 });
    // A finger that rests before it lifts leaves no swing.
    await studio.wait(100);
    await studio.fingers.up();
    await atRest(studio);
  }
  throw new Error('the list does not scroll to the item');
}

async function chooseByTouch(studio) {
  await tap(studio, studio.page.locator('.scenario-button'));
  const heading = studio.page.locator('.scenario-heading').first();
  expect(
    (await heading.textContent()) === 'The paper’s experiments',
    `a heading for the folder: ${await heading.textContent()}`,
  );
  await studio.shot('scenario-groups');
  const title = await studio.page.evaluate(
    (name) => globalThis.__muster.state.scenarios.find((one) => one.name === name).title,
    kName,
  );
  const item = studio.page.locator('.scenario-item', { hasText: title });
  await scrollTo(studio, item);
  await studio.shot('scenario-groups-scrolled');
  await tap(studio, item);
  await studio.until('the chosen scenario', (wanted) => globalThis.__muster.state.scenario === wanted, kName);
  await studio.until(
    'its crowd',
    () => globalThis.__muster.frame.time < 3 && globalThis.__muster.frame.groups.length > 0,
  );
  await studio.fit();
}

export async function demonstration(studio) {
  await chooseByTouch(studio);
  expect((await watchButton(studio).getAttribute('aria-pressed')) === 'false', 'nothing runs at first');
  const before = await studio.frame();
  await tap(studio, watchButton(studio));
  await studio.until(
    'the pressed button',
    () => document.querySelector('.watch').getAttribute('aria-pressed') === 'true',
  );
  await studio.until('the spoken word', () =>
    /demonstration is running/.test(document.querySelector('[role="status"].unseen').textContent),
  );
  await studio.until('controls under fingers', () =>
    globalThis.__muster.frame.groups[0].controls.some((control) => control.points.some((point) => point.down)),
  );
  const held = await studio.frame();
  expect(
    held.groups[0].controls.every((control) => control.client !== held.me),
    'the controls are not ours',
  );
  await studio.until('marks at the handles', marked);
  await studio.pictures(2);
  await studio.shot('watching');
  await layout(studio);
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await studio.until(
    'half of the crowd to move',
    (start) => {
      const { frame } = globalThis.__muster;
      const walked = start.filter(({ x, y }, i) => Math.hypot(frame.x[i] - x, frame.y[i] - y) > 1);
      return walked.length > start.length / 2;
    },
    crowd(before),
    30000,
  );
  await staysInView(studio);
  await tap(studio, watchButton(studio));
  await studio.until('the plain start', () => {
    const { frame } = globalThis.__muster;
    return (
      frame.groups[0].controls.length === 0 && document.querySelector('.watch').getAttribute('aria-pressed') === 'false'
    );
  });
  await studio.eventually(async () => {
    const after = crowd(await studio.frame());
    const farthest = Math.max(...crowd(before).map((p, i) => distance(p, after[i])));
    expect(farthest < 0.5, `pressed again all stand at the start: ${farthest} m`);
    expect((await shareInView(studio)) > 0.95, 'and the view is back there');
  });
}

/** The camera goes along with the crowd: far into its way most of it is still to be seen. */
async function staysInView(studio) {
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await studio.until('eleven seconds of it', () => globalThis.__muster.frame.time > 11, null, 60000);
  await studio.send({ type: 'SetSpeed', factor: 1 });
  await studio.eventually(async () => {
    const share = await shareInView(studio);
    expect(share > 0.8, `${share} of the crowd is in view`);
  });
  await studio.shot('watching-on');
}

function shareInView(studio) {
  return studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const at = Array.from(frame.x, (x, i) => view.worldToScreen({ x, y: frame.y[i] }));
    return at.filter((p) => p.x > 0 && p.y > 0 && p.x < innerWidth && p.y < innerHeight).length / at.length;
  });
}

/** In the page: whether the canvas of marks has paint where the handles stand. */
function marked() {
  const { frame, view } = globalThis.__muster;
  const canvas = document.querySelector('canvas.marks');
  const box = canvas.getBoundingClientRect();
  if (canvas.hidden || box.width === 0) return false;
  const ratio = canvas.width / box.width;
  const pen = canvas.getContext('2d');
  return frame.groups[0].controls
    .flatMap((control) => [...control.points])
    .every((point) => {
      const at = view.worldToScreen({ x: point.x, y: point.y });
      const { data } = pen.getImageData((at.x - box.left) * ratio - 8, (at.y - box.top) * ratio - 8, 16, 16);
      return data.some((value, i) => i % 4 === 3 && value > 0);
    });
}
