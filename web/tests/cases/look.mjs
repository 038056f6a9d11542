// Access and layout.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { expect } from '../support/expect.mjs';
import { Reach, kTogether, steering, watching } from './reach.mjs';

const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** What axe finds by WCAG 2.2 AA and by best practices, each with the first elements. An open menu or dialog is looked at alone:
 * it may lie over what is below. */
async function violations(studio) {
  if (!(await studio.page.evaluate(() => 'axe' in globalThis))) await studio.page.evaluate(axeSource);
  return studio.page.evaluate(async () => {
    const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
    const top = [...document.querySelectorAll(':modal, :popover-open')].at(-1);
    const found = await globalThis.axe.run(top ?? document, { resultTypes: ['violations'], runOnly: tags });
    return found.violations.map(({ id, nodes }) => {
      const first = nodes.slice(0, 3).map(({ target, any }) => `${target.join(' ')} (${any[0]?.message ?? ''})`);
      return `${id}: ${first.join(', ')}`;
    });
  });
}

export async function serious(studio, state) {
  const bad = await violations(studio);
  expect(bad.length === 0, `axe finds in the ${state}: ${bad.join('; ')}`);
}

/** Every panel, menu and dialog, as axe sees it in light and in dark colours. */
class Access extends Reach {
  async look(name) {
    this.looked.push(name);
    for (const theme of ['dark', 'light']) {
      await this.studio.page.evaluate(async (wanted) => {
        document.documentElement.dataset.theme = wanted;
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        await Promise.allSettled(document.getAnimations().map(({ finished }) => finished));
      }, theme);
      for (const what of await violations(this.studio))
        if (!this.wrong.some((one) => one.endsWith(what))) this.wrong.push(`${name}, ${theme}: ${what}`);
    }
  }
}

async function everyPanel(studio) {
  await steering(studio, new Access(studio));
  await watching(studio, new Access(studio));
}

/** Names of what Tab stops at, from the scene on. */
async function tabStops(studio) {
  await studio.page.locator('#scene').focus();
  const stops = [];
  for (let i = 0; i < 24; ++i) {
    await studio.page.keyboard.press('Tab');
    stops.push(
      await studio.page.evaluate(
        () => document.activeElement.closest('[role="toolbar"]')?.ariaLabel ?? document.activeElement.ariaLabel,
      ),
    );
  }
  return stops;
}

export async function accessible(studio) {
  const stops = await tabStops(studio);
  expect(stops.includes('Time and takes'), `Tab reaches the playback bar: ${[...new Set(stops)].join(', ')}`);
  await serious(studio, 'page');
  await studio.shot('page');
  await studio.page.keyboard.press('n');
  await studio.wait(300);
  await serious(studio, 'dark page');
  await studio.shot('dark');
  await studio.page.keyboard.press('n');
  await studio.page.keyboard.press('h');
  await studio.page.locator('dialog.help[open]').waitFor();
  await serious(studio, 'help');
  await studio.shot('help');
  await studio.page.keyboard.press('Escape');
  await studio.page.locator('.scenario-button').click();
  await serious(studio, 'list of scenarios');
  await studio.shot('scenarios');
  await studio.page.keyboard.press('Escape');
}

/** Targets of 44 px, playback buttons of 48 px, nothing beyond the window, panels side by side. */
export async function layout(studio) {
  await studio.shot('layout');
  const found = await studio.page.evaluate(() => {
    const visible = (node) => node.getClientRects().length > 0 && getComputedStyle(node).visibility === 'visible';
    const boxes = [...document.querySelectorAll('#ui button')]
      .filter(visible)
      .map((node) => ({ name: node.ariaLabel ?? node.textContent, box: node.getBoundingClientRect() }));
    const small = boxes.filter(({ box }) => box.width < 43.9 || box.height < 43.9).map(({ name }) => name);
    const panels = [...document.querySelectorAll('#ui .panel, #ui .sheet')]
      .filter(visible)
      .filter((node) => getComputedStyle(node).position !== 'static' && node.parentElement.closest('.panel') === null)
      .map((node) => ({ name: node.className, box: node.getBoundingClientRect() }));
    const outside = panels
      .filter(
        ({ box }) => box.left < 0 || box.top < 0 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5,
      )
      .map(({ name }) => name);
    const overlaps = [];
    panels.forEach((a, i) =>
      panels.slice(i + 1).forEach((b) => {
        const apart =
          a.box.right <= b.box.left ||
          b.box.right <= a.box.left ||
          a.box.bottom <= b.box.top ||
          b.box.bottom <= a.box.top;
        if (!apart) overlaps.push(`${a.name} / ${b.name}`);
      }),
    );
    const playback = [...document.querySelectorAll('.playback button')]
      .filter(visible)
      .filter((node) => !node.closest('.take-list'))
      .filter((node) => Math.min(node.getBoundingClientRect().width, node.getBoundingClientRect().height) < 47.9)
      .map((node) => node.ariaLabel);
    return { playback, small, outside, overlaps, scroll: document.documentElement.scrollWidth - innerWidth };
  });
  expect(found.small.length === 0, `targets under 44 px: ${found.small.join(', ')}`);
  expect(found.playback.length === 0, `playback buttons under 48 px: ${found.playback.join(', ')}`);
  expect(found.outside.length === 0, `panels beyond the window: ${found.outside.join(', ')}`);
  expect(found.overlaps.length === 0, `panels over each other: ${found.overlaps.join(', ')}`);
  expect(found.scroll <= 0, `the page scrolls sideways by ${found.scroll} px`);
}

export async function firstVisit(studio) {
  const hint = studio.page.locator('.hint');
  expect(await hint.isVisible(), 'the first visit shows how to steer');
  await studio.shot('hint');
  const { width, height } = studio.page.viewportSize();
  await studio.fingers.down({ 1: { x: width / 2, y: height * 0.3 } });
  await studio.fingers.up();
  expect((await hint.textContent()).includes('One finger'), 'its words follow a touch');
  await layout(studio);
  await hint.locator('button').click();
  expect(!(await hint.isVisible()), 'Got it hides it');
  if (studio.size === 'phone') await threePanels(studio);
}

/** A phone has the place, what is shown, and one sheet, whose buttons have words. */
async function threePanels(studio) {
  const found = await studio.page.evaluate(() => {
    const shown = (node) => node.checkVisibility() && !node.parentElement.closest('.panel, .sheet');
    const panels = [...document.querySelectorAll('#ui .panel, #ui .sheet')].filter(shown);
    return panels.map(({ className }) => className);
  });
  expect(found.length === 3, `three panels: ${found.join(', ')}`);
  for (const tab of ['formation', 'orders', 'view']) {
    await studio.tab(tab);
    const wordless = await studio.page.evaluate(() =>
      [...document.querySelectorAll('.sheet .formations, .sheet .orders, .sheet .view-bar')]
        .flatMap((panel) => [...panel.querySelectorAll('button')])
        .filter((node) => node.checkVisibility() && (node.querySelector('.label')?.offsetWidth ?? 0) < 8)
        .map((node) => node.ariaLabel),
    );
    expect(wordless.length === 0, `words are under icons: ${wordless.join(', ')}`);
    await studio.shot(`sheet-${tab}`);
  }
}

export const kAccessCases = [
  ['access: every panel', everyPanel, ['wide', 'phone'], { ...kTogether, everySize: false, hint: true, release: true }],
];
