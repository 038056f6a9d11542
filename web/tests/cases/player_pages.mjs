// <muster-player> in pages: plays, is steered by mouse, keys and fingers, and leaves the page its own.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { expect, expectBetween } from '../support/expect.mjs';
import { Fingers } from '../support/fingers.mjs';

const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** A page that knows nothing but the player. */
export const kPlain = `<!doctype html>
<html lang="en"><head><meta charset="utf-8" /><meta name="viewport" content="width=device-width, initial-scale=1" />
<title>A plain page</title><style>body { font: 17px/1.5 Georgia, serif; max-width: 860px; margin: 24px auto; padding: 0 16px }</style>
<script type="module" src="muster-player.js"></script></head>
<body><main><h1>A plain page</h1><p>A hundred people on a market square.</p>
<muster-player id="a" src="market.muster-player" controls></muster-player>
<p style="margin-bottom: 1200px">What follows is far below.</p>
<muster-player id="b" src="course.muster-player" controls camera="follow" loop></muster-player>
</main></body></html>`;

export async function open(page, host, address = 'plain.html') {
  await page.goto(new URL(address, host.url).href);
  await ready(page);
}

/** Waits until a player has its file, or says why not. */
export async function ready(page, id = 'muster-player') {
  await page.waitForFunction(
    (selector) => {
      const player = document.querySelector(selector);
      return player.duration > 0 || player.shadowRoot?.querySelector('.message').hidden === false;
    },
    id,
    { timeout: 20000 },
  );
  await pictures(page);
}

export const pictures = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))),
  );

/** Reads or does something with a player. */
export const player = (page, work, more = null, id = 'muster-player') =>
  page.evaluate(
    ([selector, body, value]) =>
      new Function('player', 'value', `return (${body})(player, value)`)(document.querySelector(selector), value),
    [id, work.toString(), more],
  );

const shot = async (page, host, name) => {
  if (host.shots) await page.screenshot({ path: join(host.shots, `${name}.png`) });
};

/** Counts pixels of a player's picture: those that `test` finds, and how many colours there are. */
export async function pixels(page, test, id = 'muster-player') {
  const bytes = await page.locator(id).first().screenshot();
  return page.evaluate(
    async ([base64, body]) => {
      const blob = await (await fetch(`data:image/png;base64,${base64}`)).blob();
      const bitmap = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      const fits = new Function('r', 'g', 'b', `return (${body})(r, g, b)`);
      const colours = new Set();
      let found = 0;
      for (let k = 0; k < data.length; k += 4) {
        colours.add((data[k] >> 3) * 1024 + (data[k + 1] >> 3) * 32 + (data[k + 2] >> 3));
        if (fits(data[k], data[k + 1], data[k + 2])) ++found;
      }
      return { found, colours: colours.size, width: bitmap.width, height: bitmap.height };
    },
    [bytes.toString('base64'), test.toString()],
  );
}

const isBlue = (r, g, b) => b > 90 && b > 1.6 * r && b > 1.25 * g;

/** It loads, plays, tells of it in the words of media elements, and ends. */
export async function plainPage(page, host) {
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.addInitScript(() => {
    globalThis.heard = [];
    for (const name of ['loadedmetadata', 'play', 'pause', 'ended', 'error'])
      document.addEventListener(name, (event) => globalThis.heard.push(`${event.target.id} ${name}`), true);
  });
  await open(page, host);
  await shot(page, host, 'plain-start');
  expect(
    asked.every((url) => url.startsWith(host.url)),
    `nothing comes from elsewhere: ${asked}`,
  );
  expect(!asked.some((url) => url.includes('course')), 'who is far below loads later');
  const facts = await player(page, (one) => [one.duration, one.paused, one.currentTime, one.crowdTitle]);
  expect(facts.join() === '20,true,0,Market square', `length, pause, time, title: ${facts}`);
  await page.getByRole('button', { name: 'Play' }).first().click();
  await page.waitForFunction(() => document.querySelector('#a').currentTime > 1);
  await shot(page, host, 'plain-playing');
  await page.keyboard.press('k');
  await player(page, (one) => (one.currentTime = 19.9));
  await player(page, (one) => one.play());
  await page.waitForFunction(() => document.querySelector('#a').ended);
  const heard = (await page.evaluate(() => globalThis.heard)).join('; ');
  expect(heard === 'a loadedmetadata; a play; a pause; a play; a pause; a ended', heard);
  expect((await player(page, (one) => one.currentTime)) === 20, 'it stays at the end');
  await page.evaluate(axeSource);
  const bad = await page.evaluate(async () =>
    (await globalThis.axe.run(document)).violations.map((one) => `${one.id}: ${one.nodes[0].html}`),
  );
  expect(bad.length === 0, `axe finds ${bad.join('; ')}`);
}

/** Where people are by the file there are shirts in the picture, and nowhere else. */
export async function people(page, host) {
  await open(page, host);
  for (const time of [0, 7.5, 16]) {
    await player(page, (one, at) => (one.currentTime = at), time);
    await pictures(page);
    const heads = await player(page, (one) => one.charactersAt(one.currentTime).map(({ screen }) => screen));
    expect(heads.length === 100, `a hundred people: ${heads.length}`);
    const box = await page.locator('muster-player').first().boundingBox();
    const bytes = await page.locator('muster-player').first().screenshot();
    const dark = await page.evaluate(
      async ([base64, places]) => {
        const blob = await (await fetch(`data:image/png;base64,${base64}`)).blob();
        const bitmap = await createImageBitmap(blob);
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const context = canvas.getContext('2d');
        context.drawImage(bitmap, 0, 0);
        // A head with dark or fair hair stands out from pale ground within three pixels of its place.
        return places.filter(({ x, y }) => {
          const { data } = context.getImageData(Math.round(x) - 3, Math.round(y) - 3, 7, 7);
          for (let k = 0; k < data.length; k += 4) if (data[k] + data[k + 1] + data[k + 2] < 420) return true;
          return false;
        }).length;
      },
      [bytes.toString('base64'), heads],
    );
    const inside = heads.filter(({ x, y }) => x > 0 && y > 0 && x < box.width && y < box.height - 60).length;
    expect(inside >= 99, `all are in view, above the controls: ${inside}`);
    expect(dark >= 97, `heads are where they should be at ${time} s: ${dark}`);
  }
  const { found } = await pixels(page, isBlue);
  expectBetween(found, 800, 40000, 'pixels of blue shirts');
}

/** Each of two plays by itself; who is out of sight rests and goes on. */
export async function twoPlayers(page, host) {
  await open(page, host);
  await player(page, (one) => one.play());
  await page.locator('#b').scrollIntoViewIfNeeded();
  await ready(page, '#b');
  const frozen = await player(page, (one) => one.currentTime, null, '#a');
  await player(page, (one) => void ((one.currentTime = 33), one.play()), null, '#b');
  await page.waitForFunction(() => document.querySelector('#b').currentTime > 33.5);
  await shot(page, host, 'two-b');
  const still = await player(page, (one) => one.currentTime, null, '#a');
  expect(Math.abs(still - frozen) < 0.3, `the first rests while nobody sees it: ${frozen} to ${still} s`);
  await page.locator('#a').scrollIntoViewIfNeeded();
  await page.waitForFunction((time) => document.querySelector('#a').currentTime > time + 0.4, still);
  const { colours } = await pixels(page, () => false, '#a');
  expect(colours > 200, `its picture is there again: ${colours} colours`);
}

/** More players than a browser has contexts of WebGL: whoever is in view has a picture. */
export async function manyPlayers(page, host) {
  await page.goto(host.url + 'plain.html');
  await page.evaluate(() => {
    const one = '<muster-player src="cars.muster-player" style="margin-bottom: 500px"></muster-player>';
    document.querySelector('main').innerHTML = one.repeat(22);
  });
  const all = page.locator('muster-player');
  for (const k of [0, 5, 10, 15, 21, 0]) {
    await all.nth(k).scrollIntoViewIfNeeded();
    await page.waitForFunction((n) => document.querySelectorAll('muster-player')[n].duration > 0, k);
    await pictures(page);
    const shown = await player(
      page,
      (one) => one.shadowRoot.querySelector('canvas').width,
      null,
      `muster-player:nth-of-type(${k + 1})`,
    );
    expect(shown > 300, `player ${k} has a picture of ${shown} px`);
    const { colours } = await pixels(page, () => false, `muster-player:nth-of-type(${k + 1})`);
    expect(colours > 60, `player ${k} shows something: ${colours} colours`);
  }
}

const view = (page) => player(page, (one) => one.charactersAt(0)[0].screen);
const moved = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

/** The view once it has moved so far; inputs take a while to arrive. */
async function viewBeyond(page, before, least, what) {
  for (let tries = 0; tries < 40; ++tries) {
    const now = await view(page);
    if (moved(before, now) > least) return now;
    await page.waitForTimeout(50);
  }
  throw new Error(`${what}: the view stays`);
}

/** A mouse turns the view, the wheel is the page's but with Ctrl, and keys do all of it. */
export async function mouseAndKeys(page, host) {
  await open(page, host);
  const before = await view(page);
  const box = await page.locator('#a').boundingBox();
  await page.mouse.move(box.x + 300, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 420, box.y + 200, { steps: 5 });
  await page.mouse.up();
  await pictures(page);
  const turned = await view(page);
  expect(moved(before, turned) > 20, `a drag turns the view: ${moved(before, turned)} px`);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => globalThis.scrollY > 60);
  await pictures(page);
  expect(moved(turned, await view(page)) < 1, 'the wheel scrolls the page and leaves the view');
  await page.evaluate(() => globalThis.scrollTo(0, 0));
  // The browser gives turns of the wheel that follow each other to the same scroller.
  await page.waitForTimeout(700);
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, -240);
  await viewBeyond(page, turned, 20, 'Ctrl and the wheel zoom');
  await page.keyboard.up('Control');
  expect((await page.evaluate(() => globalThis.scrollY)) === 0, 'and the page stays');
  await player(page, (one) => one.shadowRoot.querySelector('.view').focus());
  await page.keyboard.press('0');
  await pictures(page);
  expect(moved(before, await view(page)) < 1, '0 shows the view of the beginning');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('+');
  await pictures(page);
  expect(moved(before, await view(page)) > 10, 'arrows turn');
  await page.keyboard.press(' ');
  expect(!(await player(page, (one) => one.paused)), 'Space plays');
  await page.keyboard.press(' ');
  await page.getByRole('slider', { name: 'Time' }).first().focus();
  const time = await player(page, (one) => one.currentTime);
  for (let k = 0; k < 50; ++k) await page.keyboard.press('ArrowRight');
  const later = await player(page, (one) => one.currentTime);
  expectBetween(later - time, 0.9, 1.1, 'fifty steps of the bar are a second');
  await page.keyboard.press('End');
  expect((await player(page, (one) => one.currentTime)) === 20, 'End is the end');
}

/** Fingers: the page scrolls, a finger across turns the view, two zoom, the bar is scrubbed, the button plays. */
export async function touch(page, host) {
  await open(page, host);
  await shot(page, host, 'phone');
  const start = await page.getByRole('button', { name: 'Play' }).first().boundingBox();
  await page.touchscreen.tap(start.x + start.width / 2, start.y + start.height / 2);
  await page.waitForFunction(() => !document.querySelector('#a').paused);
  await page.getByRole('button', { name: 'Pause' }).tap();
  await pictures(page);
  const fingers = new Fingers(await page.context().newCDPSession(page));
  const box = await page.locator('#a').boundingBox();
  const at = (x, y) => ({ x: box.x + x * box.width, y: box.y + y * box.height });
  const before = await view(page);
  await fingers.down({ 1: at(0.3, 0.4) });
  await fingers.move({ 1: at(0.6, 0.41) });
  await fingers.up();
  await pictures(page);
  const turned = await view(page);
  expect(moved(before, turned) > 10, `a finger across turns the view: ${moved(before, turned)} px`);
  await fingers.down({ 1: at(0.3, 0.4), 2: at(0.6, 0.4) });
  await fingers.move({ 1: at(0.15, 0.4), 2: at(0.75, 0.4) });
  await fingers.up();
  await viewBeyond(page, turned, 10, 'two fingers zoom');
  await pictures(page);
  const near = await view(page);
  await fingers.down({ 1: at(0.5, 0.5) });
  await fingers.move({ 1: { x: at(0.5, 0).x, y: box.y - 120 } }, { steps: 10, ms: 300 });
  await fingers.up();
  await page.waitForFunction(() => globalThis.scrollY > 40, null, { timeout: 3000 });
  await pictures(page);
  expect(moved(near, await view(page)) < 1, 'a finger that goes up scrolls the page and leaves the view');
  await page.evaluate(() => globalThis.scrollTo(0, 0));
  await page.waitForTimeout(300);
  const bar = await page.getByRole('slider', { name: 'Time' }).first().boundingBox();
  const place = (share) => ({ x: bar.x + 8 + share * (bar.width - 16), y: bar.y + bar.height / 2 });
  await fingers.down({ 1: place(0.02) });
  await fingers.move({ 1: place(0.6) });
  await fingers.up();
  const time = await player(page, (one) => one.currentTime);
  expectBetween(time, 10.5, 13.5, 'the bar is scrubbed by a finger');
  await shot(page, host, 'phone-scrubbed');
  const button = await page.getByRole('button', { name: 'Play' }).last().boundingBox();
  expect(button.width >= 44 && button.height >= 44, `buttons are as large as fingers: ${button.width}`);
  await page.touchscreen.tap(button.x + 20, button.y + 20);
  await page.waitForFunction((from) => document.querySelector('#a').currentTime > from + 0.3, time);
}

/** Autoplay, loop, speed, fixed camera, theme, another source, style. */
export async function attributes(page, host) {
  await page.goto(host.url + 'plain.html');
  await page.evaluate(() => {
    document.querySelector('main').innerHTML =
      '<muster-player autoplay loop speed="4" camera="fixed" src="cars.muster-player" style="--muster-accent: #0a0; height: 300px"></muster-player>';
  });
  await ready(page);
  await page.waitForFunction(() => document.querySelector('muster-player').currentTime > 3);
  const began = await player(page, (one) => one.currentTime);
  await page.waitForFunction((from) => document.querySelector('muster-player').currentTime < from, began, {
    timeout: 15000,
  });
  expect(!(await player(page, (one) => one.paused)), 'it goes round');
  expect(!(await page.getByRole('slider').isVisible()), 'without `controls` there are none');
  const before = await view(page);
  const box = await page.locator('muster-player').boundingBox();
  expect(Math.round(box.height) === 300, 'it has the size that the page gives it');
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y + 100, { steps: 3 });
  await page.mouse.up();
  expect(moved(before, await view(page)) < 1, 'a fixed camera stays');
  await player(page, (one) => {
    one.setAttribute('theme', 'dark');
    one.setAttribute('controls', '');
    one.removeAttribute('camera');
    one.pause();
  });
  await pictures(page);
  const { found, width, height } = await pixels(page, (r, g, b) => r + g + b < 200);
  expect(found > 0.5 * width * height, 'the dark theme is dark');
  expect(await page.getByRole('slider').isVisible(), 'controls come with their attribute');
  await page.setViewportSize({ width: 640, height: 500 });
  await pictures(page);
  const canvas = await player(page, (one) => [one.shadowRoot.querySelector('canvas').width, one.clientWidth]);
  expect(canvas[0] === canvas[1], `the picture has the new size: ${canvas}`);
  await player(page, (one) => one.setAttribute('src', 'market.muster-player'));
  await page.waitForFunction(() => document.querySelector('muster-player').crowdTitle === 'Market square');
  expect((await player(page, (one) => one.duration)) === 20, 'another file is another length');
}

/** Follows the page's colours where no theme is asked for. */
export async function dark(page, host) {
  await open(page, host);
  await player(page, (one) => (one.currentTime = 14));
  await pictures(page);
  const { found, width, height } = await pixels(page, (r, g, b) => r + g + b < 200);
  expect(found > 0.6 * width * height, 'the picture is dark');
  await shot(page, host, 'dark');
  await page.emulateMedia({ colorScheme: 'light' });
  await pictures(page);
  const light = await pixels(page, (r, g, b) => r + g + b < 200);
  expect(light.found < 0.3 * width * height, 'and light when the page is');
}

/** One HTML file plays without a server, and asks for nothing. */
export async function fromDisk(page, host) {
  const asked = [];
  page.on('request', (request) => {
    if (!request.url().startsWith('data:')) asked.push(request.url());
  });
  await page.goto(`file://${join(host.folder, 'market.html')}`);
  await ready(page);
  expect((await page.title()) === 'Market square', 'it has the title of the take');
  await page.getByRole('button', { name: 'Play' }).first().click();
  await page.waitForFunction(() => document.querySelector('muster-player').currentTime > 0.5);
  expect((await pixels(page, isBlue)).found > 500, 'people are there');
  expect(asked.length === 1, `it asks for itself only: ${asked}`);
  await shot(page, host, 'from-disk');
}

/** The folder that `player-folder` writes works on any web host. */
export async function folder(page, host) {
  await open(page, host, 'talk/');
  await player(page, (one) => one.play());
  await page.waitForFunction(() => document.querySelector('muster-player').currentTime > 0.5);
  expect((await pixels(page, isBlue)).found > 500, 'people are there');
  await shot(page, host, 'folder-phone');
}

/** Who wants little motion gets none unasked. */
export async function reducedMotion(page, host) {
  await page.goto(host.url + 'plain.html');
  await page.evaluate(() => document.querySelector('#a').setAttribute('autoplay', ''));
  await page.evaluate(() => document.querySelector('#a').setAttribute('src', 'cars.muster-player'));
  await ready(page);
  await page.waitForTimeout(400);
  expect(await player(page, (one) => one.paused && one.currentTime === 0), 'nothing moves by itself');
}
