// What <muster-player> says where it cannot play, and that it comes back.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from '../support/expect.mjs';
import { open, pictures, pixels, player, ready } from './player_pages.mjs';

/** The sentence in place of the picture. */
const said = (page) =>
  player(page, (one) => {
    const message = one.shadowRoot.querySelector('.message');
    return message.hidden ? '' : message.textContent;
  });

async function tells(page, src) {
  await page.evaluate((from) => {
    const one = document.querySelector('#a');
    globalThis.told = '';
    one.addEventListener('error', (event) => (globalThis.told = event.message), { once: true });
    one.setAttribute('src', from);
  }, src);
  await page.waitForFunction(() => globalThis.told !== '', null, { timeout: 10000 });
  const sentence = await said(page);
  expect(sentence === (await page.evaluate(() => globalThis.told)), `event and page say the same: ${sentence}`);
  expect(!(await page.getByRole('slider').first().isVisible()), 'without a picture there are no controls');
  return sentence;
}

/** Files that are missing, damaged, cut, newer, or something else. */
export async function files(page, host) {
  const good = readFileSync(join(host.folder, 'cars.muster-player'));
  const write = (name, change) => {
    const bytes = Buffer.from(good);
    writeFileSync(join(host.folder, name), change(bytes) ?? bytes);
  };
  write('flipped.muster-player', (bytes) => void (bytes[bytes.length >> 1] ^= 1));
  write('cut.muster-player', (bytes) => bytes.subarray(0, 9000));
  write('newer.muster-player', (bytes) => void bytes.writeUInt32LE(7, 8));
  await open(page, host);
  const expected = [
    ['none.muster-player', '“none.muster-player” cannot be loaded: the host answers 404 File not found.'],
    ['flipped.muster-player', '“flipped.muster-player” cannot be played: its checksum does not fit.'],
    ['cut.muster-player?x=1', `“cut.muster-player” cannot be played: found 9000 bytes, expected ${good.length}.`],
    [
      'newer.muster-player',
      '“newer.muster-player” cannot be played: found version 7, expected 2: a newer muster-player.js is needed.',
    ],
    ['plain.html', '“plain.html” cannot be played: this is no file of a Muster player.'],
    ['http://127.0.0.1:9/x.muster-player', '“x.muster-player” cannot be loaded: the host does not answer.'],
  ];
  for (const [src, sentence] of expected) {
    const found = await tells(page, src);
    expect(found === sentence, `${src}: ${found}`);
  }
  if (host.shots) await page.screenshot({ path: join(host.shots, 'trouble.png') });
  await page.evaluate(() => document.querySelector('#a').setAttribute('src', 'cars.muster-player'));
  await page.waitForFunction(() => document.querySelector('#a').duration > 0);
  await pictures(page);
  expect((await said(page)) === '', 'a good file plays after bad ones');
  expect((await pixels(page, () => false)).colours > 60, 'and is seen');
}

/** A browser without WebGL 2 says so. */
export async function noWebGl(page, host) {
  await page.addInitScript(() => {
    globalThis.HTMLCanvasElement.prototype.getContext = () => null;
  });
  await open(page, host);
  await page.waitForFunction(() => !document.querySelector('#a').shadowRoot.querySelector('.message').hidden);
  expect((await said(page)) === 'The crowd cannot be shown: this browser has no WebGL 2.', await said(page));
}

/** A graphics card that is reset gets everything again. */
export async function lostContext(page, host) {
  await open(page, host);
  await player(page, (one) => (one.currentTime = 5));
  await pictures(page);
  const before = (await pixels(page, () => false)).colours;
  await player(page, (one) => {
    const context = one.shadowRoot.querySelector('canvas').getContext('webgl2');
    globalThis.loser = context.getExtension('WEBGL_lose_context');
    globalThis.loser.loseContext();
  });
  await page.waitForTimeout(100);
  await player(page, (one) => (one.currentTime = 6));
  await page.evaluate(() => globalThis.loser.restoreContext());
  await page.waitForTimeout(300);
  await pictures(page);
  const after = (await pixels(page, () => false)).colours;
  expect(after > 0.7 * before, `the picture is there again: ${before} colours, then ${after}`);
  expect((await said(page)) === '', 'nothing is said');
}

/** Taken out of the page, put back, moved, given another file while the first still comes. */
export async function comings(page, host) {
  await open(page, host);
  await player(page, (one) => void ((one.currentTime = 3), one.play()));
  await page.evaluate(() => {
    const one = document.querySelector('#a');
    one.remove();
    document.querySelector('h1').after(one);
  });
  await page.waitForFunction(() => document.querySelector('#a').currentTime > 3.3);
  await page.evaluate(() => {
    const one = document.querySelector('#a');
    one.setAttribute('src', 'thousand.muster-player');
    one.setAttribute('src', 'cars.muster-player');
    one.play();
  });
  await page.waitForFunction(() => document.querySelector('#a').currentTime > 0.3);
  expect((await player(page, (one) => Math.round(one.duration))) === 10, 'the last file counts');
  await page.evaluate(() => {
    const one = document.createElement('muster-player');
    one.id = 'c';
    one.autoplay = true;
    one.setAttribute('src', 'cars.muster-player');
    document.querySelector('main').prepend(one);
  });
  await ready(page, '#c');
  expect((await pixels(page, () => false, '#c')).colours > 60, 'one that a script makes is seen');
}
