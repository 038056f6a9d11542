// Building by keys alone: tools by letters, a cursor on the ground, and what is chosen by arrows and fields.
import { expect } from '../support/expect.mjs';
import { near, scene } from './build.mjs';
import { go } from './keys.mjs';

const at = (one) => one.polygon.map(([x, y]) => ({ x, y }));
const span = (points, axis) => Math.max(...points.map((p) => p[axis])) - Math.min(...points.map((p) => p[axis]));
const toolOf = (studio) => studio.page.locator('.build-tool[aria-pressed="true"]').textContent();

async function open(studio) {
  const { page } = studio;
  await page.evaluate(() => {
    globalThis.__scenes = [];
    globalThis.__muster.client.on('scene', (one) => globalThis.__scenes.push(one));
    document.querySelector('#scene').focus();
  });
  await page.keyboard.press('Shift+E');
  await page.locator('.build-panel').waitFor();
  await studio.until('paused', () => !globalThis.__muster.state.playing);
}

async function take(studio, key, name) {
  await studio.page.keyboard.press(key);
  await studio.until('the cursor', () => globalThis.__muster.view.orders.cursor !== null);
  expect((await toolOf(studio)).includes(name), `${key} takes ${name}`);
}

/** From one Enter to the next. */
async function draw(studio, from, to) {
  await go(studio, from);
  await studio.page.keyboard.press('Enter');
  await go(studio, to);
  await studio.page.keyboard.press('Enter');
}

/** Tab by Tab to the field of that name. */
async function tabTo(studio, label) {
  for (let i = 0; i < 60; ++i) {
    const found = await studio.page.evaluate(() => document.activeElement.closest('label')?.textContent ?? '');
    if (found.startsWith(label)) return;
    await studio.page.keyboard.press('Tab');
  }
  throw new Error(`Tab does not come to ${label}`);
}

async function drawn(studio) {
  const { keyboard } = studio.page;
  await take(studio, 'w', 'Wall');
  await draw(studio, { x: -3, y: 4 }, { x: 2, y: 4 });
  let now = await scene(studio, 'a wall', (one) => one.obstacles.length === 1);
  expect(Math.abs(span(at(now.obstacles[0]), 'x') - 5) < 0.6, 'as long as it was drawn');
  await go(studio, { x: 2, y: 2 });
  await keyboard.press('Enter');
  await go(studio, { x: 5, y: 2 });
  await studio.shot('build-keys');
  await keyboard.press('Escape');
  expect((await toolOf(studio)).includes('Wall'), 'who gives up keeps the tool');
  await take(studio, 'i', 'Item');
  await go(studio, { x: 4, y: -2 });
  await keyboard.press('Enter');
  await take(studio, 'p', 'Polygon');
  for (const corner of [
    { x: -5, y: -4 },
    { x: -2, y: -4 },
    { x: -3, y: -2 },
  ]) {
    await go(studio, corner);
    await keyboard.press('Enter');
  }
  await keyboard.press('Enter');
  now = await scene(studio, 'three things', (one) => one.obstacles.length === 2 && one.items.length === 1);
  expect(near(now.items[0].centre ?? now.items[0].position, [4, -2]), `the item: ${JSON.stringify(now.items[0])}`);
  expect(now.obstacles[1].polygon.length === 3, 'a triangle');
}

/** The wall is chosen, moved, turned, resized, named, removed and brought back. */
async function changed(studio) {
  const { keyboard } = studio.page;
  const wall = (name, test) => scene(studio, name, ({ obstacles }) => obstacles.some((one) => test(at(one), one)));
  await keyboard.press('v');
  // What was drawn last is chosen.
  await studio.page.locator('.build-chosen-fields').waitFor();
  await keyboard.press('Escape');
  await go(studio, { x: -1, y: 4 });
  await keyboard.press('Enter');
  await keyboard.press('Shift+ArrowDown');
  await wall('moved down', (all) => all.length === 4 && Math.max(...all.map((p) => p.y)) < 3.5);
  for (let i = 0; i < 6; ++i) await keyboard.press(',');
  await wall('upright', (all) => all.length === 4 && span(all, 'y') > 4 && span(all, 'x') < 1);
  await keyboard.press('Enter');
  await tabTo(studio, 'Name');
  await keyboard.press('Control+a');
  await keyboard.type('wow');
  await keyboard.press('Tab');
  await wall('its name', (all, one) => one.name === 'wow');
  expect((await toolOf(studio)).includes('Select'), 'letters of a name are no tools');
  await tabTo(studio, 'Length');
  await keyboard.press('Control+a');
  await keyboard.type('3');
  await keyboard.press('Enter');
  await wall('shorter', (all, one) => one.name === 'wow' && span(all, 'y') < 3.5);
  await studio.shot('build-keys-fields');
  await keyboard.press('Escape');
  await studio.page.locator('.build-chosen-fields').waitFor({ state: 'detached' });
  await go(studio, { x: -0.5, y: 3 });
  await keyboard.press('Enter');
  await studio.page.locator('.build-chosen-fields').waitFor();
  await keyboard.press('Delete');
  await scene(studio, 'the wall is gone', ({ obstacles }) => obstacles.length === 1);
  await keyboard.press('Control+z');
  await scene(studio, 'the wall is back', ({ obstacles }) => obstacles.length === 2);
  await keyboard.press('Escape');
  await keyboard.press('Escape');
  await studio.page.locator('.build-panel').waitFor({ state: 'hidden' });
  const cursor = await studio.page.evaluate(() => globalThis.__muster.view.orders.cursor);
  expect(cursor === null, 'the cursor goes with the panel');
}

export async function byKeys(studio) {
  await open(studio);
  await drawn(studio);
  await changed(studio);
}
