// Who is in place: said where it is so, and else how many are not, and why.
import { expect } from '../support/expect.mjs';
import { extreme, points } from '../support/geometry.mjs';

const kOnTheWay = 1;
const kOutside = 4;

/** In the page: how many stand as each Standing tells. */
const standings = () => [...globalThis.__muster.frame.groups[0].standings];
const words = (studio, part) => studio.page.locator(`.plain-${part}`).textContent();

/** Keeps all banners that are shown from now on. */
const watchBanners = (studio) =>
  studio.page.evaluate(() => {
    globalThis.__banners = [];
    const banner = document.querySelector('.notice');
    const keep = () => {
      if (!banner.hidden && banner.textContent !== '') globalThis.__banners.push(banner.textContent);
    };
    new globalThis.MutationObserver(keep).observe(banner, { childList: true, subtree: true, attributes: true });
  });
const banners = (studio) => studio.page.evaluate(() => globalThis.__banners);

async function atRest(studio) {
  await studio.until(
    'everybody to stand',
    (walk) => {
      const found = [...globalThis.__muster.frame.groups[0].standings];
      return found.length > 0 && found[walk] === 0;
    },
    kOnTheWay,
    20000,
  );
}

/** A press beyond the edge says at once that places lie there; the crowd that is squeezed against it is not in place. */
export async function beyondTheEdge(studio) {
  const { mouse } = studio.page;
  const [at] = await studio.screen([{ x: -4, y: -17.5 }]);
  await mouse.click(at.x, at.y, { button: 'right' });
  await studio.until('the walk', (walk) => [...globalThis.__muster.frame.groups[0].standings][walk] > 20, kOnTheWay);
  expect((await words(studio, 'does')) !== 'all in their places', 'who walks is not in place');
  await studio.until(
    'words beside the target',
    () => /outside the ground/.test(globalThis.__muster.view.orders.scene(true).drawn?.note?.text ?? ''),
    null,
    3000,
  );
  await studio.pictures(2);
  await studio.shot('edge-order');
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await atRest(studio);
  await studio.until('the banner', () => !document.querySelector('.notice').hidden, null, 8000);
  const said = await studio.page.locator('.notice strong').textContent();
  expect(
    /^Crowd: (nobody is|\d+ of 49 are) in place\. \d+ cannot be: .*outside the ground/.test(said),
    `the banner: ${said}`,
  );
  const found = await studio.page.evaluate(standings);
  expect(found[kOutside] > 5, `places lie outside: ${found}`);
  expect((await words(studio, 'does')) !== 'all in their places', 'the readout does not say that all are');
  expect(/places outside the ground/.test(await words(studio, 'barred')), 'it says where the places are');
  await studio.page.locator('.notice-show').click();
  await studio.until('marks', () => globalThis.__muster.view.orders.scene(true).barred.length > 0);
  await studio.cameraAtRest();
  await studio.shot('edge-shown');
  const barred = found.slice(3).reduce((sum, count) => sum + count, 0);
  const marked = await studio.page.evaluate(() => globalThis.__muster.view.orders.scene(true).barred.length);
  expect(marked === barred, `all of them are marked: ${marked} of ${barred}`);
  await studio.page.locator('.notice-close').click();
  await studio.page.locator('.plain-show').click();
  await studio.cameraAtRest();
}

/** A word across the granary: letters lie in it. */
export async function wordInAWall(studio) {
  const points = Array.from({ length: 36 }, (_, i) => [(i % 12) * 0.8 - 4.4, Math.floor(i / 12) * 2 - 2]);
  await studio.send({
    type: 'Commands',
    commands: [
      { kind: 'changeGroup', group: 1, formation: { kind: 'points', points } },
      { kind: 'pose', group: 1, position: [2, 0], angle: 0 },
    ],
  });
  await studio.until('the walk', (walk) => [...globalThis.__muster.frame.groups[0].standings][walk] > 20, kOnTheWay);
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await atRest(studio);
  await studio.until('the banner', () => /cannot be/.test(document.querySelector('.notice').textContent), null, 8000);
  expect((await words(studio, 'does')) !== 'all in their places', 'the readout does not say that all are');
  expect(/in obstacles|too narrow|without room/.test(await words(studio, 'barred')), 'it says why');
  await studio.shot('word-in-wall');
}

/** Ten drags that end well give no banner, and while people run they are not in place. */
export async function tenDrags(studio) {
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await watchBanners(studio);
  let ran = 0;
  for (let i = 0; i < 10; ++i) {
    const corner = extreme(points((await studio.frame()).groups[0].vertices), 1, 0);
    const step = i % 2 === 0 ? 3 : -3;
    const [from, to] = await studio.screen([corner, { x: corner.x + step, y: corner.y + step / 3 }]);
    await studio.fingers.down({ 1: from });
    await studio.fingers.move({ 1: to }, { steps: 4, ms: 80 });
    const told = await studio.page.evaluate(() => ({
      walk: [...globalThis.__muster.frame.groups[0].standings][1],
      does: document.querySelector('.plain-does').textContent,
    }));
    if (told.walk > 0) expect(told.does !== 'all in their places', `while ${told.walk} run: ${told.does}`);
    ran += told.walk > 0 ? 1 : 0;
    await studio.fingers.up();
    await atRest(studio);
  }
  await studio.until('quiet words', () => {
    const live = [...document.querySelectorAll('[aria-live="polite"]')].map((one) => one.textContent);
    return live.some((text) => text.includes('everybody is in place'));
  });
  expect(ran > 2, `they were seen running: ${ran} times`);
  expect((await words(studio, 'does')) === 'all in their places', 'now they are');
  const shown = await banners(studio);
  expect(shown.length === 0, `no banner: ${shown.join(' | ')}`);
}

const kOpen = { scenario: 'scenarios/open.json', room: true };

export const kStandingCases = [
  ['standing: beyond the edge', beyondTheEdge, ['wide'], { ...kOpen, touch: false }],
  ['standing: a word in a wall', wordInAWall, ['desktop'], { scenario: 'scenarios/block.json' }],
  ['standing: ten drags', tenDrags, ['desktop'], kOpen],
];
