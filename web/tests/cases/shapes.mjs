// Formations of a visitor's own: drawn, written, taken from a picture, changed and saved.
import { expect } from '../support/expect.mjs';
import { serious } from './look.mjs';

async function tap(studio, locator) {
  const box = await locator.boundingBox();
  await studio.fingers.down({ 1: { x: box.x + box.width / 2, y: box.y + box.height / 2 } });
  await studio.wait(40);
  await studio.fingers.up();
}

/** Draw: a finger draws a triangle round the group, which becomes its formation. */
export async function drawnFormation(studio) {
  const { page } = studio;
  const draw = page.locator('.formation', { hasText: 'Draw' });
  await draw.scrollIntoViewIfNeeded();
  await tap(studio, draw);
  await studio.eventually(async () =>
    expect((await draw.getAttribute('aria-pressed')) === 'true', 'the drawing tool is in hand'),
  );
  const corners = await page.evaluate(() => {
    const { view, frame } = globalThis.__muster;
    const { x, y } = frame.groups[0];
    return [0, 1, 2, 3].map((k) => {
      const a = (2 * Math.PI * k) / 3 + 0.7;
      return view.worldToScreen({ x: x + 6.5 * Math.cos(a), y: y + 6.5 * Math.sin(a) });
    });
  });
  await studio.fingers.down({ 1: corners[0] });
  for (const corner of corners.slice(1)) await studio.fingers.move({ 1: corner }, { steps: 14, ms: 280 });
  await studio.shot('drawing-an-outline');
  await studio.fingers.up();
  await studio.until('the drawn formation', () => globalThis.__muster.state.groups[0].formation === 'outline');
  expect((await draw.getAttribute('aria-pressed')) === 'true', 'Draw is shown as the formation');
  expect(await page.evaluate(() => globalThis.__muster.state.tool === 'steer'), 'and the tool is put away');
  await studio.wait(3500);
  await studio.shot('drawn-formation');
  // Each of three corners of the triangle has somebody near it, and nobody stands far outside.
  const found = await page.evaluate(() => {
    const { frame } = globalThis.__muster;
    const { x, y, places } = frame.groups[0];
    const reach = (a) => {
      let most = -Infinity;
      for (let i = 0; i + 1 < places.length; i += 2)
        most = Math.max(most, (places[i] - x) * Math.cos(a) + (places[i + 1] - y) * Math.sin(a));
      return most;
    };
    return [0, 1, 2, 3, 4, 5].map((k) => reach((Math.PI * k) / 3 + 0.7));
  });
  const [tips, sides] = [[0, 2, 4].map((k) => found[k]), [1, 3, 5].map((k) => found[k])];
  expect(Math.min(...tips) > 1.4 * Math.max(...sides), `a triangle, as drawn: ${found.map((one) => one.toFixed(1))}`);
}

/** A picture of the letter L in black, as a file. */
async function pictureOfL(page) {
  const text = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 120, height: 160 });
    const pen = canvas.getContext('2d');
    pen.fillStyle = 'white';
    pen.fillRect(0, 0, 120, 160);
    pen.fillStyle = 'black';
    pen.fillRect(10, 10, 30, 140);
    pen.fillRect(10, 120, 100, 30);
    return canvas.toDataURL('image/png').split(',')[1];
  });
  return { name: 'letter-l.png', mimeType: 'image/png', buffer: Buffer.from(text, 'base64') };
}

/** Of the first group's places as the visitor sees them: the share in the quarter above on the left, and above on the right. */
const quarters = (page) =>
  page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const { x, y, places } = frame.groups[0];
    const up = view.camera.pose.turn + Math.PI / 2;
    const [c, s] = [Math.cos(up), Math.sin(up)];
    const own = [];
    for (let i = 0; i + 1 < places.length; i += 2) {
      const [dx, dy] = [places[i] - x, places[i + 1] - y];
      own.push([c * dx + s * dy, c * dy - s * dx]);
    }
    const middle = (k) => (Math.min(...own.map((p) => p[k])) + Math.max(...own.map((p) => p[k]))) / 2;
    const [front, side] = [middle(0) + 0.5, middle(1)];
    const share = (test) => own.filter(test).length / own.length;
    return {
      left: share((p) => p[0] > front && p[1] > side),
      right: share((p) => p[0] > front && p[1] < side),
    };
  });

/** More: a picture becomes a formation, is mirrored, saved with a name, and comes back after a reload; bad files are told. */
export async function ownShape(studio, server) {
  const { page } = studio;
  const dialog = page.locator('dialog.shape-dialog[open]');
  const open = async () => {
    const more = page.locator('.formation', { hasText: 'More' });
    await more.scrollIntoViewIfNeeded();
    await tap(studio, more);
    await dialog.waitFor();
  };
  await open();
  await dialog
    .locator('input[type="file"]')
    .setInputFiles({ name: 'x.png', mimeType: 'image/png', buffer: Buffer.from('no') });
  await studio.eventually(async () =>
    expect(
      (await dialog.locator('.shape-note').textContent()).includes('“x.png” is no picture'),
      'a bad file is told of',
    ),
  );
  await dialog.locator('input[type="file"]').setInputFiles(await pictureOfL(page));
  await studio.eventually(async () =>
    expect((await dialog.locator('.shape-note').textContent()).includes('letter-l.png'), 'the picture is taken'),
  );
  await studio.wait(200);
  await serious(studio, 'dialog for shapes');
  await studio.shot('shape-dialog');
  await dialog.locator('button', { hasText: 'Save' }).click();
  await studio.eventually(async () =>
    expect((await dialog.locator('.shape-saved li').count()) === 1, 'the formation is saved'),
  );
  await dialog.locator('button', { hasText: 'Use it' }).click();
  await studio.until('the picture as formation', () => globalThis.__muster.state.groups[0].formation === 'points');
  await studio.wait(600);
  const plain = await quarters(page);
  expect(
    plain.left > 0.2 && plain.right < 0.05,
    `an L: its upright stands on the left, as it is drawn: ${JSON.stringify(plain)}`,
  );
  await open();
  await dialog.locator('button', { hasText: 'Mirror' }).click();
  await dialog.locator('button', { hasText: 'Use it' }).click();
  await studio.eventually(async () => {
    const turned = await quarters(page);
    expect(turned.right > 0.2 && turned.left < 0.05, `mirrored: ${JSON.stringify(turned)}`);
  });
  await studio.wait(3000);
  await studio.shot('picture-formation');
  await page.goto(server.url);
  await studio.until('the page again', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
  await open();
  await dialog.locator('.shape-saved-take', { hasText: 'letter-l' }).click();
  await dialog.locator('button', { hasText: 'Use it' }).click();
  await studio.eventually(async () => {
    const again = await quarters(page);
    expect(again.left > 0.2 && again.right < 0.05, `as it was saved: ${JSON.stringify(again)}`);
  });
}

/** Text: words become places. */
export async function writtenFormation(studio) {
  const { page } = studio;
  const text = page.locator('.formation', { hasText: 'Text' });
  await text.scrollIntoViewIfNeeded();
  await text.click();
  const dialog = page.locator('dialog.shape-dialog[open]');
  await dialog.locator('input').fill('HI');
  await studio.wait(200);
  await serious(studio, 'dialog for words');
  await studio.shot('words-dialog');
  await dialog.locator('button[type="submit"]').click();
  await studio.until('the written formation', () => globalThis.__muster.state.groups[0].formation === 'points');
  await studio.wait(5000);
  await page.keyboard.press('f');
  await studio.cameraAtRest();
  await studio.shot('written-formation');
  await studio.eventually(async () => {
    const words = await page.evaluate(() => {
      const { frame, view } = globalThis.__muster;
      const { places } = frame.groups[0];
      const at = Array.from({ length: places.length / 2 }, (_, i) =>
        view.worldToScreen({ x: places[2 * i], y: places[2 * i + 1] }),
      );
      const xs = at.map((p) => p.x).sort((a, b) => a - b);
      const ys = at.map((p) => p.y);
      return { wide: xs[xs.length - 1] - xs[0], high: Math.max(...ys) - Math.min(...ys), count: at.length };
    });
    expect(words.wide > words.high * 0.9, `HI reads from the left to the right: ${JSON.stringify(words)}`);
  });
  // Nothing is left that does nothing.
  const dead = await page.evaluate(() =>
    [...document.querySelectorAll('#ui button')]
      .filter((node) => /soon/.test(node.dataset.tip ?? ''))
      .map((node) => node.ariaLabel ?? node.textContent),
  );
  expect(dead.length === 0, `dead controls: ${dead.join(', ')}`);
}
