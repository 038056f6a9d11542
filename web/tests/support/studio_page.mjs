// The page under test: what it shows, and where things are on it.
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { DrivenPage } from './driven_page.mjs';
import { Fingers } from './fingers.mjs';
import { countWebgl } from './webgl_counts.mjs';

const shots = fileURLToPath(new URL('../../test-results/', import.meta.url));
mkdirSync(shots, { recursive: true });

export const kSizes = {
  wide: { width: 1440, height: 900 },
  desktop: { width: 1280, height: 800 },
  landscape: { width: 1180, height: 820 },
  tablet: { width: 1024, height: 768 },
  portrait: { width: 820, height: 1180 },
  phone: { width: 390, height: 844 },
  narrow: { width: 360, height: 740 },
  /** The desktop at 200 %. */
  zoomed: { width: 640, height: 400 },
};

export class StudioPage extends DrivenPage {
  static async open(
    browser,
    url,
    { size = 'desktop', touch = true, colorScheme = 'light', hint = false, counts = false, ratio = 1 } = {},
  ) {
    const screen = { viewport: kSizes[size], deviceScaleFactor: ratio };
    const context = await browser.newContext({ ...screen, colorScheme, hasTouch: touch });
    const page = await context.newPage();
    const studio = new StudioPage(context, page, size);
    page.on('pageerror', (error) => studio.errors.push(error.message));
    page.on('console', (message) => {
      // Lost servers and refused takes are part of the tests.
      const expected = /WebSocket|status of 400|ERR_CONNECTION/.test(message.text());
      if (message.type() === 'error' && !expected) studio.errors.push(message.text());
    });
    if (counts) await page.addInitScript(countWebgl);
    if (!hint) await page.addInitScript(() => localStorage.setItem('muster.hint', 'seen'));
    studio.cdp = await context.newCDPSession(page);
    if (touch) await studio.cdp.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 10 });
    studio.fingers = new Fingers(studio.cdp);
    await page.goto(url);
    await studio.until('the first frame', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
    await studio.until('the first picture', () => globalThis.__muster.view.stats.shownFrame > 0);
    return studio;
  }

  /** Asks for a lost connection at once, and waits for it. */
  async connected() {
    await this.page
      .locator('.banner', { hasText: 'Try now' })
      .locator('button', { hasText: 'Try now' })
      .click({ timeout: 1500 })
      .catch(() => undefined);
    await this.until(
      'the connection',
      () => globalThis.__muster.connected && !document.documentElement.hasAttribute('data-lost'),
      null,
      20000,
    );
  }

  /** Tries until the expectations hold: what the world or the page needs a moment for. */
  async eventually(test, timeout = 15000) {
    const end = Date.now() + timeout;
    for (;;) {
      try {
        return await test();
      } catch (error) {
        if (Date.now() > end) throw error;
      }
      await this.wait(50);
    }
  }

  /** Waits for so many more pictures, or until the page has none to draw. */
  async pictures(count) {
    await this.page.evaluate(
      (more) =>
        new Promise((done) => {
          const { stats } = globalThis.__muster.view;
          const [wanted, end] = [stats.pictures + more, performance.now() + 1000];
          const look = () =>
            stats.pictures >= wanted || performance.now() > end ? done() : requestAnimationFrame(look);
          look();
        }),
      count,
    );
  }

  /** Waits until the camera has arrived where it goes, and for a picture of that. */
  async cameraAtRest() {
    await this.until('the camera to arrive', () => globalThis.__muster.view.camera.atRest);
    await this.pictures(1);
  }

  /** The newest frame, with plain arrays. */
  frame() {
    return this.page.evaluate(() => {
      const { frame, client } = globalThis.__muster;
      const plain = (value) => {
        if (ArrayBuffer.isView(value)) return [...value];
        if (Array.isArray(value)) return value.map(plain);
        if (value !== null && typeof value === 'object')
          return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, plain(v)]));
        return value;
      };
      return { ...plain(frame), me: client.clientId };
    });
  }

  send(message) {
    return this.page.evaluate((one) => globalThis.__muster.client.send(one), message);
  }

  /** World [m] to client px, for several points. */
  screen(points) {
    return this.page.evaluate((list) => list.map((point) => globalThis.__muster.view.worldToScreen(point)), points);
  }

  /** Brings the crowd into view wherever an earlier case left it. */
  async fit() {
    await this.page.evaluate(() => globalThis.__muster.view.fitCrowd());
    await this.cameraAtRest();
  }

  /** Zooms out so that there is room to drag. */
  async makeRoom(factor = this.size === 'phone' ? 0.42 : 0.62) {
    await this.page.evaluate((zoom) => {
      const { view } = globalThis.__muster;
      view.camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, zoom);
    }, factor);
    await this.pictures(1);
  }

  /** As a page that was just opened: the camera as it opens, a world begun anew, no finger down. */
  async renew() {
    this.errors.length = 0;
    await this.fingers.up();
    await this.page.evaluate(() => globalThis.__muster.view.camera.open());
    await this.restart();
  }

  /** Begins the world anew and lets it play. */
  async restart() {
    const revision = await this.page.evaluate(() => globalThis.__muster.frame.sceneRevision);
    await this.send({ type: 'Playback', action: 3 });
    await this.until('the world anew', (before) => globalThis.__muster.frame.sceneRevision > before, revision);
    await this.send({ type: 'Playback', action: 0 });
    await this.send({ type: 'SetSpeed', factor: 1 });
  }

  /** Chooses what the sheet of a phone shows; wider windows show all of it. */
  async tab(name) {
    const tab = this.page.locator(`[role="tab"][data-tab="${name}"]`);
    if (await tab.isVisible()) await tab.click();
  }

  shot(name) {
    return this.page.screenshot({ path: `${shots}${name}-${this.size}.png` });
  }

  close() {
    return this.context.close();
  }
}
