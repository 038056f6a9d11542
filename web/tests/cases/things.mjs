// Building by things: what people do there follows from the thing, mistakes are said beside it, names take no keys of tools.
import { expect } from '../support/expect.mjs';
import { drag, near, open, scene, screen, tool } from './build.mjs';
import { serious } from './look.mjs';

const panel = (studio) => studio.page.locator('.build-panel');
const field = (studio, label) => panel(studio).getByLabel(label, { exact: true });
const motionOf = (now, patch) => now.clips[patch.motion].name;
const touchOf = (studio) => ({ touch: studio.size !== 'desktop' && studio.size !== 'wide' });

async function type(studio, label, value) {
  await field(studio, label).fill(value);
  await field(studio, label).press('Enter');
}

async function tap(studio, at) {
  const [p] = await screen(studio, [at]);
  if (!touchOf(studio).touch) return studio.page.mouse.click(p.x, p.y);
  await studio.fingers.down({ 1: p });
  await studio.fingers.up();
}

const isDeep = (patch, deep) => {
  const [a, b, c] = patch.polygon;
  const sides = [Math.hypot(b[0] - a[0], b[1] - a[1]), Math.hypot(c[0] - b[0], c[1] - b[1])];
  return Math.abs(Math.min(...sides) - deep) < 0.01;
};

/** Water, net, hedges and walls: people swim, crawl, jump and climb there, or go round. */
export async function whatPeopleDo(studio) {
  const how = touchOf(studio);
  await open(studio);
  await tool(studio, 'Water');
  await drag(studio, { x: -6, y: 2 }, { x: -3, y: 5 }, how);
  await tool(studio, 'Net');
  await drag(studio, { x: -2, y: 2 }, { x: 0, y: 5 }, how);
  await tool(studio, 'Hedge');
  await drag(studio, { x: 2, y: 2 }, { x: 6, y: 2 }, how);
  let now = await scene(studio, 'three of them', ({ patches }) => patches.length === 3);
  const motions = now.patches.map((one) => motionOf(now, one)).join();
  expect(motions === 'swim,crawl,jump', `what people do there: ${motions}`);
  expect(isDeep(now.patches[2], 2.1), `a hedge that a jump leads over: ${JSON.stringify(now.patches[2].polygon)}`);
  expect((await studio.page.locator('.build-note').count()) === 0, 'nothing is wrong with it');
  await tool(studio, 'Hedge');
  await type(studio, 'Height [m]', '1.8');
  await drag(studio, { x: 2, y: 5 }, { x: 6, y: 5 }, how);
  now = await scene(studio, 'a high hedge', ({ obstacles }) => obstacles.length === 1);
  expect(now.obstacles[0].height === 1.8, 'in everybody’s way');
  await tool(studio, 'Wall');
  await type(studio, 'Height [m]', '1.2');
  await drag(studio, { x: -6, y: -4 }, { x: -2, y: -4 }, how);
  now = await scene(studio, 'a low wall', ({ patches }) => patches.length === 4);
  expect(motionOf(now, now.patches[3]) === 'climb', 'that people climb over');
  await type(studio, 'Height [m]', '2.5');
  now = await scene(studio, 'a high wall', ({ obstacles }) => obstacles.length === 2);
  expect(now.patches.length === 3 && now.obstacles[1].height === 2.5, 'in place of the low one');
  await panel(studio).getByRole('combobox', { name: 'People here' }).selectOption('Jump over');
  now = await scene(studio, 'a wall to jump over', ({ patches }) => patches.length === 4);
  expect(motionOf(now, now.patches[3]) === 'jump' && isDeep(now.patches[3], 2.1), 'as deep as a jump');
  await studio.pictures(2);
  await studio.shot('things');
  const labels = await panel(studio).locator('.build-field > span').allTextContents();
  expect(new Set(labels).size === labels.length, `one word for each quantity: ${labels}`);
  await serious(studio, 'building by things');
}

/** A door splits a wall, a gate opens and shuts, and a car stays where it was put. */
export async function doorGateAndCar(studio) {
  const how = touchOf(studio);
  const { page } = studio;
  await open(studio);
  await studio.until('some time', () => globalThis.__muster.frame.time > 0.2);
  await tool(studio, 'Wall');
  await drag(studio, { x: 3, y: -5 }, { x: 3, y: 5 }, how);
  await scene(studio, 'a wall', ({ obstacles }) => obstacles.length === 1);
  await tool(studio, 'Door');
  await type(studio, 'Width [m]', '2');
  await tap(studio, { x: 3, y: 0 });
  let now = await scene(studio, 'a wall in two pieces', ({ obstacles }) => obstacles.length === 2);
  const ys = now.obstacles
    .flatMap(({ polygon }) => polygon.map(([, y]) => y))
    .sort((a, b) => Math.abs(a) - Math.abs(b));
  expect(Math.abs(Math.abs(ys[0] - ys[3]) - 2) < 0.3, `two metres apart: ${ys}`);
  await tool(studio, 'Gate');
  await drag(studio, { x: 3, y: -1 }, { x: 3, y: 1 }, how);
  await scene(studio, 'a gate', ({ obstacles }) => obstacles.length === 3);
  await panel(studio).getByRole('button', { name: 'Open now' }).click();
  await panel(studio).getByRole('button', { name: 'Shut now' }).waitFor();
  await panel(studio).getByRole('button', { name: 'Play' }).click();
  const until = (what, least, most) =>
    studio.until(
      what,
      ([from, to]) => {
        const { x, y } = globalThis.__muster.frame.moving.find(({ id }) => id === 3) ?? { x: NaN, y: NaN };
        return Math.hypot(x, y) >= from && Math.hypot(x, y) <= to;
      },
      [least, most],
    );
  await until('it slides open', 1.99, 3);
  await panel(studio).getByRole('button', { name: 'Pause' }).click();
  await panel(studio).getByRole('button', { name: 'Shut now' }).click();
  await panel(studio).getByRole('button', { name: 'Open now' }).waitFor();
  await panel(studio).getByRole('button', { name: 'Play' }).click();
  await until('it shuts', 0, 0.05);
  await panel(studio).getByRole('button', { name: 'Pause' }).click();
  await tool(studio, 'Car');
  await drag(studio, { x: -6, y: -5 }, { x: 1, y: -5 }, how);
  now = await scene(studio, 'a car', ({ obstacles }) => obstacles.length === 4 && obstacles[3].path.loop);
  await studio.until('it stands', () => globalThis.__muster.frame.moving.some(({ id }) => id === 4));
  const stands = async (what) => {
    const { x, y } = await page.evaluate(() => globalThis.__muster.frame.moving.find(({ id }) => id === 4));
    const middle = [0, 1].map((axis) => now.obstacles[3].polygon.reduce((sum, p) => sum + p[axis] / 4, 0));
    expect(near([middle[0] + x, middle[1] + y], [-6, -5], 0.6), `${what}: ${[middle[0] + x, middle[1] + y]}`);
  };
  await stands('where its way begins');
  await tool(studio, 'Route');
  await drag(studio, { x: -6, y: -5 }, { x: -6, y: 4 }, how);
  now = await scene(studio, 'another way', ({ obstacles }) =>
    obstacles[3].path.waypoints.some((p) => p.position[1] > 5),
  );
  await studio.wait(300);
  await stands('still there');
  await studio.pictures(2);
  await studio.shot('things-door-gate-car');
}

/** Enter, Escape and a press on the scene leave a name; what is typed then are keys of tools. */
export async function namesTakeNoKeys(studio) {
  const { page } = studio;
  await open(studio);
  const pressed = async () => (await panel(studio).locator('.build-tool[aria-pressed="true"]').textContent()).trim();
  await tool(studio, 'Box');
  await drag(studio, { x: 2, y: 2 }, { x: 4, y: 4 });
  await scene(studio, 'a box', ({ obstacles }) => obstacles.length === 1);
  await field(studio, 'Name').fill('Kiosk');
  await field(studio, 'Name').press('Enter');
  await page.keyboard.press('o');
  expect((await pressed()) === 'Pillar', `after Enter: ${await pressed()}`);
  await drag(studio, { x: -3, y: 3 }, { x: -2, y: 3 });
  let now = await scene(studio, 'a pillar', ({ obstacles }) => obstacles.length === 2);
  expect(now.obstacles.map(({ name }) => name).join() === 'Kiosk,', 'which has no name');
  await field(studio, 'Name').fill('not this');
  await field(studio, 'Name').press('Escape');
  await page.keyboard.press('w');
  expect((await pressed()) === 'Wall', `after Escape: ${await pressed()}`);
  await drag(studio, { x: -5, y: -3 }, { x: -1, y: -3 });
  await scene(studio, 'a wall', ({ obstacles }) => obstacles.length === 3);
  await field(studio, 'Name').fill('North wall');
  await drag(studio, { x: -5, y: -5 }, { x: -1, y: -5 });
  now = await scene(studio, 'another wall', ({ obstacles }) => obstacles.length === 4);
  const names = now.obstacles.map(({ name }) => name);
  expect(names.join() === 'Kiosk,,North wall,', `after a press on the scene: ${names}`);
  await page.keyboard.press('h');
  expect((await pressed()) === 'Hedge', `and a key: ${await pressed()}`);
}

/** What people cannot do is said beside the thing, which can be chosen and made to fit there. */
export async function mistakes(studio) {
  const how = touchOf(studio);
  await open(studio);
  await tool(studio, 'Hedge');
  await drag(studio, { x: 1, y: 2 }, { x: 5, y: 2 }, how);
  await scene(studio, 'a hedge', ({ patches }) => patches.length === 1);
  await type(studio, 'Width [m]', '1');
  const note = studio.page.locator('.build-note');
  await note.waitFor();
  const words = await note.locator('button').first().textContent();
  expect(words === 'Hedge is 1.0 m deep; people can jump over 1.8 to 2.4 m.', words);
  await studio.pictures(2);
  await studio.shot('things-mistake');
  await serious(studio, 'a mistake');
  await tool(studio, 'Select');
  await studio.page.keyboard.press('Escape');
  await studio.eventually(async () =>
    expect((await studio.page.locator('.build-chosen-fields').count()) === 0, 'nothing is chosen'),
  );
  await note.locator('button').first().click();
  await studio.page.locator('.build-chosen-fields h3', { hasText: 'Hedge' }).waitFor();
  await note.getByRole('button', { name: 'Make it fit' }).click();
  await scene(studio, 'as deep as a jump', ({ patches: [one] }) => isDeep(one, 2.1));
  await note.waitFor({ state: 'detached' });
}

/** Where groups begin: in their colours, in the shapes of their formations, with words. */
export async function starts(studio) {
  await open(studio);
  await studio.page.locator('.build-start-label').first().waitFor();
  await studio.pictures(2);
  const shown = await studio.page.evaluate(() =>
    [...document.querySelectorAll('.build-group')].map((one) => ({
      colour: getComputedStyle(one.querySelector('.build-outline')).stroke,
      corners: one.querySelector('.build-outline').getAttribute('points').split(' ').length,
      words: one.querySelector('text').textContent,
    })),
  );
  await studio.shot('things-starts');
  expect(new Set(shown.map(({ colour }) => colour)).size === shown.length, `colours: ${JSON.stringify(shown)}`);
  expect(
    shown.every(({ words }) => / begins here$/.test(words)) && shown.map(({ corners }) => corners).join() === '4,3',
    `a square and a wedge with words: ${JSON.stringify(shown)}`,
  );
}

const kOpen = { scenario: 'scenarios/open.json', room: true };
export const kThingCases = [
  ['things: what people do', whatPeopleDo, ['desktop', 'portrait', 'phone'], kOpen],
  ['things: door, gate and car', doorGateAndCar, ['desktop', 'portrait'], kOpen],
  ['things: names take no keys', namesTakeNoKeys, ['desktop'], { ...kOpen, touch: false }],
  ['things: mistakes', mistakes, ['desktop', 'portrait', 'phone'], kOpen],
  ['things: where groups begin', starts, ['desktop'], { scenario: 'web/tests/scenarios/two-groups.json' }],
];
