// The camera: it follows a watched crowd, comes back, frames groups, tilts, and remembers views.
import { expect, expectBetween } from '../support/expect.mjs';

/** Share of the crowd in the window. */
function shareInView(studio) {
  return studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const at = Array.from(frame.x, (x, i) => view.worldToScreen({ x, y: frame.y[i] }));
    return at.filter((p) => p.x > 0 && p.y > 0 && p.x < innerWidth && p.y < innerHeight).length / at.length;
  });
}

const pose = (studio) => studio.page.evaluate(() => ({ ...globalThis.__muster.view.camera.pose }));

/** Near the ground, in a corner of the world. */
async function lookAway(studio, side) {
  await studio.page.evaluate((to) => {
    const { camera } = globalThis.__muster.view;
    camera.setPose({ ...camera.pose, targetX: 1000 * to, targetY: 1000 * to, distance: 7 });
  }, side);
  await studio.pictures(1);
}

async function tap(studio, locator) {
  const box = await locator.boundingBox();
  await studio.fingers.down({ 1: { x: box.x + box.width / 2, y: box.y + box.height / 2 } });
  await studio.wait(40);
  await studio.fingers.up();
}

/** Watches the whole demonstration, and until all stand: never less than 90 % of the crowd is off screen. */
export async function watchedCrowd(studio) {
  await tap(studio, studio.page.locator('.playback .watch'));
  await studio.until('the demonstration', () => globalThis.__muster.frame.demonstrating);
  expect(await studio.page.evaluate(() => globalThis.__muster.state.following), 'the camera follows');
  await studio.send({ type: 'SetSpeed', factor: 4 });
  const result = await studio.page.evaluate(
    () =>
      new Promise((done) => {
        const { view } = globalThis.__muster;
        const from = performance.now();
        let [least, at, sum, looks, ended] = [1, 0, 0, 0, -1];
        const look = () => {
          const { frame, state } = globalThis.__muster;
          const inside = Array.from(frame.x, (x, i) => view.worldToScreen({ x, y: frame.y[i] })).filter(
            (p) => p.x > 0 && p.y > 0 && p.x < innerWidth && p.y < innerHeight,
          ).length;
          const share = inside / frame.x.length;
          sum += share;
          looks += 1;
          if (share < least) [least, at] = [share, frame.time];
          if (!frame.demonstrating && ended < 0) ended = frame.time;
          const late = performance.now() - from > 75000;
          if (late || (ended >= 0 && (!state.following || frame.time > ended + 25))) {
            done({ least, at, mean: sum / looks, time: frame.time, ended, late, following: state.following });
          } else setTimeout(look, 60);
        };
        look();
      }),
  );
  const told = `least ${(100 * result.least).toFixed(1)} % at ${result.at.toFixed(1)} s, mean ${(100 * result.mean).toFixed(1)} %, touches until ${result.ended.toFixed(1)} s, watched until ${result.time.toFixed(1)} s`;
  console.log(`      ${told}`);
  await studio.shot('watched-to-the-end');
  expect(result.least >= 0.9, `never less than 90 % of the crowd in view: ${told}`);
}

/** Follow, fit, arrow, double tap on a chip, and tilt, by touch. */
export async function cameraByTouch(studio) {
  const { page } = studio;
  const bar = page.locator('.view-bar');
  await studio.tab('view');
  await tap(studio, bar.locator('button').nth(1));
  expect((await bar.locator('button').nth(1).getAttribute('aria-pressed')) === 'true', 'follow is pressed');
  // A hand on the camera ends it.
  const width = page.viewportSize().width;
  const height = page.viewportSize().height;
  const empty = { x: width * 0.4, y: height * 0.22 };
  await studio.fingers.down({ 1: empty });
  await studio.fingers.move({ 1: { x: empty.x + 5, y: empty.y + 60 } });
  await studio.fingers.up();
  await studio.eventually(async () => {
    expect((await bar.locator('button').nth(1).getAttribute('aria-pressed')) === 'false', 'a hand ends the following');
  });
  // Off screen: an arrow to each group, which brings it back.
  await lookAway(studio, 1);
  await page.locator('.crowd-arrow').first().waitFor();
  expect((await shareInView(studio)) === 0, 'nobody is in view');
  const arrows = await page.locator('.crowd-arrow').count();
  const groups = await page.evaluate(() => globalThis.__muster.frame.groups.length);
  expect(arrows === groups, `${arrows} arrows to ${groups} groups`);
  await studio.shot('crowd-off-screen');
  await tap(studio, page.locator('.crowd-arrow').first());
  await studio.eventually(async () => expect((await shareInView(studio)) > 0.4, 'the arrow brings the crowd back'));
  await studio.eventually(async () => {
    const at = await page.locator('.crowd-arrow').count();
    expect(at < groups || groups > 1, 'its arrow goes');
  });
  // Fit.
  await lookAway(studio, -1);
  await tap(studio, bar.locator('button').first());
  await studio.eventually(async () => expect((await shareInView(studio)) > 0.99, 'Fit shows everybody'));
  // Twice on a chip: that group alone.
  const before = await pose(studio);
  const chip = page.locator('.groups .chip').last();
  const box = await chip.boundingBox();
  for (let i = 0; i < 2; ++i) {
    await studio.fingers.down({ 1: { x: box.x + box.width / 2, y: box.y + box.height / 2 } });
    await studio.fingers.up();
    await studio.wait(30);
  }
  await studio.wait(900);
  const framed = await pose(studio);
  if (groups > 1) {
    const away = Math.hypot(framed.targetX - before.targetX, framed.targetY - before.targetY);
    expect(away > 1, `the view goes to the group: ${away} m`);
    await studio.shot('group-framed');
  }
  // Two fingers side by side, upwards and downwards.
  const at = { x: width * 0.35, y: height * 0.22 };
  await studio.fingers.down({ 1: at, 2: { x: at.x + 80, y: at.y + 4 } });
  await studio.fingers.move({ 1: { x: at.x, y: at.y + 110 }, 2: { x: at.x + 82, y: at.y + 112 } });
  await studio.fingers.up();
  const tilted = await pose(studio);
  expect(tilted.pitch > framed.pitch + 0.2, `two fingers tilt: ${framed.pitch} to ${tilted.pitch}`);
  expectBetween(tilted.turn, framed.turn - 1e-6, framed.turn + 1e-6, 'and turn nothing');
  await studio.shot('tilted');
}

/** Views, from above, without perspective, and the clean picture, by keys. */
export async function cameraByKeys(studio) {
  const { page } = studio;
  await page.locator('#scene').focus();
  await page.keyboard.press('Alt+Shift+Digit2');
  const saved = await pose(studio);
  await page.keyboard.press('Alt+t');
  expect((await pose(studio)).pitch > 1.55, 'Alt+T looks down');
  const width = await page.evaluate(() => {
    const { view } = globalThis.__muster;
    return view.pixelsPerMetre();
  });
  await page.keyboard.press('Alt+o');
  await studio.pictures(2);
  const flat = await page.evaluate(() => {
    const { view } = globalThis.__muster;
    const { targetX: x, targetY: y } = view.camera.pose;
    const span = (dy) => view.worldToScreen({ x: x + 1, y: y + dy }).x - view.worldToScreen({ x: x - 1, y: y + dy }).x;
    return { scale: view.pixelsPerMetre(), near: span(-6), far: span(6) };
  });
  expectBetween(flat.scale / width, 0.98, 1.02, 'the middle keeps its scale');
  expectBetween(flat.far / flat.near, 0.99, 1.01, 'what is far is as large as what is near');
  await studio.shot('from-above');
  await page.keyboard.press('Alt+Digit2');
  await studio.eventually(async () => {
    const now = await pose(studio);
    expect(Math.abs(now.pitch - saved.pitch) < 1e-6, 'the saved view comes back');
  });
  await page.keyboard.press('Alt+o');
  await page.keyboard.press('0');
  await studio.wait(2300);
  const left = await page.evaluate(
    () =>
      [...document.querySelectorAll('#ui .panel, #ui .sheet, .marks, .tag')].filter((node) => {
        const style = getComputedStyle(node);
        return style.visibility === 'visible' && Number(style.opacity) > 0 && node.getClientRects().length > 0;
      }).length,
  );
  expect(left === 0, `a clean picture has no panels or marks: ${left} left`);
  await studio.shot('clean-picture');
  await page.keyboard.press('0');
  expect(await page.locator('.playback').isVisible(), 'and they come back');
}

/** The wheel at bare floor never ends on bare floor. */
export async function wheelEndsOnPeople(studio) {
  const { page } = studio;
  const { width, height } = page.viewportSize();
  await page.mouse.move(width * 0.2, height * 0.2);
  for (let i = 0; i < 40; ++i) {
    await page.mouse.wheel(0, -240);
    await studio.wait(25);
  }
  await studio.pictures(2);
  const found = await studio.page.evaluate(() => globalThis.__muster.view.camera.pose.distance);
  expect(found < 8, `as near as it goes: ${found} m`);
  expect((await shareInView(studio)) > 0, 'and somebody is in view');
  await studio.shot('zoomed-in');
}
