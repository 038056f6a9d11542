// Control schemes of the server, used by hand in the studio.
import { expect } from '../support/expect.mjs';
import { crowd, distance, mean, points, shifted } from '../support/geometry.mjs';

async function openList(studio) {
  const phone = await studio.page.locator('.phone-bar').isVisible();
  // The formations have a “More”, too.
  const from = phone ? studio.page.locator('.phone-bar') : studio.page;
  await from.getByRole('button', { name: phone ? 'More' : 'Takes', exact: true }).click();
  await studio.page.locator('.menu-item', { hasText: 'Control…' }).locator('visible=true').click();
  await studio.page.locator('dialog.schemes[open]').waitFor();
}

async function choose(studio, name) {
  await openList(studio);
  await studio.shot('schemes');
  await studio.page.locator(`dialog.schemes input[value="${name}"]`).check();
  await studio.page.keyboard.press('Escape');
  await studio.until('the scheme', (wanted) => globalThis.__muster.state.scheme === wanted, name);
}

export async function byMouse(studio) {
  const { mouse } = studio.page;
  await choose(studio, 'mouse-full-free');
  const before = await studio.frame();
  const all = crowd(before);
  const low = { x: Math.min(...all.map(({ x }) => x)) - 1, y: Math.min(...all.map(({ y }) => y)) - 1 };
  const high = { x: Math.max(...all.map(({ x }) => x)) + 1, y: Math.max(...all.map(({ y }) => y)) + 1 };
  const corners = await studio.screen([low, high, { x: low.x, y: high.y }, { x: high.x, y: low.y }]);
  const [left, right] = [Math.min(...corners.map(({ x }) => x)), Math.max(...corners.map(({ x }) => x))];
  const [top, bottom] = [Math.min(...corners.map(({ y }) => y)), Math.max(...corners.map(({ y }) => y))];
  await mouse.move(left, top);
  await mouse.down();
  await mouse.move(right, bottom, { steps: 6 });
  await studio.pictures(2);
  await studio.shot('scheme-box');
  await mouse.up();
  const [goal] = await studio.screen([shifted(mean(all), 6, 2)]);
  await mouse.click(goal.x, goal.y, { button: 'right' });
  await studio.until(
    'the crowd to walk',
    (x) => {
      const { frame } = globalThis.__muster;
      return frame.x.reduce((sum, value) => sum + value, 0) / frame.x.length > x + 2;
    },
    mean(all).x,
    30000,
  );
  await studio.shot('scheme-sent');
  const after = await studio.frame();
  expect(
    after.groups.every((group) => group.controls.length === 0),
    'the page itself made no control of the drag',
  );
  // S stops them; as a key of the page it would do something else.
  await studio.page.locator('#scene').focus();
  await studio.page.keyboard.press('s');
  await studio.page.locator('.scheme-banner button').click();
  await studio.until('the studio’s own control', () => globalThis.__muster.state.scheme === '');
}

export async function byTouch(studio) {
  await choose(studio, 'touch');
  const before = await studio.frame();
  const middle = mean(points(before.groups[0].vertices));
  const [from, to] = await studio.screen([middle, shifted(middle, 3, 1.5)]);
  await studio.fingers.down({ 1: from });
  await studio.fingers.move({ 1: to }, { ms: 500 });
  await studio.until(
    'the mesh to follow',
    ([x, y]) => {
      const { vertices } = globalThis.__muster.frame.groups[0];
      let best = Infinity;
      for (let i = 0; i < vertices.length; i += 2)
        best = Math.min(best, Math.hypot(vertices[i] - x, vertices[i + 1] - y));
      return best < 1;
    },
    [middle.x + 3, middle.y + 1.5],
    30000,
  );
  await studio.shot('scheme-touch');
  await studio.fingers.up();
  const after = mean(points((await studio.frame()).groups[0].vertices));
  expect(distance(after, middle) > 1, 'the mesh went along');
  await studio.page.locator('.scheme-banner button').click();
}
