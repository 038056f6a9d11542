// A person in a run of the study, as a browser plays one: fingers for touch, the mouse for the mouse.
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { DrivenPage } from './driven_page.mjs';
import { Fingers } from './fingers.mjs';
import { kSizes } from './studio_page.mjs';

const shots = fileURLToPath(new URL('../../test-results/', import.meta.url));
mkdirSync(shots, { recursive: true });

/** Stages of a run as messages number them. */
export const kStage = {
  form: 0,
  ready: 1,
  trial: 2,
  paused: 3,
  thanks: 4,
  brokenOff: 5,
  elsewhere: 6,
  replay: 7,
};

export class StudyPerson extends DrivenPage {
  static async open(browser, url, { size = 'wide', colorScheme = 'light', touch = true } = {}) {
    const context = await browser.newContext({ viewport: kSizes[size], colorScheme, hasTouch: touch });
    const page = await context.newPage();
    const person = new StudyPerson(context, page, size);
    page.on('pageerror', (error) => person.errors.push(error.message));
    page.on('console', (message) => {
      if (message.type() === 'error' && !/WebSocket|ERR_CONNECTION/.test(message.text()))
        person.errors.push(message.text());
    });
    const cdp = await context.newCDPSession(page);
    if (touch) await cdp.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 10 });
    person.fingers = new Fingers(cdp);
    // The items of each trial, for the test to aim at.
    await page.addInitScript(() => {
      const wait = setInterval(() => {
        if (!globalThis.__muster) return;
        clearInterval(wait);
        globalThis.__muster.client.on('scene', (scene) => (globalThis.__facts = scene));
      }, 5);
    });
    await page.goto(url);
    return person;
  }

  state() {
    return this.page.evaluate(() => globalThis.__muster?.study ?? null);
  }

  untilStage(stage, timeout) {
    return this.until(`stage ${stage}`, (wanted) => globalThis.__muster?.study?.stage === wanted, stage, timeout);
  }

  /** Waits for a form, and returns its instrument as its title tells. */
  async form() {
    await this.page.locator('form.study-card').waitFor();
    return this.page.locator('form.study-card h1').textContent();
  }

  /** Presses with a finger or the mouse. */
  async press(locator, byFinger = false) {
    await locator.scrollIntoViewIfNeeded();
    if (!byFinger) return locator.click();
    const box = await locator.boundingBox();
    await this.fingers.down({ 1: { x: box.x + box.width / 2, y: box.y + box.height / 2 } });
    await this.fingers.up();
  }

  /** Answers the form that is shown, and waits for what comes next. */
  async answerForm({ byFinger = false } = {}) {
    const before = await this.form();
    const fields = this.page.locator('form.study-card .study-field');
    for (let i = 0; i < (await fields.count()); ++i) {
      const field = fields.nth(i);
      const written = field.locator('input[type="text"]');
      const buttons = field.locator('input[type="radio"], input[type="checkbox"]');
      const count = await buttons.count();
      if (count > 0) await this.press(buttons.nth(Math.min(count - 1, (3 * i) % count)), byFinger);
      else if ((await written.count()) > 0) await written.fill('21');
      else if ((await field.locator('textarea').count()) > 0)
        await field.locator('textarea').fill('It was at hand; "quoted", with a comma.');
    }
    await this.press(this.page.locator('.study-next'), byFinger);
    await this.until(
      'the next page',
      (title) => document.querySelector('.study-card h1')?.textContent !== title,
      before,
    );
    return before;
  }

  /** Presses the button of the card that is shown, and waits for the trial's first frames. */
  async start(byFinger = false) {
    await this.untilStage(kStage.ready);
    await this.page.evaluate(() => (globalThis.__facts = null));
    await this.press(this.page.locator('.study-next'), byFinger);
    await this.untilStage(kStage.trial);
    await this.until('the trial', () => globalThis.__facts !== null && globalThis.__muster.frame?.time > 0.05);
    return this.state();
  }

  frame() {
    return this.page.evaluate(() => {
      const { frame } = globalThis.__muster;
      return { time: frame.time, x: [...frame.x], y: [...frame.y], collected: [...frame.collected] };
    });
  }

  screen(points) {
    return this.page.evaluate((list) => list.map((point) => globalThis.__muster.view.worldToScreen(point)), points);
  }

  /** Where the crowd is, and the item that is nearest to it in clear ground to its side. */
  async aim() {
    const { x, y, collected } = await this.frame();
    const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;
    const crowd = { x: mean(x), y: mean(y) };
    const items = await this.page.evaluate(() => globalThis.__facts.items.map(({ position }) => position));
    const left = items.map(([ix, iy]) => ({ x: ix, y: iy })).filter((_, i) => !collected[i]);
    const far = ({ x: ix, y: iy }) => Math.hypot(ix - crowd.x, iy - crowd.y);
    left.sort((a, b) => far(a) - far(b));
    return { crowd, item: left[0] };
  }

  untilCollected(count, timeout = 90000) {
    return this.until(
      `${count} items`,
      (wanted) => [...globalThis.__muster.frame.collected].filter(Boolean).length >= wanted,
      count,
      timeout,
    );
  }

  /** Drags the crowd with one finger to the nearest item. */
  async dragToItem() {
    const { crowd, item } = await this.aim();
    const [from, to] = await this.screen([crowd, item]);
    await this.fingers.down({ 1: from });
    await this.fingers.move({ 1: to }, { steps: 20, ms: 800 });
    await this.wait(100);
    await this.fingers.up();
  }

  /** By the full mouse: a box round all with the left button, a click with the right one. */
  async sendToItem() {
    const { mouse } = this.page;
    const { item } = await this.aim();
    const frame = await this.frame();
    const low = { x: Math.min(...frame.x) - 1, y: Math.min(...frame.y) - 1 };
    const high = { x: Math.max(...frame.x) + 1, y: Math.max(...frame.y) + 1 };
    const [from, to, goal] = await this.screen([low, high, item]);
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(to.x, to.y, { steps: 8 });
    await this.wait(80);
    await this.shot('box');
    await mouse.up();
    await mouse.click(goal.x, goal.y, { button: 'right' });
  }

  /** Ends the trial; practice only when it may end. */
  async end(byFinger = false) {
    const button = this.page.locator('.study-end');
    const { practice, trial } = await this.state();
    if (practice) {
      await this.until(
        'the end of the practice',
        () => document.querySelector('.study-end')?.disabled === false,
        null,
        300000,
      );
      await this.press(button, byFinger);
    } else {
      await this.press(button, byFinger);
      await this.press(button, byFinger);
    }
    await this.until(
      'the end of the trial',
      (before) => globalThis.__muster.study.trial !== before || globalThis.__muster.study.stage !== 2,
      trial,
    );
  }

  async shot(name) {
    await this.page.screenshot({ path: `${shots}/study-${name}-${this.size}.png` });
  }

  async close() {
    await this.context.close();
  }
}
