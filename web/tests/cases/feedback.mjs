// What the page shows before, or instead of, an answer of the world.
import { expect } from '../support/expect.mjs';
import { distance, extreme, points, shifted } from '../support/geometry.mjs';

/** Pixels of the canvas of marks that are painted near a spot on the screen. */
function painted(studio, at, reach = 14) {
  return studio.page.evaluate(
    ([{ x, y }, half]) => {
      const canvas = document.querySelector('canvas.marks');
      if (canvas.hidden) return 0;
      const bounds = canvas.getBoundingClientRect();
      const ratio = canvas.width / bounds.width;
      const at = (from, to) => Math.round((from - to - half) * ratio);
      const size = Math.round(2 * half * ratio);
      const { data } = canvas.getContext('2d').getImageData(at(x, bounds.left), at(y, bounds.top), size, size);
      return data.filter((value, i) => i % 4 === 3 && value > 0).length;
    },
    [at, reach],
  );
}

/** While the world is paused, what fingers draw is seen until a step takes it; and nothing stays that should fade. */
export async function paused(studio) {
  const corner = extreme(points((await studio.frame()).groups[0].vertices), 1, 0);
  const way = [corner, shifted(corner, 3, 0), shifted(corner, 6, 2)];
  const stops = await studio.screen(way);
  await studio.fingers.down({ 1: stops[0] });
  await studio.until('the chip', () => document.querySelector('.tag-chip') !== null);
  await studio.page.keyboard.press('Space');
  await studio.until('the pause', () => globalThis.__muster.frame.playing === false);
  const before = await painted(studio, stops[1]);
  for (const at of stops.slice(1)) await studio.fingers.move({ 1: at }, { steps: 6, ms: 120 });
  const { step } = await studio.frame();
  let seen = before;
  for (let i = 0; i < 30 && seen <= before + 20; ++i) {
    await studio.wait(100);
    seen = await painted(studio, stops[1]);
  }
  expect(seen > before + 20, `the path is seen though no frame shows it: ${seen} px, ${before} before`);
  await studio.fingers.up();
  // Longer than any mark takes to fade.
  await studio.wait(400);
  expect((await painted(studio, stops[1])) > before + 20, 'it stays when the finger lifts');
  await studio.shot('paused');
  expect((await studio.frame()).step === step, 'the world stands still');
  await studio.until('the chip to fade', () => document.querySelector('.tag-chip') === null);
  await studio.page.keyboard.press('.');
  await studio.until('the step', (n) => globalThis.__muster.frame.step === n + 1, step);
  await studio.eventually(async () => {
    const taken = (await studio.frame()).groups[0].controls[0];
    expect(
      taken.points[0].path.length >= 8,
      `the step took the whole path: ${taken.points[0].path.length / 2} checkpoints`,
    );
  });
  await studio.shot('paused-step');
  await studio.page.keyboard.press('Space');
}

/** A refused touch says why, and its place can be looked at. */
export async function refused(studio) {
  const place = { x: 18, y: 14 };
  await studio.page.evaluate(() =>
    globalThis.__muster.view.camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, 2),
  );
  await studio.pictures(1);
  await studio.send({
    type: 'Touches',
    events: [{ phase: 0, touch: 9001, ...place, time: performance.now() / 1000, group: 0 }],
  });
  const notice = studio.page.locator('.notice');
  await notice.waitFor();
  const words = await notice.textContent();
  expect(/no formation/.test(words) && !/\d m\b/.test(words), `what, without coordinates: ${words}`);
  expect((await notice.getAttribute('data-level')) === 'warning', 'it is a warning');
  await studio.shot('refused');
  await notice.locator('.notice-show').click();
  await studio.cameraAtRest();
  const [at] = await studio.screen([place]);
  const { width, height } = studio.page.viewportSize();
  expect(
    distance(at, { x: width / 2, y: height / 2 }) < 0.3 * Math.min(width, height),
    `the camera went there: ${JSON.stringify(at)}`,
  );
  await notice.locator('.notice-close').click();
  expect(!(await notice.isVisible()), 'it can be closed');
}
