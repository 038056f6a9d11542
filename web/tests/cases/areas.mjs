// Exits, sources, waiting areas and stairs: drawn, changed, undone; groups that leave, wait and come.
import { expect } from '../support/expect.mjs';
import { crowd, distance } from '../support/geometry.mjs';
import { drag, open, scene, screen, tool } from './build.mjs';
import { serious } from './look.mjs';

const panel = (studio) => studio.page.locator('.build-panel');
const kExit = [
  { x: 4, y: -3 },
  { x: 6, y: -1 },
];

async function type(studio, label, value) {
  await panel(studio).getByLabel(label).fill(value);
  await panel(studio).getByLabel(label).press('Enter');
}

async function tap(studio, at) {
  const [p] = await screen(studio, [at]);
  await studio.fingers.down({ 1: p });
  await studio.fingers.up();
}

const saved = (studio) => studio.page.evaluate(async () => await (await globalThis.__muster.ask('scenario')).json());

/** All four are drawn by a finger; a source brings its group, and both can be taken back. */
export async function drawn(studio) {
  const { page } = studio;
  await open(studio);
  const touch = { touch: true };
  await tool(studio, 'Exit');
  await drag(studio, ...kExit, touch);
  let now = await scene(studio, 'an exit', ({ areas }) => areas.length === 1 && areas[0].kind === 'exit');
  await tool(studio, 'Waiting');
  await drag(studio, { x: 0, y: 3 }, { x: 4, y: 6 }, touch);
  await scene(studio, 'a waiting area', ({ areas }) => areas.length === 2);
  await tool(studio, 'Stairs');
  await drag(studio, { x: 1, y: -4 }, { x: 1, y: -1 }, touch);
  now = await scene(studio, 'stairs', ({ patches }) => patches.length === 1);
  const [stairs] = now.patches;
  expect(Math.abs(stairs.ascent - Math.PI / 2) < 0.2, `which lead north: ${stairs.ascent}`);
  expect(now.clips[stairs.motion].name === 'walk' && stairs.speedDown === 0.7, 'on which people walk');
  await tool(studio, 'Source');
  await type(studio, 'People [1/s]', '2');
  await drag(studio, { x: -2, y: -2 }, { x: 0, y: 0 }, touch);
  now = await scene(studio, 'a source', ({ areas }) => areas.length === 3);
  expect(now.groups.length === 2 && now.areas[2].group === now.groups[1].id, 'with a group for its people');
  await tool(studio, 'Select');
  await page.locator('.build-chosen-fields h3', { hasText: 'Source' }).waitFor();
  await studio.pictures(2);
  await studio.shot('areas-build');
  await serious(studio, 'building areas');
  await page.getByRole('button', { name: 'Undo add source' }).click();
  await scene(studio, 'neither source nor group', ({ areas, groups }) => areas.length === 2 && groups.length === 1);
  await page.getByRole('button', { name: 'Redo add source' }).click();
  now = await scene(studio, 'both again', ({ areas, groups }) => areas.length === 3 && groups.length === 2);
  expect(now.areas[2].group === now.groups[1].id, 'which belong together');
  await tap(studio, { x: 5, y: -2 });
  await panel(studio).getByLabel('State').selectOption('Closed');
  await scene(studio, 'a closed exit', ({ areas }) => areas[0].open === false);
  await studio.pictures(2);
  await studio.shot('areas-closed');
  await panel(studio).getByLabel('State').selectOption('Open');
  await tool(studio, 'Route');
  await drag(studio, { x: 4.2, y: -2 }, { x: -1, y: -2.5 }, touch);
  await scene(studio, 'a queue before the exit', ({ areas }) => areas[0].open && areas[0].queue.length > 3);
  const file = await saved(studio);
  expect(file.areas.length === 3 && file.groups[1].people === 'adults', 'all of it is in the file');
  await tap(studio, { x: -1, y: -1 });
  await page.getByRole('button', { name: 'Remove', exact: true }).click();
  await scene(
    studio,
    'the source goes with its group',
    ({ areas, groups }) => areas.length === 2 && groups.length === 1,
  );
  await page.getByRole('button', { name: 'Undo remove source' }).click();
  await scene(studio, 'both at once again', ({ areas, groups }) => areas.length === 3 && groups.length === 2);
}

async function ordered(studio, label, at) {
  await studio.tab('orders');
  await studio.page.locator(`.order-tile[aria-label="${label}"]`).click();
  await tap(studio, at);
}

/** A group waits in an area and leaves by an exit, both by taps; who leaves is counted on the exit. */
export async function leaveAndWait(studio) {
  const { page } = studio;
  expect(!(await page.locator('.order-tile[aria-label="Leave"]').isVisible()), 'no exit, no button');
  await open(studio);
  const touch = { touch: true };
  await tool(studio, 'Exit');
  await drag(studio, ...kExit, touch);
  await tool(studio, 'Waiting');
  await drag(studio, { x: -4, y: 1 }, { x: 4, y: 8 }, touch);
  await scene(studio, 'both areas', ({ areas }) => areas.length === 2);
  await page.getByRole('button', { name: 'End building' }).click();
  const { length: count } = crowd(await studio.frame());
  await studio.send({ type: 'Playback', action: 0 });
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await ordered(studio, 'Wait', { x: 1, y: 4 });
  await studio.until('an order to wait', () => globalThis.__muster.frame.groups[0].orders[0]?.kind === 'wait');
  const inside = ({ x, y }) => x > -4.3 && x < 4.3 && y > 0.7 && y < 8.3;
  await studio.eventually(async () => {
    const there = crowd(await studio.frame()).filter(inside).length;
    expect(there > 0.8 * count, `they wait: ${there} of ${count}`);
  }, 60000);
  await studio.pictures(2);
  await studio.shot('areas-waiting');
  const before = crowd(await studio.frame());
  await ordered(studio, 'Leave', { x: 5, y: -2 });
  await studio.until('an order to leave', () => globalThis.__muster.frame.groups[0].orders[0]?.kind === 'leave');
  await studio.until('half of them left', (n) => globalThis.__muster.frame.x.length < n / 2, count, 60000);
  expect(distance(crowd(await studio.frame())[0], before[0]) > 0.5, 'they walk');
  await studio.eventually(async () => {
    const tag = await page.locator('.tag-patch', { hasText: 'Exit' }).textContent();
    const [, told] = /(\d+) out/.exec(tag) ?? [];
    expect(Number(told) > count / 3, `the exit counts them: ${tag}`);
  });
  await studio.shot('areas-leaving');
  await studio.until('all of them left', () => globalThis.__muster.frame.x.length === 0, null, 60000);
  await studio.shot('areas-left');
}

/** People come by a source without end, and leave by all exits. */
export async function sourceToExit(studio) {
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Exit');
  await drag(studio, ...kExit, { touch: true });
  await tool(studio, 'Source');
  await type(studio, 'People [1/s]', '2');
  await drag(studio, { x: -3, y: 1 }, { x: 0, y: 4 }, { touch: true });
  await scene(studio, 'a source', ({ areas }) => areas.length === 2);
  await page.getByRole('button', { name: 'End building' }).click();
  await studio.send({ type: 'Playback', action: 0 });
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await studio.until('people who come', () => globalThis.__muster.frame.areas[1].passed > 9, null, 60000);
  await studio.until('people who leave', () => globalThis.__muster.frame.areas[0].passed > 3, null, 60000);
  await studio.pictures(2);
  await studio.shot('areas-source');
}

const kOpen = { scenario: 'scenarios/open.json', room: true };
export const kAreaCases = [
  ['areas: drawn', drawn, ['landscape', 'portrait', 'desktop'], kOpen],
  ['areas: leave and wait', leaveAndWait, ['landscape', 'portrait', 'phone'], kOpen],
  ['areas: a source', sourceToExit, ['desktop'], kOpen],
];
