// The film camera: key frames along a take, between which the camera moves with ease.
import { expect } from '../support/expect.mjs';
import { serious } from './look.mjs';
import { pause, play, record, stop, timeLine } from './takes.mjs';

const pose = (studio) => studio.page.evaluate(() => ({ ...globalThis.__muster.view.camera.pose }));

/** Takes the playhead to a share of the part by a press on the track. */
async function press(studio, share) {
  const line = await timeLine(studio);
  const wanted = line.from + share * (line.to - line.from);
  const at = { x: line.left + (wanted / line.steps) * line.width, y: line.y };
  await studio.fingers.down({ 1: at });
  await studio.fingers.up();
  await studio.eventually(async () => {
    const { head, steps } = await timeLine(studio);
    expect(Math.abs(head - wanted) < 0.05 * steps, `the playhead is there: ${head}, not ${wanted}`);
  });
  const { head } = await timeLine(studio);
  await studio.until('that moment', (step) => Math.abs(globalThis.__muster.frame.step - step) < 2, head);
  await studio.pictures(2);
}

/** Two views are kept, the camera moves between them, and they outlast a reload. */
export async function filmCamera(studio, server) {
  const { page } = studio;
  await record(studio, 2);
  await stop(studio);
  await play(studio);
  await pause(studio);
  await press(studio, 0.3);
  const camera = page.locator('.time-camera');
  const menu = page.locator('.camera-keys');
  const keep = async () => {
    if (!(await menu.isVisible())) await camera.click();
    await menu.locator('.camera-keep').click();
  };
  await keep();
  const first = await pose(studio);
  await press(studio, 0.75);
  await page.evaluate(() => {
    const { camera } = globalThis.__muster.view;
    camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, 0.5);
    camera.orbit(0.6, 0);
  });
  await keep();
  await studio.eventually(async () => expect((await menu.locator('.camera-key').count()) === 2, 'two views are kept'));
  const last = await pose(studio);
  await serious(studio, 'menu of the film camera');
  await studio.shot('film-camera');
  await camera.click();
  await press(studio, 0.525);
  const middle = await pose(studio);
  expect(
    Math.abs(middle.distance - Math.sqrt(first.distance * last.distance)) < 0.15 * last.distance,
    `half way: ${middle.distance} between ${first.distance} and ${last.distance}`,
  );
  expect(Math.abs(middle.turn - (first.turn + last.turn) / 2) < 0.15, 'and half turned');
  await press(studio, 0.3);
  expect(Math.abs((await pose(studio)).distance - first.distance) < 0.05 * first.distance, 'back at the first view');
  await page.goto(server.url);
  await studio.until(
    'the take again',
    () => !document.querySelector('.time-line')?.hidden && globalThis.__muster?.frame,
  );
  await press(studio, 0.78);
  await studio.eventually(async () =>
    expect(
      Math.abs((await pose(studio)).distance - last.distance) < 0.05 * last.distance,
      'the views outlast a reload',
    ),
  );
  await camera.click();
  await menu.locator('.camera-leads').click();
  await page.keyboard.press('Escape');
  const free = await pose(studio);
  await press(studio, 0.3);
  expect(Math.abs((await pose(studio)).distance - free.distance) < 1e-6, 'switched off, it leaves the view alone');
}
