// By keys alone: a cursor on the ground gives orders and cuts.
import { darkWalls } from './dark_walls.mjs';
import { Hand } from '../support/hand.mjs';
import { expect } from '../support/expect.mjs';
import { distance, extreme, mean, points, shifted } from '../support/geometry.mjs';

const vertices = (frame, index = 0) => points(frame.groups[index].vertices);
const cursorOf = (studio) => studio.page.evaluate(() => globalThis.__muster.view.orders.cursor);
const ordersOf = async (studio, index = 0) => (await studio.frame()).groups[index].orders;

/** Presses arrows until the cursor is as near to a spot as its steps allow. */
export async function go(studio, to) {
  const { keyboard } = studio.page;
  const from = await cursorOf(studio);
  const turn = await studio.page.evaluate(() => globalThis.__muster.view.camera.pose.turn);
  const [c, s, dx, dy] = [Math.cos(turn), Math.sin(turn), to.x - from.x, to.y - from.y];
  for (const [way, less, more] of [
    [c * dx + s * dy, 'ArrowLeft', 'ArrowRight'],
    [c * dy - s * dx, 'ArrowDown', 'ArrowUp'],
  ]) {
    const key = way < 0 ? less : more;
    const halves = Math.round(Math.abs(way) / 0.5);
    for (let i = 0; i < Math.floor(halves / 4); ++i) await keyboard.press(`Shift+${key}`);
    for (let i = 0; i < halves % 4; ++i) await keyboard.press(key);
  }
  const at = await cursorOf(studio);
  expect(distance(at, to) < 0.6, `the cursor comes to ${JSON.stringify(to)}: ${JSON.stringify(at)}`);
  return at;
}

const said = (studio, words) =>
  studio.until(
    `"${words}" to be said`,
    (pattern) => new RegExp(pattern).test(document.querySelector('#ui [role="status"].unseen').textContent),
    words,
  );

async function take(studio, key) {
  await studio.page.keyboard.press(key);
  await studio.until('the cursor', () => globalThis.__muster.view.orders.cursor !== null);
}

/** From one Enter to the next: a front, whose forecast is shown and spoken. */
async function front(studio) {
  const { keyboard } = studio.page;
  const { groups } = await studio.frame();
  const left = await go(studio, shifted(groups[0], -3, -8));
  await said(studio, 'Open ground, \\d+ m right of Blue');
  await keyboard.press('Enter');
  const right = await go(studio, shifted(left, 9, 0));
  await said(studio, 'm right of Blue: in 0:\\d\\d');
  await studio.shot('keys-order');
  await keyboard.press('Enter');
  await studio.until('the order', () => globalThis.__muster.frame.groups[0].orders.length === 1);
  const [order] = await ordersOf(studio);
  const [x, y] = order.target;
  const middle = { x: (left.x + right.x) / 2, y: left.y };
  expect(Math.abs(x - middle.x) < 0.6, `between both ends: ${x} of ${middle.x}`);
  expect(Math.abs(y - middle.y) < 4, `behind the front: ${y} of ${middle.y}`);
  expect(Math.abs(order.width - 9) < 0.6, `as wide as it was drawn: ${order.width}`);
  expect((await studio.frame()).groups[0].controls.length === 0, 'nobody is grabbed');
}

/** Enter twice at one spot: there; Escape: nowhere. */
async function spot(studio) {
  const { keyboard } = studio.page;
  const to = await go(studio, { x: 0, y: 8 });
  await keyboard.press('Enter');
  await keyboard.press('Shift+ArrowLeft');
  await keyboard.press('Escape');
  await said(studio, 'Given up');
  expect((await studio.page.evaluate(() => globalThis.__muster.state.tool)) === 'order', 'the tool stays in hand');
  await go(studio, to);
  await keyboard.press('Enter');
  await keyboard.press('Enter');
  await studio.until('the way there', () => globalThis.__muster.frame.groups[0].orders[0]?.target[1] > 6);
  expect((await ordersOf(studio)).length === 1, 'one order: what was given up is none');
  await keyboard.press('Escape');
  expect((await cursorOf(studio)) === null, 'Escape puts cursor and tool away');
}

async function follow(studio) {
  const { keyboard } = studio.page;
  await take(studio, 'j');
  await go(studio, mean(vertices(await studio.frame(), 1)));
  await said(studio, 'On Ember');
  await keyboard.press('Enter');
  await studio.until('who follows', () => globalThis.__muster.frame.groups[0].orders[0]?.kind === 'follow');
  expect((await cursorOf(studio)) === null, 'a tool for one order is put away');
}

async function guard(studio) {
  const { keyboard } = studio.page;
  await take(studio, 'u');
  await go(studio, { x: -4, y: -8 });
  await keyboard.press('Enter');
  await go(studio, { x: 4, y: -3 });
  await keyboard.press('Enter');
  await studio.until('who guards', () => globalThis.__muster.frame.groups[0].orders[0]?.kind === 'guard');
}

async function cut(studio) {
  const { keyboard } = studio.page;
  await keyboard.press('g');
  await studio.until('the other group', () => globalThis.__muster.state.active === 1);
  await take(studio, 'x');
  const mesh = vertices(await studio.frame(), 1);
  const { x } = mean(mesh);
  await go(studio, { x, y: extreme(mesh, 0, -1).y - 1 });
  await keyboard.press('Enter');
  await go(studio, { x, y: extreme(mesh, 0, 1).y + 1 });
  await studio.shot('keys-cut');
  await keyboard.press('Enter');
  await studio.until('three groups', () => globalThis.__muster.frame.groups.length === 3);
}

/** The camera follows a cursor that leaves the picture. */
async function farAway(studio) {
  const { keyboard } = studio.page;
  await take(studio, 'o');
  for (let i = 0; i < 30; ++i) await keyboard.press('Shift+ArrowRight');
  const [at] = await studio.screen([await cursorOf(studio)]);
  const { width } = studio.page.viewportSize();
  expect(at.x > 0 && at.x < width - 100, `the cursor stays in the picture: ${at.x} of ${width}`);
  await said(studio, 'Beyond the edge');
  await keyboard.press('Escape');
}

export async function ordersAndCuts(studio) {
  await studio.page.evaluate(() => document.querySelector('#scene').focus());
  await take(studio, 'o');
  await front(studio);
  await spot(studio);
  await follow(studio);
  await guard(studio);
  await cut(studio);
  await farAway(studio);
}

/** Where a row ends inside of a tile one sees that there is more; counts are whole; Undo is at hand. */
async function rowsOfAPhone(studio) {
  const { page } = studio;
  const hand = new Hand(studio, true);
  const cut = (row, tile) =>
    page.evaluate(
      ([which, what]) => {
        const end = document.querySelector(which).getBoundingClientRect().right;
        const boxes = [...document.querySelectorAll(what)].map((node) => node.getBoundingClientRect());
        return boxes.some(({ left, right }) => left + 12 < end && right - 12 > end);
      },
      [row, tile],
    );
  expect(await cut('.formation-list', '.formation'), 'half a formation looks out');
  expect(await page.locator('.phone-undo').isHidden(), 'nothing is to be undone yet');
  await hand.press(page.locator('.formation', { hasText: 'Line' }));
  await page.locator('.phone-undo').waitFor();
  const counts = await page.evaluate(() => {
    const end = document.querySelector('.groups').getBoundingClientRect().right;
    return [...document.querySelectorAll('.chip-count')].map((node) => end - node.getBoundingClientRect().right);
  });
  expect(counts.length === 2 && counts.every((room) => room > 4), `counts of all groups are whole: ${counts}`);
  await studio.shot('phone-rows');
  await hand.press('.phone-undo');
  await page.locator('.formation[aria-pressed="true"]', { hasText: 'Square' }).waitFor();
  await page.getByRole('tab', { name: 'Orders' }).click();
  expect(await cut('.order-bar', '.order-buttons .order-tile'), 'half an order looks out');
  await studio.shot('phone-rows-orders');
}

/** On a phone the active group's chip and its formation are scrolled into sight. */
export async function activeInSight(studio) {
  const inSight = (what) =>
    studio.eventually(async () => {
      const [box, room] = await studio.page.evaluate((selector) => {
        const one = document.querySelector(selector);
        let room = one.parentElement;
        while (room && room.scrollWidth <= room.clientWidth && room.scrollHeight <= room.clientHeight)
          room = room.parentElement;
        return [one, room ?? one.closest('.panel')].map((node) => node.getBoundingClientRect().toJSON());
      }, what);
      const inside = box.left >= room.left - 1 && box.right <= room.right + 1 && box.right <= innerWidthOf(studio);
      expect(inside, `${what} from ${box.left} to ${box.right} lies in ${room.left} to ${room.right}`);
    }, 4000);
  await studio.page.evaluate(() => document.querySelector('#scene').focus());
  await studio.page.keyboard.press('g');
  await inSight('.chip[aria-pressed="true"]');
  await studio.tab('formation');
  for (const key of ['8', '3', '1']) {
    await studio.page.evaluate(() => document.querySelector('#scene').focus());
    await studio.page.keyboard.press(key);
    await studio.until(
      'the formation',
      (number) => document.querySelector(`.formation[data-key="${number}"]`).getAttribute('aria-pressed') === 'true',
      key,
    );
    await inSight('.formation[aria-pressed="true"]');
  }
  await studio.shot('phone-in-sight');
}

const innerWidthOf = (studio) => studio.page.viewportSize().width;

const kTwo = { touch: false, scenario: 'web/tests/scenarios/two-groups.json', room: true };

export const kKeyCases = [
  ['keys: orders and cuts', ordersAndCuts, ['desktop'], kTwo],
  ['phone: rows', rowsOfAPhone, ['phone'], { scenario: 'scenarios/fountain.json' }],
  ['phone: the active ones in sight', activeInSight, ['phone'], { scenario: 'scenarios/market.json' }],
  ['dark walls', darkWalls, ['desktop'], { scenario: 'scenarios/block.json', colorScheme: 'dark' }],
];
