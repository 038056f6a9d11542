// Forecasts of orders that are drawn, ways of orders that wait, and edits of queues, by mouse and by touch.
import { expect, expectBetween } from '../support/expect.mjs';
import * as look from './look.mjs';

/** In the page: what is shown of the order that is being drawn. */
const forecasts = () => globalThis.__muster.view.orders.scene(true).forecasts;

const orders = async (studio) => (await studio.frame()).groups[0].orders;
const targets = async (studio) =>
  (await orders(studio)).map(({ target: [x, y] }) => `${Math.round(x)},${Math.round(y)}`);
const chip = (studio, number) => studio.page.locator('.queue-chip').nth(number - 1);
const act = (studio, label) => studio.page.locator(`.queue-act[aria-label="${label}"]`);

async function targetsToBe(studio, wanted) {
  await studio.eventually(async () => {
    const found = await targets(studio);
    expect(found.join(' ') === wanted.join(' '), `targets are ${found.join(' ')}, not ${wanted.join(' ')}`);
  });
}

const widest = (way) => Math.max(...way.map(({ y }) => Math.abs(y)));

/** The granary, 5 m by 9 m, lies between the crowd and its target: the way shown leads round it. */
export async function forecastByMouse(studio) {
  const { mouse } = studio.page;
  const [outside, behind, beside] = await studio.screen([
    { x: -13, y: 17 },
    { x: 6, y: -2 },
    { x: 6, y: 2 },
  ]);
  await mouse.move(behind.x, behind.y);
  await mouse.down({ button: 'right' });
  await mouse.move(beside.x, beside.y, { steps: 10 });
  await studio.until('a forecast', () => globalThis.__muster.view.orders.scene(true).forecasts.length === 1);
  await studio.wait(300);
  const [forecast] = await studio.page.evaluate(forecasts);
  expect(forecast.arrives, 'it arrives');
  expect(widest(forecast.way) > 4.5, `its way leads round the granary: ${widest(forecast.way).toFixed(1)} m`);
  const [minutes, seconds] = /^in (\d+):(\d\d)$/.exec(forecast.text)?.slice(1).map(Number) ?? [];
  // At least 17 m, at most at a run, and less than a minute.
  expectBetween(60 * minutes + seconds, 4, 60, `time until it arrives (${forecast.text})`);
  await studio.pictures(2);
  await studio.shot('forecast');
  await mouse.up({ button: 'right' });
  await studio.until('the order', () => globalThis.__muster.frame.groups[0].orders.length === 1);
  const left = await studio.page.evaluate(forecasts);
  expect(left.length === 0, 'no forecast is left');
  await mouse.move(outside.x, outside.y);
  await mouse.down({ button: 'right' });
  await studio.until('no way', () => globalThis.__muster.view.orders.scene(true).forecasts[0]?.arrives === false);
  await studio.pictures(2);
  await studio.shot('forecast-no-way');
  const [no] = await studio.page.evaluate(forecasts);
  expect(no.text === 'Cannot be reached', `it says so: ${no.text}`);
  await mouse.up({ button: 'right' });
}

/** A finger with the order tool: the same, before it lifts. */
export async function forecastByTouch(studio) {
  await studio.page.locator('.order-tile[data-tool="order"]').click();
  const [a, b] = await studio.screen([
    { x: 4, y: -1.5 },
    { x: 4, y: 1.5 },
  ]);
  await studio.fingers.down({ 1: a });
  await studio.fingers.move({ 1: b });
  await studio.until('a forecast', () => globalThis.__muster.view.orders.scene(true).forecasts.length === 1);
  await studio.pictures(2);
  await studio.shot('forecast');
  const [forecast] = await studio.page.evaluate(forecasts);
  expect(forecast.arrives && widest(forecast.way) > 4.5, 'its way leads round the granary');
  await studio.fingers.up([1]);
  await studio.until('the order', () => globalThis.__muster.frame.groups[0].orders.length === 1);
  await studio.page.locator('.order-tile[data-tool="steer"]').click();
}

/** Orders that wait are drawn by the ways that they will take. */
export async function waysOfQueues(studio) {
  await studio.page.keyboard.press('.');
  await queueUpPaused(studio, [
    { x: 7, y: 0 },
    { x: -9, y: 0 },
    { x: 6, y: -1 },
  ]);
  await studio.eventually(async () => {
    const ways = await studio.page.evaluate(() => [...globalThis.__muster.view.orders.scene(true).ways]);
    expect(ways.length >= 3, `ways are known: ${ways.length}`);
    for (const [order, way] of ways)
      expect(widest(way) > 4.5, `the way of ${order} leads round the granary: ${widest(way).toFixed(1)} m`);
  });
  const spans = await studio.page.locator('.queue-span').allTextContents();
  const seconds = spans.map((span) => span.split(':').reduce((sum, part) => 60 * sum + Number(part), 0));
  expect(seconds.length === 3 && seconds[0] < seconds[1] && seconds[1] < seconds[2], `times rise: ${spans.join(' ')}`);
  await studio.pictures(2);
  await studio.shot('queue-ways');
}

/** By mouse: insert between, move, drag, cancel, skip, undo. */
export async function editQueue(studio) {
  const { page } = studio;
  await page.keyboard.press('.');
  await queueUpPaused(studio);
  await chip(studio, 3).click();
  await act(studio, 'Insert').click();
  await studio.pictures(2);
  await studio.shot('queue-insert');
  const [spot] = await studio.screen([{ x: 12, y: -3 }]);
  await page.mouse.click(spot.x, spot.y);
  await page.keyboard.press('.');
  await targetsToBe(studio, ['8,-9', '14,-9', '12,-3', '14,4', '-6,-9']);
  await studio.shot('queue-inserted');
  await chip(studio, 2).click();
  await act(studio, 'Later').click();
  await page.keyboard.press('.');
  await targetsToBe(studio, ['8,-9', '12,-3', '14,-9', '14,4', '-6,-9']);
  await dragChip(studio, 5, 2, (from, to) => studio.page.mouse.move(from.x, from.y).then(() => mouseDrag(studio, to)));
  await page.keyboard.press('.');
  await targetsToBe(studio, ['8,-9', '-6,-9', '12,-3', '14,-9', '14,4']);
  await chip(studio, 3).click();
  await act(studio, 'Cancel').click();
  await page.keyboard.press('.');
  await targetsToBe(studio, ['8,-9', '-6,-9', '14,-9', '14,4']);
  await act(studio, 'Skip').click();
  await page.keyboard.press('.');
  await targetsToBe(studio, ['-6,-9', '14,-9', '14,4']);
  for (const wanted of [
    ['8,-9', '-6,-9', '14,-9', '14,4'],
    ['8,-9', '-6,-9', '12,-3', '14,-9', '14,4'],
    ['8,-9', '12,-3', '14,-9', '14,4', '-6,-9'],
    ['8,-9', '14,-9', '12,-3', '14,4', '-6,-9'],
    ['8,-9', '14,-9', '14,4', '-6,-9'],
  ]) {
    await page.keyboard.press('Control+z');
    await page.keyboard.press('.');
    await targetsToBe(studio, wanted);
  }
}

/** By fingers: a chip is dragged, an order inserted before the first, one cancelled. */
export async function editQueueByTouch(studio) {
  const { page } = studio;
  await studio.tab('orders');
  await page.keyboard.press('.');
  await queueUpPaused(studio);
  await studio.shot('queue-chips');
  await dragChip(studio, 4, 1, async (from, to) => {
    await studio.fingers.down({ 1: from });
    await studio.fingers.move({ 1: to });
    await studio.shot('queue-dragged');
    await studio.fingers.up([1]);
  });
  await page.keyboard.press('.');
  await targetsToBe(studio, ['-6,-9', '8,-9', '14,-9', '14,4']);
  await chip(studio, 1).tap();
  await look.layout(studio);
  await look.serious(studio, 'queue');
  await page.keyboard.press('n');
  await studio.wait(300);
  await look.serious(studio, 'queue in the dark');
  await studio.shot('queue-dark');
  await page.keyboard.press('n');
  await act(studio, 'Insert').tap();
  await studio.pictures(2);
  await studio.shot('queue-insert');
  // On a phone the queue covers what the opening view shows there.
  if (studio.size === 'phone') {
    await page.evaluate(() => globalThis.__muster.view.lookAt({ x: -10, y: -3 }));
    await studio.cameraAtRest();
  }
  const [spot] = await studio.screen([{ x: -10, y: -9 }]);
  await studio.fingers.down({ 1: spot });
  await studio.fingers.up([1]);
  await page.keyboard.press('.');
  await targetsToBe(studio, ['-10,-9', '-6,-9', '8,-9', '14,-9', '14,4']);
  await chip(studio, 2).tap();
  await act(studio, 'Cancel').tap();
  await page.keyboard.press('.');
  await targetsToBe(studio, ['-10,-9', '8,-9', '14,-9', '14,4']);
  await page.locator('.order-tile[aria-label="Patrol"]').tap();
  await page.keyboard.press('.');
  await studio.until('a patrol', () => globalThis.__muster.frame.groups[0].patrols);
  await act(studio, 'Skip').tap();
  await page.keyboard.press('.');
  // In a patrol what is skipped comes last again.
  await targetsToBe(studio, ['8,-9', '14,-9', '14,4', '-10,-9']);
  if (studio.size === 'phone') return;
  await act(studio, 'Add').tap();
  await page.locator('.order-tile[data-tool="order"]').tap();
  await studio.fingers.down({ 1: spot });
  await studio.fingers.up([1]);
  await page.keyboard.press('.');
  await targetsToBe(studio, ['8,-9', '14,-9', '14,4', '-10,-9', '-10,-9']);
  await studio.shot('queue-added');
}

const kStops = [
  { x: 8, y: -9 },
  { x: 14, y: -9 },
  { x: 14, y: 4 },
  { x: -6, y: -9 },
];

/** Gives orders while the world is paused, so that none is done meanwhile. */
async function queueUpPaused(studio, stops = kStops) {
  const move = ({ x, y }, k) => ({
    kind: 'order',
    group: 1,
    mode: k === 0 ? 'replace' : 'append',
    order: { target: [x, y] },
  });
  await studio.send({ type: 'Commands', commands: stops.map(move) });
  await studio.page.keyboard.press('.');
  await targetsToBe(
    studio,
    stops.map(({ x, y }) => `${x},${y}`),
  );
}

/** Carries a chip to the front half of another one. */
async function dragChip(studio, number, before, carry) {
  const [from, to] = [await chip(studio, number).boundingBox(), await chip(studio, before).boundingBox()];
  await carry(
    { x: from.x + from.width / 2, y: from.y + from.height / 2 },
    { x: to.x + to.width / 4, y: to.y + to.height / 2 },
  );
}

async function mouseDrag(studio, to) {
  const { mouse } = studio.page;
  await mouse.down();
  await mouse.move(to.x, to.y, { steps: 8 });
  await studio.shot('queue-dragged');
  await mouse.up();
}
