// The first minute: the opening place, the first drag, and what the page says where nothing can be done.
import { expect } from '../support/expect.mjs';
import { crowd, distance } from '../support/geometry.mjs';
import { press } from '../support/reach.mjs';

/** A person's height at the opening [CSS px], as in the pictures of the design. */
const kTall = { wide: 40, landscape: 32, tablet: 27, portrait: 32, phone: 18 };

/** In the page: what is wrong with the first picture. */
function looked() {
  const { view, frame } = globalThis.__muster;
  const feet = Array.from(frame.x, (x, i) => ({ x, y: frame.y[i] }));
  const spots = feet.map((at) => view.worldToScreen(at));
  const covered = spots.filter(({ x, y }) => document.elementFromPoint(x, y)?.id !== 'scene').length;
  const heights = feet.map(({ x, y }, i) => spots[i].y - view.camera.worldToScreen(x, y, 1.75).y);
  const tags = [...document.querySelectorAll('.tag-patch')]
    .filter((node) => node.style.visibility !== 'hidden')
    .map((node) => node.getBoundingClientRect());
  const crossed = tags.filter((a, i) =>
    tags.slice(i + 1).some((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom),
  ).length;
  const below = tags.filter((box) =>
    [...document.querySelectorAll('#ui .panel')].some((panel) => {
      const b = panel.getBoundingClientRect();
      return box.left < b.right && b.left < box.right && box.top < b.bottom && b.top < box.bottom;
    }),
  ).length;
  const marks = frame.groups.reduce((sum, one) => sum + one.orders.length + one.controls.length, 0);
  const words = [...document.querySelectorAll('.tag-patch')].map((node) => node.textContent);
  return { covered, tall: Math.min(...heights), tags: tags.length, crossed, below, marks, words };
}

/** The hand drags the middle of a group so far ahead [m]. */
async function drag(studio, index, ahead) {
  const group = (await studio.frame()).groups[index];
  const to = { x: group.x + ahead * Math.cos(group.facing), y: group.y + ahead * Math.sin(group.facing) };
  const [from, end] = await studio.screen([group, to]);
  await studio.fingers.down({ 1: from });
  await studio.fingers.move({ 1: end }, { steps: 16, ms: 900 });
  await studio.fingers.up();
  return group;
}

const moving = (studio, clip) =>
  studio.until(
    `people who ${clip}`,
    (name) => {
      const { view, frame } = globalThis.__muster;
      return [...frame.clip].filter((one) => view.people.clips[one] === name).length >= 3;
    },
    clip,
    6000,
  );

/** Two groups stand before net, wall and pool; the first drags lead them over, and they stay where they were led. */
export async function opening(studio) {
  const { page } = studio;
  await page.reload();
  await studio.until('the first picture', () => (globalThis.__muster?.view.stats.shownFrame ?? 0) > 0);
  await studio.until('the hand to drag', () => Number(document.querySelector('.ghost')?.style.opacity) > 0.9);
  await studio.shot('opening');
  const first = await page.evaluate(looked);
  const before = crowd(await studio.frame());
  await studio.wait(600);
  const still = crowd(await studio.frame()).filter((at, i) => distance(at, before[i]) < 0.1).length;
  expect(still === before.length, `${still} of ${before.length} stand still`);
  expect(first.marks === 0, `nothing is drawn on the ground: ${first.marks}`);
  expect(first.covered === 0, `${first.covered} stand below panels`);
  expect(first.tall >= kTall[studio.size], `the smallest person is ${first.tall} px tall`);
  expect(first.tags === 3, `net, wall and pool are named: ${first.words}`);
  expect(first.crossed === 0 && first.below === 0, `names that are covered: ${first.crossed}, ${first.below}`);
  expect(!/\d/.test(first.words.join()), `names without bare figures: ${first.words}`);
  const north = await drag(studio, 0, 8);
  for (const clip of ['crawl', 'climb']) await moving(studio, clip);
  const south = await drag(studio, 1, 8);
  await moving(studio, 'swim');
  await studio.shot('first-drag');
  await studio.until('the controls to end', () =>
    globalThis.__muster.frame.groups.every(({ controls }) => controls.length === 0),
  );
  await studio.wait(1500);
  const left = (await studio.frame()).groups;
  for (const [was, is] of [
    [north, left[0]],
    [south, left[1]],
  ])
    expect(distance(was, is) > 5, `it stays where it was led: ${distance(was, is)} m away`);
}

const told = (studio) => studio.page.evaluate(() => globalThis.__muster.state.notice?.text ?? '');

/** A loop that holds too little, and an undo where a line is all there is, say so. */
export async function sentences(studio) {
  const { mouse, keyboard } = studio.page;
  const group = (await studio.frame()).groups[0];
  const loop = await studio.screen(
    Array.from({ length: 13 }, (_, k) => ({
      x: group.x + 0.25 * Math.cos((k * Math.PI) / 6),
      y: group.y + 0.25 * Math.sin((k * Math.PI) / 6),
    })),
  );
  await keyboard.down('Alt');
  await mouse.move(loop[0].x, loop[0].y);
  await mouse.down();
  for (const at of loop) await mouse.move(at.x, at.y);
  await mouse.up();
  await keyboard.up('Alt');
  await studio.eventually(async () => expect(/fewer than three points/.test(await told(studio)), await told(studio)));
  const [from, to] = await studio.screen([group, { x: group.x + 3, y: group.y }]);
  await keyboard.down('Shift');
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(to.x, to.y, { steps: 5 });
  await mouse.up();
  await keyboard.up('Shift');
  await studio.until('a line', () => globalThis.__muster.frame.groups[0].controls.length === 1);
  await keyboard.press('Control+z');
  await studio.eventually(async () => expect(/Esc lets go of the line/.test(await told(studio)), await told(studio)));
}

/** A new group follows the pointer; places on which others stand are marked; Escape gives it up. */
export async function ghostOfGroup(studio) {
  const { page } = studio;
  await press(studio, '.add-group');
  const dialog = page.locator('dialog.shape-dialog[open]');
  await dialog.locator('input').nth(0).fill('Visitors');
  await dialog.locator('input').nth(1).fill('60');
  await dialog.locator('button[type="submit"]').click();
  const bar = page.locator('.placing-bar');
  await bar.waitFor();
  const group = (await studio.frame()).groups[0];
  const [over, free] = await studio.screen([group, { x: group.x + 14, y: group.y + 2 }]);
  for (const [at, words] of [
    [over, /\d+ of 60 spots are not free/],
    [free, /All spots are free/],
  ])
    await studio.eventually(async () => {
      await page.mouse.move(at.x + 1, at.y);
      await page.mouse.move(at.x, at.y);
      await studio.wait(150);
      const text = await bar.textContent();
      expect(words.test(text) && text.includes('puts Visitors'), text);
    });
  await studio.shot('ghost-of-group');
  await page.evaluate(() => document.querySelector('#scene').focus());
  await page.keyboard.press('Escape');
  await bar.waitFor({ state: 'hidden' });
  expect((await studio.frame()).groups.length === 1, 'nobody was put down');
}

/** Fit shows all of a large crowd clear of the panels, pressed again all of the place. */
export async function fitInTurn(studio) {
  const { page } = studio;
  const covered = (points) =>
    page.evaluate(
      (list) =>
        list
          .map((at) => globalThis.__muster.view.worldToScreen(at))
          .filter(({ x, y }) => document.elementFromPoint(x, y)?.id !== 'scene').length,
      points,
    );
  const fit = async () => {
    await press(studio, '.view-bar [aria-label="Fit"]');
    await studio.wait(100);
    await studio.cameraAtRest();
  };
  await page.evaluate(() => globalThis.__muster.view.camera.zoomAt({ x: 300, y: 300 }, 3));
  await fit();
  expect((await covered(crowd(await studio.frame()))) === 0, 'a thousand are in view');
  const near = await page.evaluate(() => globalThis.__muster.view.camera.pose.distance);
  await fit();
  const corners = [-1, 1].flatMap((x) => [-1, 1].map((y) => ({ x: 29.5 * x, y: 19.5 * y })));
  const far = await page.evaluate(() => globalThis.__muster.view.camera.pose.distance);
  expect(far > near, `the place is larger: ${far} m`);
  expect((await covered(corners)) === 0, 'the corners of the place are in view');
  await fit();
  const again = await page.evaluate(() => globalThis.__muster.view.camera.pose.distance);
  expect(Math.abs(again - near) < 1, `and the crowd in turn: ${again} m`);
}

/** The open readout takes no row of its own, and leaves the chips of the groups their room. */
export async function openReadout(studio) {
  const tops = () =>
    studio.page.evaluate(() =>
      ['.layers', '.readout', '.groups'].map((what) => document.querySelector(what).getBoundingClientRect().top),
    );
  const before = await tops();
  await press(studio, '.plain');
  await studio.until('the figures', () => document.querySelector('.figure') !== null);
  await studio.shot('open-readout');
  const after = await tops();
  if (studio.size === 'portrait') expect(before[1] === after[1], `in the row of the layers: ${after}`);
  const hidden = await studio.page.evaluate(() => {
    const bar = document.querySelector('.groups').getBoundingClientRect();
    const chip = [...document.querySelectorAll('.groups button:not(.add-group)')].at(-1).getBoundingClientRect();
    return Math.max(0, chip.right - Math.max(bar.right, 0) - 14);
  });
  expect(hidden === 0, `${hidden} px of the second chip are hidden`);
  await press(studio, '.plain');
}

const kOpening = { hint: true, scenario: 'scenarios/fountain.json' };

export const kFirstMinuteCases = [
  [
    'first minute: opening',
    opening,
    ['wide', 'landscape', 'tablet', 'portrait', 'phone'],
    { ...kOpening, everySize: true },
  ],
  ['first minute: sentences', sentences, ['desktop'], { touch: false, scenario: 'scenarios/open.json' }],
  [
    'first minute: a new group',
    ghostOfGroup,
    ['desktop'],
    { touch: false, scenario: 'scenarios/open.json', room: true },
  ],
  ['first minute: fit', fitInTurn, ['wide', 'landscape'], { scenario: 'web/tests/scenarios/thousand.json' }],
  [
    'first minute: open readout',
    openReadout,
    ['portrait', 'phone'],
    { scenario: 'scenarios/fountain.json', everySize: true },
  ],
];
