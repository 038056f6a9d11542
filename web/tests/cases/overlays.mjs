// What can be painted on the ground: the field of obstacles, one character's cost, density; and how it comes back.
import { expect } from '../support/expect.mjs';
import { startStudio } from '../support/server.mjs';

const button = (studio, label) => studio.page.locator(`.area > .layers [aria-label="${label}"]`);
const legend = (studio) => studio.page.locator('.legend');

/** Waits for an overlay message and the picture of it. */
async function untilPainted(studio) {
  await studio.until('the painted field', () => globalThis.__muster.view.fieldScale !== null);
  await studio.pictures(2);
}

async function show(studio, label, title) {
  await button(studio, label).click();
  await untilPainted(studio);
  expect((await button(studio, label).getAttribute('aria-pressed')) === 'true', `${label} is pressed`);
  expect(
    (await legend(studio).locator('h2').textContent()) === title,
    `the legend tells of it: ${await legend(studio).textContent()}`,
  );
  await studio.shot(`overlay-${label.toLowerCase()}`);
}

/** A character in the front row: id and where its middle stands on the screen. */
function frontCharacter(studio) {
  return studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const at = Array.from(frame.x, (x, i) => view.worldToScreen({ x, y: frame.y[i] }));
    const front = at.reduce((best, p, i) => (p.y > at[best].y ? i : best), 0);
    return { index: front, x: at[front].x, y: at[front].y - 0.9 * view.pixelsPerMetre() * 0.7 };
  });
}

export async function overlays(studio) {
  await studio.pictures(2);
  await show(studio, 'Push', 'Push of obstacles');
  await show(studio, 'Density', 'Density');
  const scale = await studio.page.evaluate(() => globalThis.__muster.view.fieldScale.max);
  expect(scale > 0, `the crowd is dense somewhere: ${scale}`);
  expect((await button(studio, 'Push').getAttribute('aria-pressed')) === 'false', 'one overlay at a time');
  await button(studio, 'Effort').click();
  await studio.until('the question who', () => /Tap a person/.test(document.querySelector('.legend').textContent));
  expect(
    await studio.page.evaluate(() => globalThis.__muster.view.fieldScale === null),
    'no field before somebody is chosen',
  );
  const { x, y } = await frontCharacter(studio);
  await studio.fingers.down({ 1: { x, y } });
  await studio.wait(60);
  await studio.fingers.up();
  await studio.until('the chosen character', () => globalThis.__muster.state.chosen >= 0);
  await untilPainted(studio);
  await studio.shot('overlay-cost');
  const words = await legend(studio).textContent();
  expect(/Person \d+/.test(words) && /Way to walk\s*\d+\.\d m/.test(words), `the legend gives the figures: ${words}`);
  const { chosen, cost } = await studio.page.evaluate(() => globalThis.__muster.state);
  expect(
    cost.way >= cost.straight - 0.3,
    `the way of ${chosen} is no shorter than the straight line: ${cost.way}, ${cost.straight}`,
  );
  const draws = await studio.page.evaluate(() => globalThis.__muster.view.stats.drawCalls);
  expect(draws <= 60, `${draws} draws, at most 60 allowed`);
  await button(studio, 'Effort').click();
  expect(!(await legend(studio).isVisible()), 'pressed again it goes');
}

/** The server goes and comes back: the overlay lives on, and messages never cover each other. */
export async function overlayAfterLoss(studio, server) {
  await studio.page.keyboard.press('d');
  await untilPainted(studio);
  await studio.send({ type: 'SetSpeed', factor: 99 });
  await studio.page.locator('.notice[data-level="error"]').waitFor();
  await server.stop();
  await studio.until('the banner', () => document.documentElement.hasAttribute('data-lost'));
  await studio.wait(300);
  await studio.shot('lost-with-notice');
  const [lost, notice] = await studio.page.evaluate(() =>
    [...document.querySelectorAll('.banners > .banner')].map((one) => one.getBoundingClientRect().toJSON()),
  );
  expect(lost.height > 0 && notice.height > 0 && notice.top >= lost.bottom, 'the message stands below the banner');
  const inert = await studio.page.evaluate(() =>
    ['.play', '.formation', '.scenario-button', '.theme-button', '.help-button'].map(
      (one) => document.querySelector(one).closest('[inert]') !== null,
    ),
  );
  expect(inert.join() === 'true,true,true,false,false', `what would do nothing is inert: ${inert}`);
  const again = await startStudio({ scenario: server.scenario, port: server.port });
  try {
    await studio.connected();
    const painted = await studio.page.evaluate(
      () =>
        new Promise((resolve) => {
          const timer = setTimeout(() => resolve(false), 5000);
          const end = globalThis.__muster.client.on('overlay', ({ kind }) => {
            clearTimeout(timer);
            end();
            resolve(kind === 3);
          });
        }),
    );
    expect(painted, 'the new server paints the density again');
  } finally {
    await again.stop();
  }
}
