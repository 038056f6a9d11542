// The tracks of a take: blocks dragged, copied, removed and taken back by mouse, finger and keys; cuts of the camera.
import { expect } from '../support/expect.mjs';
import { serious } from './look.mjs';
import { pause, play, stop } from './takes.mjs';

/** Both groups walk towards each other, one second apart, and the take opens with its tracks. */
async function openTracks(studio, seconds = 5) {
  const { page } = studio;
  const groups = await page.evaluate(() => globalThis.__muster.state.groups.map(({ id }) => id));
  const order = (k, target) =>
    studio.send({ type: 'Commands', commands: [{ kind: 'order', group: groups[k], order: { target } }] });
  const recorded = (least) =>
    studio.until('so much of it', (wished) => globalThis.__muster.frame.recordedSeconds >= wished, least, 60000);
  await page.locator('.record').click();
  await recorded(0.3);
  await order(0, [-4, 8]);
  await recorded(1.3);
  await order(1, [4, -8]);
  await recorded(seconds);
  await stop(studio);
  await play(studio);
  await pause(studio);
  await page.locator('.time-tracks').click();
  await read(studio, 2);
}

/** The take has been simulated, and has so many blocks. */
const read = (studio, count) =>
  studio.until(
    `${count} blocks`,
    (wished) =>
      document.querySelectorAll('.track-block:not(.track-ghost)').length === wished &&
      !document.querySelector('.tracks-rows').hasAttribute('data-waits'),
    count,
    60000,
  );

/** Steps in which the block of a row begins, as it says. */
const beginsAt = (studio, row) =>
  studio.page.evaluate((k) => {
    const label = document.querySelectorAll('.track-row[data-group]')[k].querySelector('.track-block').ariaLabel;
    const [, minutes, seconds] = /, (\d+):([\d.]+)/.exec(label);
    return Number(minutes) * 60 + Number(seconds);
  }, row);

/** Where the middle of a group is at a step. */
async function middleAt(studio, step, group) {
  await studio.send({ type: 'Seek', step });
  await studio.until('the moment', (wished) => globalThis.__muster.frame.step === wished, step, 30000);
  return studio.page.evaluate((k) => {
    const { x, y } = globalThis.__muster.frame.groups[k];
    return { x, y };
  }, group);
}

const away = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

async function middleOf(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + Math.min(width / 2, 30), y: y + height / 2 };
}

async function drag(studio, from, to, byMouse) {
  if (byMouse) {
    await studio.page.mouse.move(from.x, from.y);
    await studio.page.mouse.down();
    await studio.page.mouse.move(to.x, to.y, { steps: 6 });
    await studio.page.mouse.up();
  } else {
    await studio.fingers.down({ 1: from });
    await studio.fingers.move({ 1: to }, { steps: 6, ms: 200 });
    await studio.fingers.up();
  }
}

/** A block goes to another time, the crowd with it, and back. */
export async function tracks(studio, byMouse) {
  await openTracks(studio);
  const { page } = studio;
  await studio.send({ type: 'Seek', step: 120 });
  await studio.until('the moment', () => globalThis.__muster.frame.step === 120, null, 30000);
  await serious(studio, 'tracks of a take');
  await studio.shot('tracks');
  const block = page.locator('.track-row[data-group]').nth(1).locator('.track-block');
  const began = await beginsAt(studio, 1);
  const held = Math.round((began + 2) * 60);
  const before = await middleAt(studio, held, 1);
  const other = await middleAt(studio, held, 0);
  const from = await middleOf(block);
  const lane = await page.locator('.track-lane').last().boundingBox();
  await drag(studio, from, { x: from.x + 0.25 * lane.width, y: from.y }, byMouse);
  await studio.until('the change', () => document.querySelector('.tracks-undo')?.ariaDisabled !== 'true', null, 60000);
  await read(studio, 2);
  const begins = await beginsAt(studio, 1);
  expect(begins > began + 0.8, `the block begins later: at ${begins} s, not ${began}`);
  const after = await middleAt(studio, held, 1);
  expect(away(before, after) > 0.5, `its group sets out later: ${away(before, after).toFixed(2)} m`);
  await studio.shot('tracks-moved');
  if (byMouse) await page.keyboard.press('Control+z');
  else await page.locator('.tracks-undo').click();
  await studio.until(
    'all as before',
    () => document.querySelector('.tracks-redo')?.ariaDisabled !== 'true',
    null,
    60000,
  );
  await read(studio, 2);
  expect((await beginsAt(studio, 1)) === began, 'the block is back');
  expect(away(before, await middleAt(studio, held, 1)) < 1e-3, 'and so is its group');
  expect(away(other, await middleAt(studio, held, 0)) < 1e-3, 'the other group was never concerned');
}

/** Keys alone: a tenth of a second, a copy at the playhead, and away with it. */
export async function tracksByKeys(studio) {
  await openTracks(studio, 3);
  const { page } = studio;
  const first = page.locator('.track-block').first();
  const began = await beginsAt(studio, 0);
  await first.focus();
  for (let k = 0; k < 3; ++k) await page.keyboard.press('ArrowRight');
  await studio.until('the change', () => document.querySelector('.tracks-undo')?.ariaDisabled !== 'true', null, 60000);
  await read(studio, 2);
  const begins = await beginsAt(studio, 0);
  expect(Math.abs(begins - began - 0.3) < 0.051, `three presses are three tenths: from ${began} to ${begins}`);
  const focused = () => page.evaluate(() => document.activeElement.ariaLabel ?? '');
  expect(/^Move/.test(await focused()), `the focus stays on the block: ${await focused()}`);
  await page.keyboard.press('Control+c');
  await page.keyboard.press('Control+v');
  await read(studio, 3);
  await studio.shot('tracks-copied');
  await page.keyboard.press('Delete');
  await read(studio, 2);
}

/** Two views and a cut between them: the camera rests, and is there at once. */
export async function cameraCut(studio) {
  await openTracks(studio, 3);
  const { page } = studio;
  const pose = () => page.evaluate(() => ({ ...globalThis.__muster.view.camera.pose }));
  const keep = page.locator('.track-camera .track-name button');
  const at = async (step) => {
    await studio.send({ type: 'Seek', step });
    await studio.until('the moment', (wished) => globalThis.__muster.frame.step === wished, step, 30000);
    await studio.pictures(2);
    return pose();
  };
  await at(20);
  await keep.click();
  const first = await at(140);
  await page.evaluate(() => globalThis.__muster.view.camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, 0.6));
  await keep.click();
  const last = await pose();
  const near = (a, b) => Math.abs(a.distance - b.distance) < 0.02 * b.distance;
  expect(!near(await at(80), first) && !near(await at(80), last), 'the camera travels');
  await page.locator('.track-key').nth(1).click();
  await page.locator('.tracks-chosen button[aria-label="Cut"]').click();
  await studio.until('the cut', () => document.querySelector('.track-key[data-cut]') !== null);
  await studio.until('two shots', () => document.querySelectorAll('.track-shot').length === 2);
  expect(near(await at(139), first), 'before the cut it rests');
  expect(near(await at(140), last), 'at the cut it is there');
  await studio.shot('tracks-cut');
  await page.keyboard.press('Escape');
  const key = page.locator('.track-key').nth(1);
  await key.focus();
  await page.keyboard.press('Delete');
  await studio.until('one view', () => document.querySelectorAll('.track-key').length === 1);
}

const kTwo = { scenario: 'web/tests/scenarios/two-groups.json' };

export const kTracksCases = [
  ['tracks: by mouse', (studio) => tracks(studio, true), ['desktop'], { ...kTwo, touch: false }],
  ['tracks: by touch', (studio) => tracks(studio, false), ['landscape', 'portrait', 'phone'], kTwo],
  ['tracks: by keys', tracksByKeys, ['desktop'], { ...kTwo, touch: false }],
  ['tracks: camera cut', cameraCut, ['desktop', 'phone'], kTwo],
];
