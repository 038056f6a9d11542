// Everything that fingers do, with one mouse and a keyboard.
import { expect, expectBetween } from '../support/expect.mjs';
import { distance, extreme, mean, points, shifted } from '../support/geometry.mjs';

const vertices = (frame) => points(frame.groups[0].vertices);
const controls = (frame) => frame.groups[0].controls;

async function drag(studio, from, to, key) {
  const [a, b] = await studio.screen([from, to]);
  const { mouse, keyboard } = studio.page;
  await mouse.move(a.x, a.y);
  if (key) await keyboard.down(key);
  await mouse.down();
  await mouse.move(b.x, b.y, { steps: 12 });
  await mouse.up();
  if (key) await keyboard.up(key);
}

export async function mousePoint(studio) {
  const corner = extreme(vertices(await studio.frame()), 1, 0);
  const target = shifted(corner, 4, 1);
  await drag(studio, corner, target);
  await studio.until(
    'the mesh to follow',
    ([x, y]) => {
      const v = globalThis.__muster.frame.groups[0].vertices;
      return Array.from({ length: v.length / 2 }, (_, i) => Math.hypot(v[2 * i] - x, v[2 * i + 1] - y)).some(
        (d) => d < 0.8,
      );
    },
    [target.x, target.y],
    30000,
  );
  await studio.shot('mouse-point');
}

export async function mouseLine(studio) {
  const list = vertices(await studio.frame());
  const ends = [extreme(list, 1, 1), extreme(list, 1, -1)];
  await drag(studio, ends[0], ends[1], 'Shift');
  await studio.until('a line', () => globalThis.__muster.frame.groups[0].controls.some((one) => one.kind === 1));
  const [line] = controls(await studio.frame());
  await drag(studio, line.points[0], shifted(line.points[0], 3, 1));
  await studio.until(
    'its end to move',
    ([x, y]) => {
      const p = globalThis.__muster.frame.groups[0].controls[0]?.points[0];
      return p && Math.hypot(p.x - x, p.y - y) > 2;
    },
    [line.points[0].x, line.points[0].y],
    30000,
  );
  const still = controls(await studio.frame())[0].points[1];
  expect(distance(still, line.points[1]) < 0.8, 'the other end stays');
  await studio.shot('mouse-line');
  const bar = mean(controls(await studio.frame())[0].points);
  await drag(studio, bar, shifted(bar, 2, 0));
  await studio.until(
    'both ends to move',
    ([x]) => globalThis.__muster.frame.groups[0].controls[0]?.points[1].x > x + 1,
    [still.x],
    30000,
  );
  await studio.page.keyboard.press('p');
  await studio.until('the pin', () => globalThis.__muster.frame.groups[0].controls[0]?.pinned === true);
  await studio.page.keyboard.press('Delete');
  await studio.until('its removal', () => globalThis.__muster.frame.groups[0].controls.length === 0);
}

export async function mouseArea(studio) {
  const middle = mean(vertices(await studio.frame()));
  const loop = Array.from({ length: 24 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 24;
    return shifted(middle, 3 * Math.cos(angle), 3 * Math.sin(angle));
  });
  const places = await studio.screen(loop);
  const { mouse, keyboard } = studio.page;
  await mouse.move(places[0].x, places[0].y);
  await keyboard.down('Control');
  await mouse.down();
  for (const at of places) await mouse.move(at.x, at.y, { steps: 2 });
  await mouse.up();
  await keyboard.up('Control');
  await studio.until('an area', () => globalThis.__muster.frame.groups[0].controls.some((one) => one.kind === 2));
  const area = controls(await studio.frame())[0];
  expectBetween(area.points.length, 3, 6, 'corners of the area');
  await drag(studio, middle, shifted(middle, 4, 0));
  await studio.until(
    'the mesh to be carried',
    (x) => {
      const v = globalThis.__muster.frame.groups[0].vertices;
      return v.reduce((s, one, i) => (i % 2 ? s : s + one), 0) / (v.length / 2) > x + 2.5;
    },
    middle.x,
    30000,
  );
  await studio.shot('mouse-area');
  await studio.page.keyboard.press('Escape');
  await studio.until('the end of it', () => globalThis.__muster.frame.groups[0].controls.length === 0);
}

/** P and Delete mean what the mouse has in hand, also where a pinned point lies where the drag began; Escape ends all. */
export async function keysWhileDragging(studio) {
  const list = vertices(await studio.frame());
  const [pinned, dragged] = [extreme(list, -1, 0), extreme(list, 1, 0)];
  const [first, from, to] = await studio.screen([pinned, dragged, shifted(dragged, 4, 1)]);
  const { mouse, keyboard } = studio.page;
  await mouse.dblclick(first.x, first.y);
  await studio.until('a pinned point', () => globalThis.__muster.frame.groups[0].controls.some((one) => one.pinned));
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(to.x, to.y, { steps: 8 });
  await studio.until('the second control', () => globalThis.__muster.frame.groups[0].controls.length === 2);
  await keyboard.press('p');
  await studio.until('both pinned', () => globalThis.__muster.frame.groups[0].controls.every((one) => one.pinned));
  await studio.shot('mouse-keys');
  await keyboard.press('Delete');
  await studio.until('its removal', () => globalThis.__muster.frame.groups[0].controls.length === 1);
  const [left] = controls(await studio.frame());
  expect(distance(left.points[0], pinned) < 1, 'the other one stays');
  await mouse.up();
  await keyboard.press('Escape');
  await studio.until('the end of all', () => globalThis.__muster.frame.groups[0].controls.length === 0);
}

export async function mousePin(studio) {
  const corner = extreme(vertices(await studio.frame()), 1, 0);
  const [at] = await studio.screen([corner]);
  await studio.page.mouse.dblclick(at.x, at.y);
  await studio.until('a pinned point', () =>
    globalThis.__muster.frame.groups[0].controls.some((one) => one.pinned && one.kind === 0),
  );
  await studio.shot('mouse-pin');
  await studio.page.mouse.dblclick(at.x, at.y);
  await studio.until('the pin to go', () => globalThis.__muster.frame.groups[0].controls.length === 0);
}

export async function mouseCamera(studio) {
  const look = () =>
    studio.page.evaluate(() => {
      const { view } = globalThis.__muster;
      return { zoom: view.pixelsPerMetre(), ...view.worldToScreen({ x: 0, y: 0 }) };
    });
  const { mouse } = studio.page;
  const { width, height } = studio.page.viewportSize();
  const before = await look();
  await mouse.move(width / 2, height / 2);
  await mouse.wheel(0, -400);
  await studio.cameraAtRest();
  const near = await look();
  expect(near.zoom > 1.3 * before.zoom, `the wheel zooms: ${near.zoom} from ${before.zoom}`);
  const { keyboard } = studio.page;
  await keyboard.down('Space');
  await mouse.down();
  await mouse.move(width / 2 + 120, height / 2, { steps: 4 });
  await mouse.up();
  await keyboard.up('Space');
  await studio.cameraAtRest();
  expect((await look()).x > near.x + 60, 'Space pans');
  const turn = () => studio.page.evaluate(() => globalThis.__muster.view.camera.pose.turn);
  const facing = await turn();
  await mouse.down({ button: 'middle' });
  await mouse.move(width / 2 + 220, height / 2, { steps: 4 });
  await mouse.up({ button: 'middle' });
  await studio.cameraAtRest();
  expect(Math.abs((await turn()) - facing) > 0.1, 'the middle button turns');
  await studio.shot('mouse-camera');
  expect(controls(await studio.frame()).length === 0, 'the camera makes no control');
}

export async function keyboardOnly(studio) {
  const { keyboard, page } = { keyboard: studio.page.keyboard, page: studio.page };
  await page.locator('#scene').focus();
  const start = mean(vertices(await studio.frame()));
  await keyboard.press('Enter');
  await studio.until('the area in hand', () =>
    globalThis.__muster.frame.groups[0].controls.some((one) => one.kind === 2),
  );
  for (let i = 0; i < 10; ++i) await keyboard.press('ArrowRight');
  await studio.until(
    'the mesh to move',
    ([x, y]) => {
      const v = globalThis.__muster.frame.groups[0].vertices;
      let sx = 0;
      let sy = 0;
      for (let i = 0; i < v.length; i += 2) [sx, sy] = [sx + v[i], sy + v[i + 1]];
      return Math.hypot(sx / (v.length / 2) - x, sy / (v.length / 2) - y) > 3;
    },
    [start.x, start.y],
    30000,
  );
  await keyboard.press('Enter');
  await studio.shot('keyboard');
  await keyboard.press('4');
  await studio.until(
    'the wedge',
    () => document.querySelector('.formation[aria-pressed="true"] .label')?.textContent === 'Wedge',
  );
  await keyboard.press('Space');
  await studio.until('the pause', () => globalThis.__muster.frame.playing === false);
  await studio.wait(200);
  const { step } = await studio.frame();
  await keyboard.press('.');
  await studio.until('one step', (n) => globalThis.__muster.frame.step === n + 1, step);
  await keyboard.press('Space');
  await studio.until('the play', () => globalThis.__muster.frame.playing);
  await keyboard.press('h');
  await page.locator('dialog.help[open]').waitFor();
  await keyboard.press('Escape');
  await studio.until('the help to close', () => document.querySelector('dialog.help[open]') === null);
}
