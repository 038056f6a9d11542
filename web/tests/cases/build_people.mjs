// The persons of a group, the timetable of a source and the times of an exit, as somebody builds them.
import { expect } from '../support/expect.mjs';
import { drag, open, scene, screen, tool } from './build.mjs';
import { serious } from './look.mjs';

const panel = (studio) => studio.page.locator('.build-panel');
const saved = (studio) => studio.page.evaluate(async () => await (await globalThis.__muster.ask('scenario')).json());
const notice = (studio) => studio.page.evaluate(() => globalThis.__muster.state.notice?.text ?? '');

async function type(studio, label, value) {
  await panel(studio).getByLabel(label, { exact: true }).fill(value);
  await panel(studio).getByLabel(label, { exact: true }).press('Enter');
}

async function tap(studio, at) {
  const [p] = await screen(studio, [at]);
  await studio.fingers.down({ 1: p });
  await studio.fingers.up();
}

/** Radii in the newest frame that tells any [cm]. */
async function follow(studio) {
  await studio.page.evaluate(() => {
    globalThis.__radii = [];
    globalThis.__muster.client.on('frame', ({ frame }) => {
      if (frame.ids.length > 0 || frame.radius.length > 0) globalThis.__radii = [...frame.radius];
    });
  });
}

const peopleOf = (now) => now.groups[0].definition.people;

/** Sorts are made, changed and taken back; they hold in the world, in the scene and in the file. */
export async function persons(studio) {
  const { page } = studio;
  await open(studio);
  await follow(studio);
  const { x, y } = await page.evaluate(() => ({
    x: globalThis.__muster.frame.x[0],
    y: globalThis.__muster.frame.y[0],
  }));
  await tap(studio, { x, y });
  await page.locator('.build-chosen-fields h3', { hasText: 'People' }).waitFor();
  const choose = (label, word) => panel(studio).getByLabel(label, { exact: true }).selectOption(word);
  await choose('Persons', 'Adults');
  await scene(studio, 'adults', (now) => peopleOf(now)[0]?.name === 'Adults');
  await choose('Persons', 'Sorts of one’s own');
  await scene(studio, 'a sort of its own', (now) => peopleOf(now)[0].name === 'Sort 1');
  await choose('Radius', 'Uniform');
  await scene(studio, 'radii', (now) => peopleOf(now)[0].radius.spread === 'uniform');
  await type(studio, 'Radius, to', '0.3');
  await scene(studio, 'the largest radius', (it) => peopleOf(it)[0].radius.b === 0.3);
  await type(studio, 'Radius, from', '0.2');
  await scene(studio, 'the least radius', (it) => peopleOf(it)[0].radius.a === 0.2);
  await choose('Premovement', 'Log-normal');
  await page.getByRole('button', { name: 'Add a sort' }).click();
  const now = await scene(studio, 'two sorts', (it) => peopleOf(it).length === 2);
  expect(peopleOf(now)[0].radius.a === 0.2 && peopleOf(now)[0].radius.b === 0.3, JSON.stringify(peopleOf(now)));
  await type(studio, 'Sort 2, share', '0.5');
  await scene(studio, 'shares', (it) => peopleOf(it)[1].share === 0.5);
  await studio.eventually(async () => {
    const radii = await page.evaluate(() => globalThis.__radii);
    expect(new Set(radii).size > 4, `bodies differ: ${radii.slice(0, 9)}`);
  });
  await type(studio, 'Sort 1, Radius, to', '0.1');
  await page.locator('.build-refused', { hasText: 'ends below where it begins' }).waitFor();
  await page.locator('.build-persons').scrollIntoViewIfNeeded();
  await studio.pictures(2);
  await studio.shot('build-persons');
  await serious(studio, 'persons of a group');
  await page.getByRole('button', { name: 'Undo persons' }).click();
  await scene(studio, 'the share of before', (it) => peopleOf(it)[1].share === 1);
  const file = await saved(studio);
  expect(
    file.groups[0].people.length === 2 && file.groups[0].people[0].premovement.spread === 'logNormal',
    'in the file',
  );
  expect((await notice(studio)) === '' || /Undone/.test(await notice(studio)), 'nothing was refused');
}

/** A source has a timetable, an exit opens and closes. */
export async function times(studio) {
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Source');
  await drag(studio, { x: -4, y: 1 }, { x: -1, y: 4 }, { touch: true });
  await scene(studio, 'a source', ({ areas }) => areas.length === 1);
  await tool(studio, 'Select');
  await tap(studio, { x: -2.5, y: 2.5 });
  await page.locator('.build-chosen-fields h3', { hasText: 'Source' }).waitFor();
  await type(studio, 'Until, 0: no end [s]', '90');
  await type(studio, 'In all, 0: no end', '50');
  await page.getByRole('button', { name: 'Add an arrival' }).click();
  await scene(studio, 'an arrival', ({ areas }) => areas[0].timetable.length === 1);
  await page.getByRole('button', { name: 'Add an arrival' }).click();
  await scene(studio, 'another one', ({ areas }) => areas[0].timetable.length === 2);
  await type(studio, 'Arrival 2, people', '12');
  const now = await scene(studio, 'a dozen', ({ areas }) => areas[0].timetable[1]?.count === 12);
  expect(now.areas[0].until === 90 && now.areas[0].most === 50 && now.areas[0].timetable[1].time === 120, 'its times');
  await page.locator('.build-timetable').scrollIntoViewIfNeeded();
  await studio.pictures(2);
  await studio.shot('build-timetable');
  await serious(studio, 'a timetable');
  await page.getByRole('button', { name: 'Undo timetable' }).click();
  await scene(studio, 'twenty', ({ areas }) => areas[0].timetable[1]?.count === 20);
  await tool(studio, 'Exit');
  await drag(studio, { x: 4, y: -3 }, { x: 6, y: -1 }, { touch: true });
  await scene(studio, 'an exit', ({ areas }) => areas.length === 2);
  await tool(studio, 'Select');
  await tap(studio, { x: 5, y: -2 });
  await page.locator('.build-chosen-fields h3', { hasText: 'Exit' }).waitFor();
  await type(studio, 'Opens at [s]', '5');
  await type(studio, 'Closes at, 0: never [s]', '20');
  await scene(studio, 'its times', ({ areas }) => areas[1].from === 5 && areas[1].until === 20);
  await studio.pictures(2);
  await studio.shot('build-exit-times');
}

const kOpen = { scenario: 'scenarios/open.json', room: true };
export const kPeopleCases = [
  ['build: persons', persons, ['landscape', 'portrait', 'phone', 'desktop'], kOpen],
  ['build: times', times, ['portrait', 'desktop'], kOpen],
];
