// What a new user stumbled over: the first visit, dead controls, marks, small screens, a palm, a restart.
import { gzipSync } from 'node:zlib';
import { expect, expectBetween } from '../support/expect.mjs';
import { layout, serious } from './look.mjs';

const kFirstLoad = 350_000;

/** Each thing that is done is ticked; when all are, the hint goes. */
export async function hintTicks(studio) {
  const { page } = studio;
  const hint = page.locator('.hint');
  const ticked = () => hint.locator('.hint-item.done').count();
  expect((await ticked()) === 0, 'nothing is done yet');
  const widthOf = () => hint.evaluate((node) => node.offsetWidth);
  const width = await widthOf();
  const box = await page.locator('#scene').boundingBox();
  // Empty ground: the camera.
  await studio.fingers.down({ 1: { x: box.width * 0.5, y: 100 } });
  await studio.fingers.move({ 1: { x: box.width * 0.5 + 12, y: 108 } });
  await studio.fingers.up();
  await studio.eventually(async () => expect((await ticked()) === 1, 'the camera is ticked'));
  for (const [count, wanted] of [
    [1, 2],
    [2, 3],
    [3, 4],
  ]) {
    const spots = await middle(studio, count);
    await studio.fingers.down(spots);
    const moved = Object.fromEntries(Object.entries(spots).map(([id, at]) => [id, { x: at.x + 18, y: at.y - 14 }]));
    await studio.fingers.move(moved, { steps: 8, ms: 400 });
    await studio.eventually(async () => expect((await ticked()) >= wanted, `${count} fingers are ticked`));
    if (count === 1) await studio.shot('hint-ticked');
    if (await hint.isVisible()) expect((await widthOf()) === width, 'ticks take no room');
    await studio.fingers.up();
    await studio.wait(300);
  }
  await studio.eventually(async () => expect(!(await hint.isVisible()), 'all done: the hint goes'));
}

/** So many spots on the first group's mesh. */
async function middle(studio, count) {
  const list = await studio.page.evaluate((n) => {
    const { view, frame } = globalThis.__muster;
    const group = frame.groups[0];
    const v = group.vertices;
    const points = Array.from({ length: v.length / 2 }, (_, i) => ({ x: v[2 * i], y: v[2 * i + 1] }));
    const c = points.reduce((s, p) => ({ x: s.x + p.x / points.length, y: s.y + p.y / points.length }), { x: 0, y: 0 });
    const reach = 0.45 * Math.max(...points.map((p) => Math.hypot(p.x - c.x, p.y - c.y)));
    return Array.from({ length: n }, (_, k) => {
      const a = (2 * Math.PI * k) / n + 0.4;
      const r = n === 1 ? 0 : reach;
      return view.worldToScreen({ x: c.x + r * Math.cos(a), y: c.y + r * Math.sin(a) });
    });
  }, count);
  return Object.fromEntries(list.map((at, i) => [i + 1, at]));
}

/** An area where an earlier point and line still lie under the hand: three fingers are three fingers. */
export async function areaAfterLine(studio) {
  for (const [count, kind] of [
    [1, 0],
    [2, 1],
    [3, 2],
  ]) {
    const spots = await middle(studio, count);
    const ids = (await studio.frame()).groups[0].controls.map(({ id }) => id);
    await studio.fingers.down(spots);
    const moved = Object.fromEntries(Object.entries(spots).map(([id, at]) => [id, { x: at.x + 30, y: at.y + 24 }]));
    await studio.fingers.move(moved, { steps: 10, ms: 600 });
    const made = (await studio.frame()).groups[0].controls.filter(({ id }) => !ids.includes(id));
    const told = made.map((one) => `${one.kind} of ${one.points.length}`).join(', ');
    expect(made.length === 1 && made[0].kind === kind && made[0].points.length === count, `${count} fingers: ${told}`);
    await studio.fingers.up();
    await studio.wait(250);
  }
}

/** "+": a group with name, number and formation, put down by a tap. */
export async function addedGroup(studio) {
  const { page } = studio;
  const before = await page.evaluate(() => globalThis.__muster.frame.groups.length);
  await page.locator('.add-group').click();
  const dialog = page.locator('dialog.shape-dialog[open]');
  await dialog.locator('input').nth(0).fill('Visitors');
  await dialog.locator('input').nth(1).fill('20');
  await dialog.locator('select').selectOption('ring');
  await studio.shot('group-dialog');
  await serious(studio, 'dialog for a group');
  await dialog.locator('button[type="submit"]').click();
  const spot = await page.evaluate(() => {
    const { view, frame } = globalThis.__muster;
    const { x, y } = frame.groups[0];
    return view.worldToScreen({ x: x + 1, y: y + 11 });
  });
  await studio.fingers.down({ 1: spot });
  await studio.fingers.up();
  await studio.until('the new group', (n) => globalThis.__muster.frame.groups.length === n + 1, before);
  await studio.until('its name', () =>
    globalThis.__muster.state.groups.some(({ name, count }) => name === 'Visitors' && count === 20),
  );
  await studio.wait(600);
  await studio.shot('group-added');
}

/** A palm that lies on the formation moves nothing; a restart while paused stays paused. */
export async function palmAndRestart(studio) {
  const [spot] = Object.values(await middle(studio, 1));
  const touch = (type, x) =>
    studio.cdp.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ id: 5, x, y: spot.y, radiusX: 48, radiusY: 36, force: 1 }],
    });
  await touch('touchStart', spot.x);
  for (let i = 1; i <= 8; ++i) await touch('touchMove', spot.x + 6 * i);
  await studio.wait(400);
  const held = await studio.frame();
  await touch('touchEnd', 0);
  expect(held.groups[0].controls.length === 0, 'a palm is no finger');
  await studio.send({ type: 'Playback', action: 1 });
  await studio.until('the pause', () => !globalThis.__muster.frame.playing);
  await studio.page.keyboard.press('Home');
  await studio.until('the start', () => globalThis.__muster.frame.step < 5);
  await studio.wait(700);
  const { step, playing } = await studio.frame();
  expect(!playing && step < 5, `a restart while paused stays paused: step ${step}`);
}

/** Pinned points look different, and dots keep off faces. */
export async function marks(studio) {
  const [spot] = Object.values(await middle(studio, 1));
  await studio.page.mouse.dblclick(spot.x, spot.y);
  await studio.until('the pinned point', () =>
    globalThis.__muster.frame.groups[0].controls.some((control) => control.pinned),
  );
  await studio.pictures(3);
  await studio.shot('pinned');
  const ink = await studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const canvas = document.querySelector('canvas.marks');
    const box = canvas.getBoundingClientRect();
    const ratio = canvas.width / box.width;
    const [point] = frame.groups[0].controls[0].points;
    const at = view.worldToScreen({ x: point.x, y: point.y });
    const pen = canvas.getContext('2d');
    return [...pen.getImageData((at.x + 7 - box.left) * ratio, (at.y - 19 - box.top) * ratio, 1, 1).data];
  });
  expect(ink[3] > 200 && ink[0] < 60 && ink[2] < 70, `a pin stands in it: ${ink}`);
}

/** Buildings that hide people thin out. */
export async function hiddenPeople(studio) {
  await studio.page.evaluate(() => {
    const { camera } = globalThis.__muster.view;
    const { frame } = globalThis.__muster;
    const { x, y } = frame.groups[0];
    // From beyond the granary, so that it stands between the eye and the crowd.
    camera.setPose({ targetX: x + 3, targetY: y, distance: 46, turn: Math.PI / 2, pitch: 0.5 });
  });
  await studio.wait(300);
  const before = await studio.page.evaluate(() => [...globalThis.__muster.view.solid]);
  expect(Math.min(...before) === 1, 'nothing is thin where nobody is hidden');
  await studio.send({ type: 'Commands', commands: [{ kind: 'pose', group: 1, position: [-5.6, 0] }] });
  await studio.until('a thin building', () => Math.min(...globalThis.__muster.view.solid) < 0.5, null, 30000);
  await studio.shot('thin-building');
}

/** Rings of fingers on a phone leave the crowd to be seen. */
export async function smallRings(studio) {
  const spots = await middle(studio, 2);
  await studio.fingers.down(spots);
  await studio.fingers.move(
    Object.fromEntries(Object.entries(spots).map(([id, at]) => [id, { x: at.x + 10, y: at.y - 20 }])),
  );
  await studio.pictures(2);
  await studio.shot('fingers');
  await studio.fingers.up();
  await layout(studio);
}

/** Hint, legend, scale and arrows keep clear of each other with an overlay on show; titles are whole. */
export async function nothingOverlaps(studio) {
  const { page } = studio;
  await page.evaluate(() => globalThis.__muster.client.send({ type: 'Ping', time: 0 }));
  for (const key of ['', 'v', 'd']) {
    await page.locator('#scene').focus();
    if (key) await page.keyboard.press(key);
    await studio.wait(500);
    const found = await page.evaluate(() => {
      const names = [
        '.scale',
        '.legend',
        '.hint',
        '.view-bar',
        '.playback',
        '.readout',
        '.formations',
        '.groups',
        '.orders',
      ];
      const boxes = names.flatMap((name) => {
        const node = document.querySelector(`#ui ${name}`);
        if (!node || node.hidden || node.getClientRects().length === 0) return [];
        return [{ name, box: node.getBoundingClientRect() }];
      });
      const over = [];
      boxes.forEach((a, i) =>
        boxes.slice(i + 1).forEach((b) => {
          const apart =
            a.box.right <= b.box.left + 1 ||
            b.box.right <= a.box.left + 1 ||
            a.box.bottom <= b.box.top + 1 ||
            b.box.bottom <= a.box.top + 1;
          if (!apart) over.push(`${a.name} / ${b.name}`);
        }),
      );
      const title = document.querySelector('.scenario-button .title');
      return { over, cut: title.scrollWidth > title.clientWidth + 1 || title.scrollHeight > title.clientHeight + 2 };
    });
    expect(found.over.length === 0, `nothing lies over another: ${found.over.join(', ')}`);
    expect(!found.cut, 'the title is whole');
    await studio.shot(`overlay-${key || 'none'}`);
    if (key) await page.keyboard.press(key);
  }
}

/** What the page loads before it can be used, compressed. */
export async function firstLoad(studio, server) {
  const seen = new Set();
  let bytes = 0;
  const parts = [];
  const add = async (path) => {
    if (seen.has(path)) return '';
    seen.add(path);
    const answer = await fetch(new URL(path, server.url));
    const body = Buffer.from(await answer.arrayBuffer());
    const size = /\.(woff2)$/.test(path) ? body.length : gzipSync(body, { level: 9 }).length;
    bytes += size;
    parts.push(`${path.replace(/.*\//, '') || 'index.html'} ${(size / 1000).toFixed(0)}`);
    return body.toString('latin1');
  };
  const page = await add('/');
  const entries = await studio.page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .filter(({ name, initiatorType }) => /\.(js|css)$/.test(name) && initiatorType !== 'fetch')
      .map(({ name }) => new URL(name).pathname),
  );
  expect(page.includes('<script'), 'the page has a script');
  for (const path of entries) await add(path);
  console.log(`      first load: ${(bytes / 1000).toFixed(0)} kB compressed (${parts.join(', ')})`);
  expectBetween(bytes, 50_000, kFirstLoad, 'bytes of the first load');
}
