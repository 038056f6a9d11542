// Undo and redo outside building: orders, shapes and splits, by keys, buttons and three fingers, for each director alone.
import { expect } from '../support/expect.mjs';
import { mean, points, shifted } from '../support/geometry.mjs';
import { StudioPage } from '../support/studio_page.mjs';
import { layout, serious } from './look.mjs';

const tile = (studio, label) => studio.page.locator(`.order-tile[aria-label="${label}"]`);
const middleOf = (frame, index = 0) => mean(points(frame.groups[index].vertices));

function ordersToBe(studio, count, index = 0) {
  return studio.until(`${count} orders`, ([n, i]) => globalThis.__muster.frame.groups[i].orders.length === n, [
    count,
    index,
  ]);
}

function shapeToBe(studio, formation) {
  return studio.until(
    `the shape ${formation}`,
    (wanted) => globalThis.__muster.state.groups[0].formation === wanted,
    formation,
  );
}

function told(studio, text) {
  return studio.page.locator('.notice strong', { hasText: text }).waitFor();
}

async function disabled(studio, label) {
  return (await tile(studio, label).getAttribute('aria-disabled')) === 'true';
}

async function send(studio, ...commands) {
  await studio.send({ type: 'Commands', commands });
}

/** Three fingers that tap beside each other. */
async function tapWithThree(studio, at) {
  const down = Object.fromEntries([0, 1, 2].map((k) => [k + 1, { x: at.x + 30 * k, y: at.y }]));
  await studio.fingers.down(down);
  // All at once: a busy machine would make a tap last too long.
  studio.fingers.at.clear();
  await studio.fingers.send('touchEnd', []);
}

/** The group goes no farther. */
async function stands(studio) {
  await studio.eventually(async () => {
    const before = middleOf(await studio.frame());
    await studio.wait(400);
    const after = middleOf(await studio.frame());
    expect(Math.hypot(after.x - before.x, after.y - before.y) < 0.05, 'the group stands');
  });
}

/** The mouse orders, keys and buttons take back and do again. */
async function undoByMouse(studio) {
  const { page } = studio;
  expect((await disabled(studio, 'Undo')) && (await disabled(studio, 'Redo')), 'there is nothing to undo at first');
  await tile(studio, 'Undo').click({ force: true });
  await told(studio, 'There is nothing to undo');
  const [spot] = await studio.screen([shifted(middleOf(await studio.frame()), 9, 0)]);
  await page.mouse.click(spot.x, spot.y, { button: 'right' });
  await ordersToBe(studio, 1);
  await studio.wait(500);
  await page.keyboard.press('Control+z');
  await ordersToBe(studio, 0);
  await told(studio, 'Undone: Move');
  await studio.shot('undone');
  await stands(studio);
  await page.keyboard.press('Control+Shift+Z');
  await ordersToBe(studio, 1);
  await told(studio, 'Done again: Move');
  const before = await studio.page.evaluate(() => globalThis.__muster.state.groups[0].formation);
  await page.keyboard.press('4');
  await shapeToBe(studio, 'wedge');
  await page.keyboard.press('5');
  await shapeToBe(studio, 'ring');
  await tile(studio, 'Undo').click();
  await shapeToBe(studio, 'wedge');
  await told(studio, 'Undone: Change shape');
  await tile(studio, 'Undo').click();
  await shapeToBe(studio, before);
  await ordersToBe(studio, 1);
  await tile(studio, 'Redo').click();
  await shapeToBe(studio, 'wedge');
  await page.keyboard.press('Control+z');
  await shapeToBe(studio, before);
  await page.keyboard.press('z');
  await ordersToBe(studio, 0);
  expect(await disabled(studio, 'Undo'), 'all is undone');
  await page.keyboard.press('h');
  await page.locator('dialog.help dd', { hasText: 'takes back what you did last' }).waitFor();
  await page.keyboard.press('Escape');
  await page.locator('.notice').waitFor({ state: 'hidden' });
}

/** Three fingers that tap take back, on the ground and with a tool in hand; elsewhere they do what they did. */
async function undoByTouch(studio) {
  const start = middleOf(await studio.frame());
  const [ground] = await studio.screen([shifted(start, -2, -7)]);
  await studio.tab('orders');
  await tile(studio, 'Order').tap();
  await studio.fingers.down({ 1: ground });
  await studio.fingers.up();
  await ordersToBe(studio, 1);
  await tapWithThree(studio, ground);
  await ordersToBe(studio, 0);
  await told(studio, 'Undone: Move');
  await studio.shot('undone-touch');
  await layout(studio);
  await serious(studio, 'undo');
  await studio.wait(500);
  expect((await studio.frame()).groups[0].orders.length === 0, 'the fingers give no order');
  await tile(studio, 'Redo').tap();
  await ordersToBe(studio, 1);
  await tile(studio, 'Steer').tap();
  const [free] = await studio.screen([shifted(middleOf(await studio.frame()), -2, -7)]);
  await tapWithThree(studio, free);
  await ordersToBe(studio, 0);
  await stands(studio);
}

/** Two directors: each takes back only what they did. */
async function undoOfTwo(studio) {
  const other = await StudioPage.open(studio.context.browser(), studio.page.url(), { size: studio.size });
  try {
    const [a, b] = (await studio.frame()).groups;
    await send(studio, { kind: 'order', group: a.id, order: { target: [a.x, a.y + 9] } });
    await send(other, { kind: 'order', group: b.id, order: { target: [b.x, b.y + 9] } });
    await ordersToBe(studio, 1, 0);
    await ordersToBe(studio, 1, 1);
    await studio.until('its history', () => globalThis.__muster.state.history.undo === 1);
    await studio.page.keyboard.press('z');
    await ordersToBe(studio, 0, 0);
    await studio.page.keyboard.press('z');
    await told(studio, 'There is nothing to undo');
    expect((await studio.frame()).groups[1].orders.length === 1, 'the other order stays');
    await other.page.keyboard.press('z');
    await ordersToBe(studio, 0, 1);
  } finally {
    await other.close();
  }
}

/** What was done before building is taken back while building, and what was built after it. */
async function oneHistory(studio) {
  const { page } = studio;
  const group = (await studio.frame()).groups[0].id;
  await send(studio, { kind: 'changeGroup', group, formation: { kind: 'ring' } });
  await shapeToBe(studio, 'ring');
  await page.keyboard.press('Shift+E');
  await page.getByRole('button', { name: 'Undo change shape' }).waitFor();
  const commands = [{ kind: 'putThing', obstacle: { name: 'Post', centre: [0, 12], radius: 1, height: 2 } }];
  await studio.send({ type: 'Edit', label: 'Add disc', gesture: 0, commands, bodies: [] });
  await page.getByRole('button', { name: 'Undo add disc' }).click();
  await told(studio, 'Undone: Add disc');
  await page.keyboard.press('Shift+E');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('.');
  await shapeToBe(studio, 'square');
}

export const kUndoCases = [
  ['undo: by mouse', undoByMouse, ['desktop'], { touch: false, room: true }],
  ['undo: by touch', undoByTouch, ['landscape', 'portrait', 'phone', 'narrow'], { room: true }],
  ['undo: of two directors', undoOfTwo, ['desktop'], { touch: false, scenario: 'web/tests/scenarios/two-groups.json' }],
  ['undo: one history with building', oneHistory, ['desktop'], { touch: false, room: true }],
];
