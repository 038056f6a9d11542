// The colour of a group: chosen by mouse, keys and touch, seen everywhere, taken back, saved and opened.
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect } from '../support/expect.mjs';
import { kPort, runProgram, startStudio } from '../support/server.mjs';
import { StudioPage } from '../support/studio_page.mjs';
import { open, scene, screen } from './build.mjs';
import { serious } from './look.mjs';

const groupsOf = (studio) =>
  studio.page.evaluate(async () => (await (await fetch('/scenario')).json()).groups.map(({ colour }) => colour ?? ''));

/** `#rrggbb`; empty where nobody has chosen one. */
const chosenIn = ({ groups: [{ definition }] }) =>
  definition.colour === null ? '' : `#${definition.colour.toString(16).padStart(6, '0')}`;

/** Opens the panel of the first group. */
async function chooseGroup(studio, touch) {
  await open(studio);
  const [{ position }] = await studio.page.evaluate(async () => (await (await fetch('/scenario')).json()).groups);
  const [at] = await screen(studio, [{ x: position[0], y: position[1] }]);
  if (touch) await studio.page.touchscreen.tap(at.x, at.y);
  else await studio.page.mouse.click(at.x, at.y);
  const row = studio.page.getByRole('radiogroup', { name: 'Colour' });
  await row.scrollIntoViewIfNeeded();
  return row;
}

/** How many pixels of the picture are magenta, which nothing else in this place is. */
async function magenta(studio) {
  const png = (await studio.page.screenshot()).toString('base64');
  return studio.page.evaluate(async (data) => {
    const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const pen = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
    pen.drawImage(picture, 0, 0);
    // Right of the panel, which has the swatch.
    const { data: bytes } = pen.getImageData(360, 0, picture.width - 360, picture.height);
    let found = 0;
    for (let i = 0; i < bytes.length; i += 4) {
      const [r, g, b] = [bytes[i], bytes[i + 1], bytes[i + 2]];
      if (r > 1.6 * g && b > 1.25 * g && r > 90) ++found;
    }
    return found;
  }, png);
}

/** The accents that meshes, marks and people are drawn with. */
const drawn = (studio) =>
  studio.page.evaluate(() => globalThis.__muster.view.orders.colours.map((one) => one % 0x1000000));

const checked = (row) => row.getByRole('radio', { checked: true }).getAttribute('aria-label');

export async function byMouse(studio) {
  const { page } = studio;
  const row = await chooseGroup(studio, false);
  expect((await row.getByRole('radio').count()) === 13, 'twelve colours and the automatic one');
  expect((await checked(row)) === 'Automatic, blue', 'the automatic one counts');
  const before = await magenta(studio);
  await row.getByRole('radio', { name: 'Magenta' }).click();
  await scene(studio, 'magenta', (one) => chosenIn(one) === '#d60ea8');
  await studio.eventually(async () => expect((await checked(row)) === 'Magenta', 'marked'));
  await studio.eventually(async () => expect((await drawn(studio))[0] === 0xd60ea8, 'meshes and people take it'));
  await page.mouse.move(700, 20);
  await studio.eventually(async () => {
    const now = await magenta(studio);
    expect(before < 20 && now > before + 300, `people are seen in it: ${before}, then ${now} pixels`);
  });
  await farAway(studio);
  const colour = await page
    .locator('.groups .chip svg')
    .first()
    .evaluate((one) => getComputedStyle(one).color);
  expect(colour === 'rgb(214, 14, 168)', `the chip's mark: ${colour}`);
  // Keys: arrows go and are no edit, Space chooses, the focus stays, Ctrl+Z takes it back.
  await row.getByRole('radio', { name: 'Magenta' }).focus();
  await page.keyboard.press('ArrowRight');
  expect((await chosenNow(studio)) === '#d60ea8', 'an arrow key is no edit');
  await page.keyboard.press('Space');
  await scene(studio, 'teal', (one) => chosenIn(one) === '#05536d');
  await studio.eventually(async () => {
    const focused = await page.evaluate(() => document.activeElement?.getAttribute('aria-label'));
    expect(focused === 'Teal', `the focus stays: ${focused}`);
  });
  await studio.shot('group-colour');
  await page.keyboard.press('Control+z');
  await scene(studio, 'one step back', (one) => chosenIn(one) === '#d60ea8');
  await page.keyboard.press('Control+Shift+Z');
  await scene(studio, 'and on', (one) => chosenIn(one) === '#05536d');
  await inTheDark(studio);
  await ownColour(studio, row);
  await savedAndPlayed(studio, row);
  await serious(studio, 'colour of a group');
}

/** From far above people are simple bodies. */
async function farAway(studio) {
  const { page } = studio;
  const pose = await page.evaluate(() => ({ ...globalThis.__muster.view.camera.pose }));
  await page.evaluate(() => globalThis.__muster.view.camera.zoomAt({ x: 700, y: 400 }, 0.3));
  await studio.eventually(async () => {
    const now = await magenta(studio);
    expect(now > 20, `and from far away: ${now} pixels`);
  });
  await page.evaluate((old) => globalThis.__muster.view.camera.setPose(old), pose);
}

const chosenNow = async (studio) => chosenIn(await studio.page.evaluate(() => globalThis.__scenes.at(-1)));

/** A swatch has another shade on dark ground. */
async function inTheDark(studio) {
  const { page } = studio;
  await page.emulateMedia({ colorScheme: 'dark' });
  const mark = page.locator('.groups .chip svg').first();
  await studio.eventually(async () => {
    const colour = await mark.evaluate((one) => getComputedStyle(one).color);
    expect(colour === 'rgb(23, 215, 255)', `teal in the dark: ${colour}`);
  });
  await serious(studio, 'colour of a group in the dark');
  await studio.shot('group-colour-dark');
  await page.emulateMedia({ colorScheme: 'light' });
}

/** Any other colour; one that is hard to see says so. */
async function ownColour(studio, row) {
  const { page } = studio;
  await page.getByLabel('Own colour').fill('#f2e8d0');
  await scene(studio, 'an own colour', (one) => chosenIn(one) === '#f2e8d0');
  await page.getByText('hard to see on light ground').waitFor();
  expect((await row.getByRole('radio', { checked: true }).count()) === 0, 'no swatch is marked');
  await studio.shot('group-colour-own');
  await studio.tab('view');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await page.locator('.groups .chip').first().waitFor();
  await studio.shot('group-colour-own-directing');
  await serious(studio, 'directing in an own colour');
  await studio.tab('view');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  await page.locator('.build-panel').waitFor();
  await page.getByRole('button', { name: 'Undo colour' }).click();
  await scene(studio, 'one step for an own colour', (one) => chosenIn(one) === '#05536d');
}

/** The saved place has it, plays by the command line to the same hash as often as it is played, and opens with it. */
async function savedAndPlayed(studio) {
  const { page } = studio;
  const text = await page.evaluate(async () => (await fetch('/scenario')).text());
  expect(JSON.parse(text).groups[0].colour === '#05536d', 'the file has the colour');
  const folder = mkdtempSync(join(tmpdir(), 'muster-colour-'));
  const plain = JSON.parse(text);
  delete plain.groups[0].colour;
  const hashes = [text, text, JSON.stringify(plain)].map((content, i) => {
    const file = join(folder, `${i}.json`);
    writeFileSync(file, content);
    const { status, stdout, stderr } = runProgram('play', file, '--seconds', '2', '--json');
    expect(status === 0, `the command line plays it: ${stderr}`);
    return JSON.parse(stdout).hash;
  });
  expect(hashes[0] === hashes[1] && hashes[0] !== hashes[2], `the colour is state: ${hashes.join(', ')}`);
  await opensWithIt(page, join(folder, '0.json'));
  console.log(`measured: a place with a chosen colour plays to ${hashes[0]}`);
}

/** Another studio that begins with the saved file. */
async function opensWithIt(page, scenario) {
  const own = await startStudio({ scenario, port: kPort + 300 });
  const studio = await StudioPage.open(page.context().browser(), own.url, { touch: false });
  try {
    await studio.eventually(async () => expect((await drawn(studio))[0] === 0x05536d, 'people have it at once'));
    const mark = studio.page.locator('.groups .chip svg').first();
    const colour = await mark.evaluate((one) => getComputedStyle(one).color);
    expect(colour === 'rgb(5, 83, 109)', `and the chip: ${colour}`);
    expect(studio.errors.length === 0, studio.errors.join());
  } finally {
    await studio.close();
    await own.stop();
  }
}

export async function byTouch(studio) {
  const row = await chooseGroup(studio, true);
  for (const one of await row.getByRole('radio').all()) {
    const box = await one.boundingBox();
    expect(box.width >= 44 && box.height >= 44, `a swatch for fingers: ${box.width} x ${box.height}`);
  }
  await row.getByRole('radio', { name: 'Violet' }).tap();
  await scene(studio, 'violet', (one) => chosenIn(one) === '#440e93');
  await studio.eventually(async () => expect((await checked(row)) === 'Violet', 'marked'));
  expect((await groupsOf(studio))[0] === '#440e93', 'the place has it');
  await row.scrollIntoViewIfNeeded();
  await studio.shot('group-colour-touch');
  await row.getByRole('radio', { name: /Automatic/ }).tap();
  await scene(studio, 'automatic again', (one) => chosenIn(one) === '');
  await studio.page.getByRole('button', { name: 'Undo colour' }).tap();
  await scene(studio, 'one step back', (one) => chosenIn(one) === '#440e93');
  await serious(studio, 'colour of a group by touch');
}
