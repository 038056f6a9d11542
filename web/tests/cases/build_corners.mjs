// Building: corners one by one, and lines of others to which a moved thing snaps.
import { expect } from '../support/expect.mjs';
import { drag, near, open, scene, screen, tool } from './build.mjs';

/** Corners one by one, and lines of others, by finger or mouse. */
export async function cornersAndGuides(studio) {
  const touch = studio.size !== 'desktop';
  const pull = (from, to) => drag(studio, from, to, { touch });
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Box');
  await pull({ x: -2, y: 2 }, { x: 1, y: 4 });
  await scene(studio, 'a box', (one) => one.obstacles.length === 1);
  await tool(studio, 'Select');
  const corners = () => page.locator('.build-corner').count();
  await studio.eventually(async () => expect((await corners()) === 4, `its corners are dots: ${await corners()}`));
  await pull({ x: 1, y: 4 }, { x: 2, y: 5 });
  let now = await scene(studio, 'a corner moved', (one) => one.obstacles[0].polygon.some((p) => near(p, [2, 5])));
  expect(now.obstacles[0].polygon.length === 4, 'it is still one of four');
  await pull({ x: -0.5, y: 2 }, { x: -0.5, y: 0 });
  // The world follows the drag: only its end counts.
  await scene(studio, 'a fifth corner', ({ obstacles: [one] }) => {
    return one.polygon.length === 5 && one.polygon.some((p) => near(p, [-0.5, 0]));
  });
  await studio.shot('build-corners');
  // A corner that is drawn across the outline springs back.
  await pull({ x: -2, y: 2 }, { x: 4, y: 4 });
  await studio.eventually(async () => {
    const said = await page.locator('.build-panel').textContent();
    expect(/must not cross itself/.test(said), said);
  });
  const [spot] = await screen(studio, [{ x: -0.5, y: 0 }]);
  if (touch) {
    await studio.fingers.down({ 1: spot });
    await studio.fingers.up();
  } else await page.mouse.click(spot.x, spot.y);
  await studio.eventually(async () => expect((await page.locator('.build-tapped').count()) === 1, 'it is tapped'));
  await page.keyboard.press('Delete');
  now = await scene(studio, 'four again', (one) => one.obstacles[0].polygon.length === 4);
  expect(now.obstacles.length === 1, 'the thing itself stays');

  // A second box that is moved lines up with the first.
  await page.keyboard.press('Escape');
  await tool(studio, 'Box');
  await pull({ x: -2.5, y: -3 }, { x: -0.5, y: -1.5 });
  await scene(studio, 'two', (one) => one.obstacles.length === 2);
  await tool(studio, 'Select');
  const [a, b] = await screen(studio, [
    { x: -1.5, y: -2.2 },
    { x: -1.05, y: -2.2 },
  ]);
  const guides = () => page.locator('.build-guide').count();
  if (touch) {
    await studio.fingers.down({ 1: a });
    await studio.fingers.move({ 1: { x: a.x + 40, y: a.y } }, { steps: 3, ms: 60 });
    await studio.fingers.move({ 1: b }, { steps: 3, ms: 60 });
  } else {
    await page.mouse.move(a.x, a.y);
    await page.mouse.down();
    await page.mouse.move(a.x + 40, a.y, { steps: 3 });
    await page.mouse.move(b.x, b.y, { steps: 3 });
  }
  await studio.eventually(async () => expect((await guides()) > 0, 'a line shows what it lines up with'));
  await studio.shot('build-guides');
  if (touch) await studio.fingers.up();
  else await page.mouse.up();
  await scene(studio, 'lined up', (one) => one.obstacles[1].polygon.some(([x]) => Math.abs(x + 2) < 1e-6));
  await studio.eventually(async () => expect((await guides()) === 0, 'the line goes with the drag'));
}
