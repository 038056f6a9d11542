// Orders by mouse and touch, and groups that are divided and joined.
import { expect, expectBetween } from '../support/expect.mjs';
import { crowd, distance, extreme, mean, points, shifted } from '../support/geometry.mjs';

const vertices = (frame, index = 0) => points(frame.groups[index].vertices);

async function takeTool(studio, tool) {
  await studio.tab('orders');
  await studio.page.locator(`.order-tile[data-tool="${tool}"]`).click();
}

async function rightDrag(studio, from, to, { keys = [], shot = '' } = {}) {
  const [a, b] = await studio.screen([from, to]);
  const { mouse, keyboard } = studio.page;
  for (const key of keys) await keyboard.down(key);
  await mouse.move(a.x, a.y);
  await mouse.down({ button: 'right' });
  await mouse.move(b.x, b.y, { steps: 12 });
  if (shot) {
    await studio.pictures(2);
    await studio.shot(shot);
  }
  await mouse.up({ button: 'right' });
  for (const key of keys) await keyboard.up(key);
}

async function groupsToBe(studio, count) {
  await studio.until(`${count} groups`, (n) => globalThis.__muster.frame.groups.length === n, count, 30000);
}

/** Numbers of characters per group, from the chips. */
async function chipCounts(studio) {
  return (await studio.page.locator('.chip .chip-count').allTextContents()).map(Number);
}

/** A stroke of one finger over the ground. */
async function stroke(studio, from, to, shot = '') {
  const [a, b] = await studio.screen([from, to]);
  await studio.fingers.down({ 1: a });
  await studio.fingers.move({ 1: b });
  if (shot) {
    await studio.pictures(2);
    await studio.shot(shot);
  }
  await studio.fingers.up([1]);
}

/** Across the middle of a mesh and a little beyond, from south to north. */
function across(frame, index = 0) {
  const list = vertices(frame, index);
  const x = mean(list).x;
  return [
    { x, y: extreme(list, 0, -1).y - 1.5 },
    { x, y: extreme(list, 0, 1).y + 1.5 },
  ];
}

/** A stroke across the mesh divides a group, one from part to part joins them, and both can be undone. */
export async function splitAndMerge(studio) {
  const before = await studio.frame();
  const where = crowd(before);
  await takeTool(studio, 'cut');
  await stroke(studio, ...across(before), 'split-before');
  await groupsToBe(studio, 2);
  const parts = await studio.frame();
  await studio.eventually(async () => {
    const counts = await chipCounts(studio);
    expect(counts.length === 2 && counts[0] + counts[1] === where.length, `counts of chips: ${counts}`);
    expectBetween(counts[0] / where.length, 0.3, 0.7, 'share of a part');
  });
  const moved = crowd(parts).map((at, i) => distance(at, where[i]));
  expect(Math.max(...moved) < 1, `nobody is put elsewhere: ${Math.max(...moved).toFixed(2)} m`);
  await studio.shot('split');
  const [a, b] = [0, 1].map((index) => mean(vertices(parts, index)));
  await stroke(studio, a, b, 'merge-before');
  await groupsToBe(studio, 1);
  await studio.shot('merged');
  await studio.tab('orders');
  await studio.page.locator('.order-tile[aria-label="Undo"]').click();
  await groupsToBe(studio, 2);
  await studio.page.keyboard.press('Control+z');
  await groupsToBe(studio, 1);
  await studio.eventually(async () => {
    const counts = await chipCounts(studio);
    expect(counts.length === 1 && counts[0] === where.length, `everybody is back: ${counts}`);
  });
  await takeTool(studio, 'steer');
}

/** Two fingers on a mesh that are pulled apart divide it between them. */
export async function pullApart(studio) {
  const before = await studio.frame();
  const middle = mean(vertices(before));
  await takeTool(studio, 'cut');
  const [a, b, farA, farB] = await studio.screen([
    shifted(middle, -1, 0),
    shifted(middle, 1, 0),
    shifted(middle, -3.2, 0),
    shifted(middle, 3.2, 0),
  ]);
  await studio.fingers.down({ 1: a, 2: b });
  await studio.fingers.move({ 1: farA, 2: farB });
  await studio.pictures(2);
  await studio.shot('pull-apart');
  await studio.fingers.up([1, 2]);
  await groupsToBe(studio, 2);
  const { groups } = await studio.frame();
  const [first, second] = groups.map((group) => mean(points(group.vertices)));
  expect(Math.abs(first.x - second.x) > 2, 'the parts lie side by side');
  await takeTool(studio, 'steer');
}

/** A chip dragged onto another joins the groups. */
export async function chipOntoChip(studio) {
  const before = await studio.frame();
  expect(before.groups.length === 2, 'two groups to begin with');
  const chips = studio.page.locator('.chip');
  const [from, to] = [await chips.nth(1).boundingBox(), await chips.nth(0).boundingBox()];
  const { mouse } = studio.page;
  await mouse.move(from.x + from.width / 2, from.y + from.height / 2);
  await mouse.down();
  await mouse.move(to.x + to.width / 2, to.y + to.height / 2, { steps: 8 });
  await studio.shot('chip-drag');
  await mouse.up();
  await groupsToBe(studio, 1);
  const after = await studio.frame();
  expect(after.groups[0].id === before.groups[0].id, 'the group that it was dragged onto stays');
  expect(after.x.length === before.x.length, 'with everybody');
  await studio.page.keyboard.press('z');
  await groupsToBe(studio, 2);
}

/** The right button: a click moves, a drag is a front with its places shown before, Shift queues. */
export async function ordersByMouse(studio) {
  const start = mean(vertices(await studio.frame()));
  const left = shifted(start, -6, 9);
  const right = shifted(start, 6, 9);
  await rightDrag(studio, left, right, { shot: 'order-preview' });
  await studio.until('the order', () => globalThis.__muster.frame.groups[0].orders.length === 1);
  const [order] = (await studio.frame()).groups[0].orders;
  expect(Math.abs(order.facing - Math.PI / 2) < 0.05, `it faces north: ${order.facing}`);
  expectBetween(order.width, 11.5, 12.5, 'width of the front [m]');
  const stops = [shifted(start, 10, 4), shifted(start, 10, -6), shifted(start, 0, -8), shifted(start, -9, -3)];
  for (const stop of stops) await rightDrag(studio, stop, stop, { keys: ['Shift'] });
  await studio.until('a queue of five', () => globalThis.__muster.frame.groups[0].orders.length === 5);
  await studio.pictures(2);
  await studio.shot('order-queue');
  await studio.page.keyboard.press('k');
  await studio.until('it to wait', () => globalThis.__muster.frame.groups[0].held);
  await studio.shot('order-held');
  await studio.page.keyboard.press('k');
  await studio.until('it to go on', () => !globalThis.__muster.frame.groups[0].held);
  await studio.page.keyboard.press('b');
  await studio.until('a patrol', () => globalThis.__muster.frame.groups[0].patrols);
  await studio.page.keyboard.press('s');
  await studio.until('the end of the queue', () => globalThis.__muster.frame.groups[0].orders.length === 0);
}

/** With the order tool a finger's press moves, its drag is a front, and one from the formation a way. */
export async function ordersByTouch(studio) {
  const start = mean(vertices(await studio.frame()));
  await takeTool(studio, 'order');
  await stroke(studio, shifted(start, -5, 9), shifted(start, 5, 9), 'touch-order');
  await studio.until('a front', () => globalThis.__muster.frame.groups[0].orders[0]?.width > 8);
  const [a, b, c] = await studio.screen([start, shifted(start, 7, 1), shifted(start, 7, -9)]);
  await studio.fingers.down({ 1: a });
  await studio.fingers.move({ 1: b });
  await studio.fingers.move({ 1: c });
  await studio.pictures(2);
  await studio.shot('touch-route');
  await studio.fingers.up([1]);
  await studio.until('a drawn way', () => globalThis.__muster.frame.groups[0].orders[0]?.route.length > 4);
  await takeTool(studio, 'steer');
}

/** Settings of orders and conduct reach the world and come back. */
export async function conduct(studio) {
  const { page } = studio;
  await studio.tab('orders');
  await page.locator('.order-tile[aria-label="Conduct"]').click();
  await page.locator('.order-details').waitFor();
  await studio.shot('conduct');
  await page.locator('.segments button', { hasText: 'Hold' }).click();
  await studio.until('the stance', () => globalThis.__muster.frame.groups[0].stance === 1);
  await page.locator('input[aria-label="Narrow"]').fill('40');
  await studio.until('the squeeze', () => Math.abs(globalThis.__muster.frame.groups[0].squeeze - 0.4) < 0.001);
  await page.keyboard.press('Escape');
}
