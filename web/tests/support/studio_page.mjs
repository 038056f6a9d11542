// The page under test: what it shows, and where things are on it.
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Fingers } from './fingers.mjs';

const shots = fileURLToPath(new URL('../../test-results/', import.meta.url));
mkdirSync(shots, { recursive: true });

export const SIZES = {
  wide: { width: 1440, height: 900 },
  desktop: { width: 1280, height: 800 },
  landscape: { width: 1180, height: 820 },
  portrait: { width: 820, height: 1180 },
  phone: { width: 390, height: 844 },
  narrow: { width: 360, height: 740 },
  /** The desktop at 200 %. */
  zoomed: { width: 640, height: 400 },
};

export class StudioPage {
  static async open(browser, url, { size = 'desktop', touch = true, colorScheme = 'light', hint = false } = {}) {
    const context = await browser.newContext({ viewport: SIZES[size], colorScheme, hasTouch: touch });
    const page = await context.newPage();
    const studio = new StudioPage(context, page, size);
    page.on('pageerror', (error) => studio.errors.push(error.message));
    page.on('console', (message) => {
      // Lost servers and refused takes are part of the tests.
      const expected = /WebSocket|status of 400|ERR_CONNECTION/.test(message.text());
      if (message.type() === 'error' && !expected) studio.errors.push(message.text());
    });
    if (!hint) await page.addInitScript(() => localStorage.setItem('muster.hint', 'seen'));
    studio.cdp = await context.newCDPSession(page);
    if (touch) await studio.cdp.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 10 });
    studio.fingers = new Fingers(studio.cdp);
    await page.goto(url);
    await studio.until('the first frame', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
    await studio.wait(300);
    return studio;
  }

  constructor(context, page, size) {
    this.context = context;
    this.page = page;
    this.size = size;
    this.errors = [];
  }

  wait(ms) {
    return new Promise((resolve) => setTimeout(resolve, ms));
  }

  /** Waits until the function is true in the page. */
  async until(what, test, argument, timeout = 15000) {
    try {
      await this.page.waitForFunction(test, argument, { timeout, polling: 50 });
    } catch (error) {
      throw new Error(`waited in vain for ${what}: ${String(error).split('\n')[0]}`);
    }
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
    await this.wait(350);
  }

  /** Zooms out so that there is room to drag. */
  async makeRoom(factor = 0.62) {
    await this.page.evaluate((zoom) => {
      const { view } = globalThis.__muster;
      view.camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, zoom);
    }, factor);
    await this.wait(120);
  }

  /** Begins the world anew and lets it play. */
  async restart() {
    const revision = await this.page.evaluate(() => globalThis.__muster.frame.sceneRevision);
    await this.send({ type: 'Transport', action: 3 });
    await this.until('the world anew', (before) => globalThis.__muster.frame.sceneRevision > before, revision);
    await this.send({ type: 'Transport', action: 0 });
    await this.send({ type: 'SetSpeed', factor: 1 });
  }

  shot(name) {
    return this.page.screenshot({ path: `${shots}${name}-${this.size}.png` });
  }

  close() {
    return this.context.close();
  }
}
