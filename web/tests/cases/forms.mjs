// Formations on the real ground before the crowd moves, outlines drawn with a held key or button, and sequences of
// formations along a way. The granary, 5 m by 9 m about the origin, stands between the crowd and the east.
import { expect } from '../support/expect.mjs';
import { serious } from './look.mjs';

const formation = (studio, label) => studio.page.locator('.formation', { hasText: label });
const middle = async (locator) => {
  const box = await locator.boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};

/** In the page: what is drawn of places that are not taken up. */
const shown = (studio) =>
  studio.page.evaluate(() => {
    const { view, state } = globalThis.__muster;
    const { drawn } = view.orders.scene(true);
    const move = drawn?.moves[0];
    return {
      places: move?.places ?? [],
      bad: move?.unfit ? [...move.unfit].filter((one) => one > 0).length : -1,
      badPlaces: (move?.places ?? []).filter((_, i) => move.unfit?.[i] > 0),
      note: drawn?.note?.text ?? '',
      stand: state.stand?.text ?? '',
      formation: state.groups[0].formation,
    };
  });

async function shownToBe(studio, what, test) {
  await studio.eventually(async () => {
    const found = await shown(studio);
    expect(test(found), `${what}: ${JSON.stringify({ ...found, places: found.places.length })}`);
  });
  return shown(studio);
}

/** What is in the granary, or so near to it that nobody fits. */
const inGranary = ({ x, y }) => Math.abs(x) < 2.75 && Math.abs(y) < 4.75;

async function pausedOrder(studio, x, y) {
  await studio.page.keyboard.press('.');
  await studio.send({
    type: 'Commands',
    commands: [{ kind: 'order', group: 1, order: { target: [x, y], facing: 0 } }],
  });
  await studio.page.keyboard.press('.');
  await studio.until('the order', () => globalThis.__muster.frame.groups[0].orders.length === 1);
}

/** A mouse that rests on a formation sees where it would stand: at the goal of the group's order, with crosses in the granary. */
export async function lookByMouse(studio) {
  const { page } = studio;
  await pausedOrder(studio, 5, 0);
  const column = await middle(formation(studio, 'Column'));
  await page.mouse.move(column.x, column.y);
  const seen = await shownToBe(studio, 'a column with places in the granary', ({ bad }) => bad > 5);
  expect(seen.places.length === 36, 'everybody has a place');
  expect(/^\d+ of 36 spots (cannot be reached|lie in obstacles)$/.test(seen.note), `it says so: ${seen.note}`);
  expect(seen.note.startsWith(`${seen.bad} of`), 'words and crosses agree');
  const outside = seen.badPlaces.filter((place) => !inGranary(place));
  expect(outside.length === 0, `only places in the granary are crossed: ${JSON.stringify(outside)}`);
  const middleX = seen.places.reduce((sum, { x }) => sum + x, 0) / 36;
  expect(Math.abs(middleX - 5) < 0.3, `it stands at the goal: ${middleX}`);
  await studio.pictures(2);
  await studio.shot('forms-look');
  await page.mouse.move(column.x + 300, column.y);
  const left = await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
  expect(left.formation === 'square', 'nobody has moved');
  await page.mouse.click(column.x, column.y);
  await page.keyboard.press('.');
  await studio.until('the column', () => globalThis.__muster.state.groups[0].formation === 'column');
  // By keys: the focus shows it, Enter takes it up.
  await formation(studio, 'Square').focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowRight');
  await shownToBe(studio, 'another formation by keys', ({ places }) => places.length === 36);
}

/** A finger that holds a formation sees the same; it takes it up where it lifts on it, and nothing where it slides away. */
export async function lookByTouch(studio) {
  const { page } = studio;
  const column = formation(studio, 'Column');
  await column.scrollIntoViewIfNeeded();
  await pausedOrder(studio, 5, 0);
  const at = await middle(column);
  await studio.fingers.down({ 1: at });
  await shownToBe(studio, 'a column with places in the granary', ({ bad }) => bad > 5);
  await studio.pictures(2);
  await studio.shot('forms-look');
  await studio.fingers.up();
  await page.keyboard.press('.');
  await studio.until('the column', () => globalThis.__muster.state.groups[0].formation === 'column');
  await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
  const line = formation(studio, 'Wedge');
  const from = await middle(line);
  await studio.fingers.down({ 1: from });
  await shownToBe(studio, 'a wedge', ({ places }) => places.length === 36);
  await studio.fingers.move({ 1: { x: from.x, y: from.y - 200 } }, { steps: 4, ms: 80 });
  await studio.fingers.up();
  await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
  await page.keyboard.press('.');
  await studio.wait(200);
  expect((await shown(studio)).formation === 'column', 'a finger that slid away has taken nothing');
}

/** While a front is drawn through the granary, its places there are crossed. */
export async function frontOverGranary(studio) {
  const { mouse } = studio.page;
  const [left, right] = await studio.screen([
    { x: 2, y: 6 },
    { x: 2, y: -6 },
  ]);
  await mouse.move(left.x, left.y);
  await mouse.down({ button: 'right' });
  await mouse.move(right.x, right.y, { steps: 10 });
  const seen = await shownToBe(
    studio,
    'a front with crosses in the granary alone',
    ({ bad, badPlaces }) => bad > 3 && badPlaces.every(inGranary),
  );
  expect(/\d+ of 36 spots (cannot be reached|lie in obstacles)/.test(seen.note), `it says so: ${seen.note}`);
  await studio.pictures(2);
  await studio.shot('forms-front');
  await mouse.up({ button: 'right' });
  await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
}

/** More: the changed formation lies on the ground, goes back to its dialog, and is taken up from there. */
export async function tryOnTheGround(studio) {
  const { page } = studio;
  const dialog = page.locator('dialog.shape-dialog[open]');
  const bar = page.locator('.try-bar:not(.placing-bar)');
  const more = formation(studio, 'More');
  await more.scrollIntoViewIfNeeded();
  await more.click();
  await dialog.waitFor();
  for (let i = 0; i < 10; ++i) await dialog.locator('button', { hasText: 'Looser' }).click();
  await studio.eventually(async () =>
    expect(
      /\d+ of 36 spots (cannot be reached|lie in obstacles)/.test(await dialog.locator('.shape-ground').textContent()),
      'the dialog says how many cannot be reached',
    ),
  );
  await studio.shot('forms-dialog');
  await serious(studio, 'dialog with words of the ground');
  await dialog.locator('button', { hasText: 'Try on the ground' }).click();
  await bar.waitFor();
  const seen = await shownToBe(studio, 'the formation on the ground', ({ bad }) => bad > 0);
  expect((await bar.locator('.try-words').textContent()) === seen.stand, 'the bar says the same');
  expect(seen.formation === 'square', 'nobody has moved');
  await studio.pictures(2);
  await studio.shot('forms-try');
  await serious(studio, 'a formation on the ground');
  await bar.locator('button', { hasText: 'Change…' }).click();
  await dialog.waitFor();
  for (let i = 0; i < 8; ++i) await dialog.locator('button', { hasText: 'Closer' }).click();
  await dialog.locator('button', { hasText: 'Try on the ground' }).click();
  await shownToBe(studio, 'fewer crosses than before', ({ bad, stand }) => bad < seen.bad && stand !== '');
  await bar.locator('button', { hasText: 'Use it' }).click();
  await studio.until('the formation', () => globalThis.__muster.state.groups[0].formation === 'points');
  await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
  expect(await bar.isHidden(), 'the bar is gone');
  await more.click();
  await dialog.locator('button', { hasText: 'Try on the ground' }).click();
  await bar.waitFor();
  await page.keyboard.press('Escape');
  await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
}

/** Corners of a triangle round the group, on the screen. */
const triangle = (studio) =>
  studio.page.evaluate(() => {
    const { view, frame } = globalThis.__muster;
    const { x, y } = frame.groups[0];
    return [0, 1, 2, 3].map((k) => {
      const a = (2 * Math.PI * k) / 3 + 0.7;
      return view.worldToScreen({ x: x + 5.5 * Math.cos(a), y: y + 5.5 * Math.sin(a) });
    });
  });

/** 9 held and a stroke of the mouse: the places are shown while it is drawn, and the tool is away when the key comes up. */
export async function drawByKey(studio) {
  const { page } = studio;
  const corners = await triangle(studio);
  await page.mouse.move(corners[0].x, corners[0].y);
  await page.keyboard.down('9');
  await studio.until('the tool', () => globalThis.__muster.state.tool === 'draw');
  await page.mouse.down();
  for (const corner of corners.slice(1)) await page.mouse.move(corner.x, corner.y, { steps: 12 });
  await shownToBe(
    studio,
    'the places of the outline',
    ({ places, formation }) => places.length === 36 && formation === 'square',
  );
  await studio.pictures(2);
  await studio.shot('forms-drawing');
  await page.mouse.up();
  await studio.until('the outline', () => globalThis.__muster.state.groups[0].formation === 'outline');
  expect(await page.evaluate(() => globalThis.__muster.state.tool === 'draw'), 'the tool is in hand while the key is');
  await page.keyboard.up('9');
  expect(await page.evaluate(() => globalThis.__muster.state.tool === 'steer'), 'and away when it comes up');
  await shownToBe(studio, 'nothing', ({ places }) => places.length === 0);
  // Pressed shortly it stays in hand, pressed again it is put away.
  await page.keyboard.press('9');
  expect(await page.evaluate(() => globalThis.__muster.state.tool === 'draw'), 'a press takes the tool');
  await page.keyboard.press('9');
  expect(await page.evaluate(() => globalThis.__muster.state.tool === 'steer'), 'another puts it away');
}

/** A finger holds Draw, a second one draws. */
export async function drawByHeldButton(studio) {
  const { page } = studio;
  const draw = formation(studio, 'Draw');
  await draw.scrollIntoViewIfNeeded();
  const at = await middle(draw);
  const corners = await triangle(studio);
  await studio.fingers.down({ 1: at });
  await studio.until('the tool', () => globalThis.__muster.state.tool === 'draw');
  await studio.fingers.down({ 2: corners[0] });
  for (const corner of corners.slice(1)) await studio.fingers.move({ 2: corner }, { steps: 10, ms: 250 });
  await shownToBe(studio, 'the places of the outline', ({ places }) => places.length === 36);
  await studio.pictures(2);
  await studio.shot('forms-drawing');
  await studio.fingers.up([2]);
  await studio.until('the outline', () => globalThis.__muster.state.groups[0].formation === 'outline');
  expect(await page.evaluate(() => globalThis.__muster.state.tool === 'draw'), 'the tool is in hand while it is held');
  await studio.fingers.up([1]);
  await studio.until('the tool to be away', () => globalThis.__muster.state.tool === 'steer');
  // A tap takes the tool as ever, another puts it away.
  for (const tool of ['draw', 'steer']) {
    await studio.fingers.down({ 1: at });
    await studio.wait(40);
    await studio.fingers.up([1]);
    await studio.until(`the tool ${tool}`, (name) => globalThis.__muster.state.tool === name, tool);
    await studio.wait(700);
  }
}

const rows = (studio) => studio.page.locator('.sequence-list li');

/** Orders of the first group: where to, and what each takes up. */
const queueOf = (studio) =>
  studio.page.evaluate(() =>
    globalThis.__muster.frame.groups[0].orders.map(({ target: [x, y], formation }) => {
      return `${Math.round(x)},${Math.round(y)} ${formation?.kind ?? '-'}`;
    }),
  );

async function queueToBe(studio, what, wanted) {
  await studio.eventually(async () => {
    const found = (await queueOf(studio)).join(' | ');
    expect(wanted.test(found), `${what}: ${found}`);
  });
}

/** A list of formations along the way: added, chosen, moved, reordered, removed, taken back, and taken up. */
async function sequence(studio, press) {
  const { page } = studio;
  const panel = page.locator('.sequence');
  await pausedOrder(studio, -11, 9);
  await studio.tab('orders');
  await press(page.locator('.queue-act[aria-label="On the way"]'));
  await panel.waitFor();
  await press(panel.locator('button', { hasText: 'Add' }));
  await queueToBe(studio, 'a joint half way', /^-11,[45] - \| -11,9 line$/);
  await press(panel.locator('button', { hasText: 'Add' }));
  await queueToBe(studio, 'another one', /^-11,[45] - \| -11,[67] line \| -11,9 column$/);
  await rows(studio).nth(1).locator('select').selectOption('wedge');
  await queueToBe(studio, 'a wedge', /line \| -11,9 wedge$/);
  await rows(studio).nth(0).locator('input').fill('2');
  await page.keyboard.press('Enter');
  await page.evaluate(() => document.activeElement.blur());
  await queueToBe(studio, 'the first after 2 m', /^-11,2 - \| -11,[67] line \| -11,9 wedge$/);
  await press(rows(studio).nth(1).locator('button[aria-label$="earlier"]'));
  await queueToBe(studio, 'the other order', /^-11,2 - \| -11,[67] wedge \| -11,9 line$/);
  await studio.pictures(3);
  await studio.shot('forms-sequence');
  await serious(studio, 'formations along the way');
  const width = await panel.evaluate((node) => node.scrollWidth - node.clientWidth);
  expect(width <= 0, `the panel is ${width} px too wide inside`);
  const small = await panel.evaluate(
    (node) =>
      [...node.querySelectorAll('button, select, input')]
        .map((one) => one.getBoundingClientRect())
        .filter(({ width, height }) => width < 43.5 || height < 43.5).length,
  );
  expect(small === 0, `${small} controls are smaller than a finger`);
  await press(rows(studio).nth(1).locator('button[aria-label^="Remove"]'));
  await queueToBe(studio, 'one left', /^-11,2 - \| -11,9 wedge$/);
  // At the end of the way: far beyond it counts as the end.
  await press(panel.locator('button', { hasText: 'Add' }));
  await rows(studio).nth(1).locator('input').fill('99');
  await page.keyboard.press('Enter');
  await page.evaluate(() => document.activeElement.blur());
  await queueToBe(studio, 'one where it arrives', /^-11,2 - \| -11,9 wedge \| -11,9 ring$/);
  await press(panel.locator('button[aria-label^="Close"]'));
  expect(await panel.isHidden(), 'the panel is closed');
  await studio.pictures(3);
  await studio.shot('forms-sequence-on-the-way');
  return panel;
}

export async function sequenceByMouse(studio) {
  await sequence(studio, (locator) => locator.click());
  const { page } = studio;
  await page.keyboard.press('Control+z');
  await queueToBe(studio, 'what was before the last edit', /^-11,2 - \| .* \| -11,9 [a-z]+( \| -11,9 [a-z]+)?$/);
  await page.keyboard.press('Space');
  // They take up one after another while they walk.
  await studio.until('the wedge', () => globalThis.__muster.state.groups[0].formation === 'wedge', undefined, 30000);
}

export async function sequenceByTouch(studio) {
  await sequence(studio, (locator) => locator.tap());
  await studio.page.keyboard.press('Space');
  await studio.until('the wedge', () => globalThis.__muster.state.groups[0].formation === 'wedge', undefined, 30000);
  await studio.until('the ring', () => globalThis.__muster.state.groups[0].formation === 'ring', undefined, 40000);
}
