// Paths of a take, changed afterwards by finger and mouse.
import { expect } from '../support/expect.mjs';
import { pause, play, record, stop } from './takes.mjs';

const words = (studio) => studio.page.locator('.path-words').textContent();

/** Where the group's middle is at a moment of the open take [m]. */
async function middleAt(studio, step) {
  await studio.send({ type: 'Seek', step });
  await studio.until('the moment', (wished) => globalThis.__muster.frame.step === wished, step);
  return studio.page.evaluate(() => {
    const { x, y } = globalThis.__muster.frame;
    const mean = (all) => all.reduce((sum, one) => sum + one, 0) / all.length;
    return { x: mean(x), y: mean(y) };
  });
}

const away = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

/** Points of the drawn path on the screen. */
const drawnPath = (studio) =>
  studio.page.evaluate(() => [...document.querySelectorAll('.path-line')[0].points].map(({ x, y }) => ({ x, y })));

async function titles(studio) {
  const { takes } = await studio.page.evaluate(async () => (await fetch('takes')).json());
  return takes.map(({ title, scenario }) => title || scenario);
}

/** Pulls a path aside around a moment; the take that comes of it differs there and hardly elsewhere. */
export async function path(studio, byMouse) {
  await record(studio, 3);
  await stop(studio);
  await play(studio);
  await pause(studio);
  const from = await studio.page.evaluate(() =>
    Number(document.querySelector('.time-from').getAttribute('aria-valuenow')),
  );
  const held = Math.ceil((from + 75) / 15) * 15;
  const last = await studio.page.evaluate(() =>
    Number(document.querySelector('.time-playhead').getAttribute('aria-valuemax')),
  );
  const before = { early: await middleAt(studio, 1), there: await middleAt(studio, held) };
  await studio.page.locator('.time-path').click();
  await studio.until('the path', () => document.querySelector('.path-line')?.points.length > 4, null, 20000);
  await studio.shot('path-shown');
  const dots = await drawnPath(studio);
  expect(dots.length >= Math.floor(last / 15), `a dot per quarter of a second: ${dots.length} of ${last} steps`);
  for (let k = 0; k < 2; ++k) await studio.page.locator('.path-step').first().click();
  const reach = await studio.page.locator('.path-reach input').inputValue();
  expect(Number(reach) < 3, `the reach is shorter: ${reach}`);

  const at = dots[held / 15];
  const scale = await studio.page.evaluate(() => globalThis.__muster.view.pixelsPerMetre());
  const to = { x: at.x, y: at.y - 2.5 * scale };
  if (byMouse) {
    await studio.page.mouse.move(at.x, at.y);
    await studio.page.mouse.down();
    await studio.page.mouse.move(to.x, to.y, { steps: 8 });
  } else {
    await studio.fingers.down({ 1: at });
    await studio.fingers.move({ 1: to }, { steps: 8, ms: 300 });
  }
  await studio.until('a preview', () => document.querySelector('.path-before'));
  await studio.shot('path-pulled');
  if (byMouse) await studio.page.mouse.up();
  else await studio.fingers.up();
  await studio.until(
    'the other take',
    () => /^Changed/.test(document.querySelector('.path-words').textContent),
    null,
    60000,
  );
  await studio.shot('path-changed');
  const after = { early: await middleAt(studio, 1), there: await middleAt(studio, held) };
  expect(away(before.early, after.early) < 0.01, 'the beginning is as it was');
  expect(
    away(before.there, after.there) > 0.5,
    `the middle went ${away(before.there, after.there).toFixed(2)} m elsewhere`,
  );
  const kept = await titles(studio);
  expect(kept.length === 2 && kept.some((title) => / \(changed\)$/.test(title)), `both lie on the shelf: ${kept}`);

  await studio.page.locator('.path-back').click();
  await studio.eventually(async () => {
    const there = await middleAt(studio, held);
    expect(away(before.there, there) < 1e-3, `the take before is back: ${away(before.there, there)}`);
  });
  await studio.page.keyboard.press('Escape');
  expect(!(await studio.page.locator('.path-bar').isVisible()), 'Escape leaves the paths');
  expect(await studio.page.locator('.time-line').isVisible(), 'the take stays open');
}

/** The place of the person with that index in the frame. */
const placeOf = (studio, index) =>
  studio.page.evaluate((i) => {
    const { x, y } = globalThis.__muster.frame;
    return { x: x[i], y: y[i] };
  }, index);

/** One person's path is changed by a pin under a finger; all others keep theirs. Undo, redo, and the take opened again. */
export async function person(studio) {
  await record(studio, 2.5);
  await stop(studio);
  await play(studio);
  await pause(studio);
  await studio.page.keyboard.press('Shift+P');
  await studio.until('the path', () => document.querySelector('.path-line')?.points.length > 4, null, 20000);
  await studio.page.locator('.path-whose button', { hasText: 'Person' }).click();
  expect(/Tap a person/.test(await words(studio)), await words(studio));
  const others = () => studio.frame().then(({ x, y }) => [...x, ...y].filter((_, k) => k !== 0 && k !== x.length));
  const before = { place: await placeOf(studio, 0), others: await others() };
  const [at] = await studio.screen([before.place]);
  await studio.fingers.down({ 1: at });
  await studio.fingers.up();
  await studio.until('the path of one', () => document.querySelectorAll('.path-line').length === 1, null, 20000);
  await studio.until('its words', () => /^Person \d+: drag/.test(document.querySelector('.path-words').textContent));
  const dots = await drawnPath(studio);
  const step = await studio.page.evaluate(() => globalThis.__muster.frame.step);
  const hand = dots[Math.round(step / 15)] ?? dots.at(-1);
  const scale = await studio.page.evaluate(() => globalThis.__muster.view.pixelsPerMetre());
  await studio.shot('person-path');
  await studio.fingers.down({ 1: hand });
  await studio.fingers.move({ 1: { x: hand.x, y: hand.y - 1.2 * scale } }, { steps: 8, ms: 400 });
  await studio.until('a pin', () => document.querySelector('.path-pin.chosen'));
  await studio.fingers.up();
  const moved = async () => away(before.place, await placeOf(studio, 0));
  await studio.eventually(async () => expect((await moved()) > 0.6, `the person stands elsewhere: ${await moved()}`));
  const same = (await others()).every((value, k) => value === before.others[k]);
  expect(same, 'everybody else stands where they stood');
  await studio.shot('person-pin');

  await studio.page.locator('.path-undo').click();
  await studio.eventually(async () => expect((await moved()) < 1e-3, `it is taken back: ${await moved()}`));
  await studio.page.locator('.path-redo').click();
  await studio.eventually(async () => expect((await moved()) > 0.6, `it is done again: ${await moved()}`));

  await studio.page.locator('.path-time-open').click();
  await studio.shot('person-time');
  await studio.page.keyboard.press('Escape');
  await studio.page.locator('.path-clip-open').click();
  await studio.page.locator('.path-clips button', { hasText: /^jog$/ }).waitFor();
  await studio.shot('person-clip');
  await studio.page.keyboard.press('Escape');

  const name = await studio.page.evaluate(async () => (await (await fetch('takes')).json()).takes[0].name);
  const opened = await studio.page.evaluate(
    async (path) => (await fetch(path, { method: 'POST' })).status,
    `takes/${encodeURIComponent(name)}/open`,
  );
  expect(opened === 200, `it opens again: ${opened}`);
  await studio.send({ type: 'Playback', action: 1 });
  await studio.send({ type: 'Seek', step });
  await studio.until('the moment', (wished) => globalThis.__muster.frame.step === wished, step, 20000);
  await studio.eventually(async () => expect((await moved()) > 0.6, `the change is kept: ${await moved()}`));
}
