// Words, pictures, drawings and QR codes that are made of people: whether they can be read, and from where.
import jsQR from 'jsqr';
import { expect } from '../support/expect.mjs';
import { serious } from './look.mjs';

const dialog = (studio) => studio.page.locator('dialog.shape-dialog[open]');

async function openDialog(studio, name) {
  await studio.tab('formation');
  const tile = studio.page.locator(`.formation[data-opens="${name}"]`);
  await tile.scrollIntoViewIfNeeded();
  await tile.click();
  await dialog(studio).waitFor();
}

/** Adds the people that the open dialog asks for, and waits until they are there. */
async function addPeople(studio) {
  const button = dialog(studio).locator('.shape-more button');
  const more = Number(/\d+/.exec(await button.textContent())[0]);
  const wanted = more + (await studio.page.evaluate(() => globalThis.__muster.state.groups[0].count));
  await button.click();
  await studio.until('the people', (count) => globalThis.__muster.state.groups[0].count === count, wanted);
  return wanted;
}

/** Where the first group's places are on the screen. */
const onScreen = (studio) =>
  studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const { places } = frame.groups[0];
    return Array.from({ length: places.length / 2 }, (_, i) =>
      view.worldToScreen({ x: places[2 * i], y: places[2 * i + 1] }),
    );
  });

const box = (points) => {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return { left, right, top, bottom, width: right - left, height: bottom - top };
};

/** Everybody stands on a place. */
const stand = (studio, timeout) =>
  studio.until(
    'everybody in place',
    () => {
      const { x, y, groups } = globalThis.__muster.frame;
      const { places } = groups[0];
      const [people, spots] = [x.length, places.length / 2];
      let near = 0;
      for (let k = 0; k < spots; ++k)
        for (let i = 0; i < people; ++i)
          if (Math.hypot(x[i] - places[2 * k], y[i] - places[2 * k + 1]) < 0.25) {
            near += 1;
            break;
          }
      return near >= spots;
    },
    null,
    timeout,
  );

async function takeUp(studio) {
  await dialog(studio).locator('button[type="submit"]').click();
  await studio.until('the formation', () => globalThis.__muster.state.groups[0].formation === 'points');
}

/** A word for too few people says how many it needs, gets them, and then can be read. */
export async function wordForFew(studio) {
  await openDialog(studio, 'text');
  await dialog(studio).locator('input').fill('MUSTER');
  const note = dialog(studio).locator('.shape-note');
  await studio.eventually(async () =>
    expect(/^Hard to read: 49 people; \d+ needed\.$/.test(await note.textContent()), await note.textContent()),
  );
  await serious(studio, 'a word that is hard to read');
  await studio.shot('letters-few');
  const count = await addPeople(studio);
  await studio.eventually(async () =>
    expect((await note.textContent()) === `Can be read, with ${count} people.`, await note.textContent()),
  );
  await studio.shot('letters-enough');
  await takeUp(studio);
  await studio.eventually(async () => {
    const points = await onScreen(studio);
    expect(points.length === count, `${points.length} places for ${count} people`);
    const { width, height } = box(points);
    expect(width > 2 * height, `the word lies before the visitor: ${width.toFixed()} by ${height.toFixed()} px`);
  });
  // More shows it as it is seen, not as the world lies.
  await openDialog(studio, 'shape');
  await studio.wait(200);
  const ink = await dialog(studio)
    .locator('.shape-preview')
    .evaluate((canvas) => {
      const { data, width, height } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      let [left, right, top, bottom] = [width, 0, height, 0];
      for (let i = 0; i < width * height; ++i)
        if (data[4 * i + 3] > 100) {
          [left, right] = [Math.min(left, i % width), Math.max(right, i % width)];
          [top, bottom] = [Math.min(top, Math.floor(i / width)), Math.max(bottom, Math.floor(i / width))];
        }
      return { wide: right - left, high: bottom - top };
    });
  expect(ink.wide > 3 * ink.high, `More shows the word upright: ${JSON.stringify(ink)}`);
  await studio.shot('letters-more');
  await studio.page.keyboard.press('Escape');
  await studio.wait(6000);
  await studio.page.keyboard.press('f');
  await studio.cameraAtRest();
  await studio.shot('letters-word');
}

/** A triangle with its tip up stands with its tip away from the visitor, and lines round it are faint. */
export async function pictureUpright(studio) {
  const drawing = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" onload="parent.ran=1">
    <script>window.ran = 1</script><image href="http://127.0.0.1:9/x.png" width="9" height="9"/>
    <path d="M50 5L61.2 38.6L96.6 38.9L68.1 60L78.8 93.8L50 73.2L21.2 93.8L31.9 60L3.4 38.9L38.8 38.6Z" fill="#000"/></svg>`;
  await openDialog(studio, 'shape');
  const asked = [];
  studio.page.on('request', (request) => asked.push(request.url()));
  await dialog(studio)
    .locator('input[type="file"]')
    .setInputFiles({ name: 'star.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(drawing) });
  const note = dialog(studio).locator('.shape-note');
  await studio.eventually(async () => expect((await note.textContent()).includes('star.svg'), 'the drawing is read'));
  await studio.shot('letters-star-dialog');
  await takeUp(studio);
  const ran = await studio.page.evaluate(() => globalThis.ran === undefined);
  expect(ran, 'nothing in the drawing runs');
  expect(!asked.some((url) => url.includes(':9/')), 'and nothing is loaded');
  await studio.eventually(async () => {
    const points = await onScreen(studio);
    const { top, height, left, width } = box(points);
    const high = points.filter(({ y }) => y < top + 0.2 * height);
    const low = points.filter(({ y }) => y > top + 0.8 * height);
    expect(high.length > 0 && high.length < low.length, `one tip above, two below: ${high.length}, ${low.length}`);
    const middle = high.reduce((sum, { x }) => sum + x, 0) / high.length;
    expect(Math.abs(middle - left - width / 2) < 0.12 * width, 'the tip is in the middle');
  });
  await studio.wait(5000);
  await studio.page.keyboard.press('f');
  await studio.cameraAtRest();
  await studio.shot('letters-star');
  // Lines of the same drawing are stood along.
  await openDialog(studio, 'shape');
  const lines =
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50"><path d="M0 0H100V50H0Z" fill="none" stroke="#000"/></svg>';
  await dialog(studio)
    .locator('input[type="file"]')
    .setInputFiles({ name: 'frame.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(lines) });
  await studio.eventually(async () => expect((await note.textContent()).includes('frame.svg'), 'the lines are read'));
  const before = await studio.page.evaluate(() => [...globalThis.__muster.frame.groups[0].places].join());
  await takeUp(studio);
  await studio.until('the frame', (old) => [...globalThis.__muster.frame.groups[0].places].join() !== old, before);
  await studio.eventually(async () => {
    const points = await onScreen(studio);
    const { top, height, left, width } = box(points);
    const inside = points.filter(
      ({ x, y }) => Math.abs(x - left - width / 2) < 0.3 * width && Math.abs(y - top - height / 2) < 0.25 * height,
    );
    expect(inside.length === 0, `nobody stands inside the frame: ${inside.length}`);
  });
}

/** Places that nobody can get to are said in the dialog, and again where the formation is taken up all the same. */
export async function unreachableIsSaid(studio) {
  const words = /\d+ of 36 spots (cannot be reached|lie in obstacles)/;
  await openDialog(studio, 'shape');
  for (let i = 0; i < 10; ++i) await dialog(studio).locator('button', { hasText: 'Looser' }).click();
  await studio.eventually(async () =>
    expect(words.test(await dialog(studio).locator('.shape-ground').textContent()), 'the dialog says it'),
  );
  await takeUp(studio);
  await studio.eventually(async () =>
    expect(words.test(await studio.page.locator('.notice').textContent()), 'a notice says it afterwards'),
  );
}

/** What a phone reads in a picture of the screen, from far away, where its lens lets neighbours melt together. */
async function readCode(studio) {
  const picture = (await studio.page.screenshot()).toString('base64');
  for (const [scale, blur] of [
    [0.5, 2],
    [0.4, 2],
    [0.3, 1],
    [0.25, 1],
  ]) {
    const { grey, width, height } = await studio.page.evaluate(
      async ([source, share, far]) => {
        const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${source}`)).blob());
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [Math.round(image.width * share), Math.round(image.height * share)];
        const pen = canvas.getContext('2d');
        pen.imageSmoothingQuality = 'high';
        pen.filter = `blur(${far}px)`;
        pen.drawImage(image, 0, 0, canvas.width, canvas.height);
        const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
        let text = '';
        for (let i = 0; i < data.length; i += 4)
          text += String.fromCharCode(Math.round(0.3 * data[i] + 0.59 * data[i + 1] + 0.11 * data[i + 2]));
        return { grey: globalThis.btoa(text), width: canvas.width, height: canvas.height };
      },
      [picture, scale, blur],
    );
    const pixels = Buffer.from(grey, 'base64').reduce(
      (all, one, i) => {
        all.set([one, one, one, 255], 4 * i);
        return all;
      },
      new Uint8ClampedArray(4 * width * height),
    );
    const found = jsQR(pixels, width, height)?.data;
    if (found) return found;
  }
  return null;
}

/** A code of 700 people is read from a picture of them, taken from above. */
export async function qrFromAbove(studio) {
  const address = 'https://example.org/meet';
  await openDialog(studio, 'shape');
  await dialog(studio).locator('button', { hasText: 'QR code' }).click();
  await dialog(studio).locator('input[inputmode="url"]').fill(address);
  const note = dialog(studio).locator('.shape-note');
  await studio.eventually(async () =>
    expect(/m wide/.test(await note.textContent()), `the size is said: ${await note.textContent()}`),
  );
  await serious(studio, 'dialog for codes');
  await studio.shot('letters-qr-dialog');
  await takeUp(studio);
  await studio.send({ type: 'SetSpeed', factor: 8 });
  await stand(studio, 90000);
  await studio.wait(1500);
  await studio.page.keyboard.press('f');
  await studio.page.keyboard.press('0');
  await studio.cameraAtRest();
  await studio.wait(500);
  await studio.shot('letters-qr');
  expect((await readCode(studio)) === address, 'a decoder reads the crowd from above');
}

export const kLetterCases = [
  [
    'letters: a word for few',
    wordForFew,
    ['desktop', 'portrait', 'phone'],
    { scenario: 'web/tests/scenarios/letters.json' },
  ],
  [
    'letters: a picture stands upright',
    pictureUpright,
    ['desktop', 'phone'],
    { scenario: 'web/tests/scenarios/letters.json' },
  ],
  ['letters: places out of reach', unreachableIsSaid, ['desktop'], { scenario: 'scenarios/block.json' }],
  [
    'letters: a code is read from above',
    qrFromAbove,
    ['wide', 'portrait'],
    { touch: false, scenario: 'web/tests/scenarios/code.json', release: true },
  ],
];
