// One hand on the page: a mouse on desktops, real fingers on tablets and phones. The same job is done with either.

const kWait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** The keys that make one mouse stand for so many fingers. */
const kHeld = { 2: 'Shift', 3: 'Control' };

export class Hand {
  constructor(studio, touch) {
    this.studio = studio;
    this.touch = touch;
  }

  /** Presses a control, which is scrolled into view. */
  async press(target) {
    const { page, fingers } = this.studio;
    const locator = typeof target === 'string' ? page.locator(target).first() : target.first();
    await locator.waitFor();
    await locator.scrollIntoViewIfNeeded();
    const box = await locator.boundingBox();
    await this.tap({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, fingers);
  }

  /** Presses a spot [client px]. */
  async tap(at) {
    const { page, fingers } = this.studio;
    if (!this.touch) return page.mouse.click(at.x, at.y);
    await fingers.down({ 1: at });
    await kWait(50);
    await fingers.up();
  }

  /** Draws along the spots; `before` runs before the hand lifts. */
  async draw(spots, { ms = 700, before = async () => undefined } = {}) {
    const { page, fingers } = this.studio;
    const [first, ...rest] = spots;
    if (this.touch) {
      await fingers.down({ 1: first });
      for (const spot of rest) await fingers.move({ 1: spot }, { steps: 12, ms: ms / rest.length });
      await before();
      return fingers.up();
    }
    await page.mouse.move(first.x, first.y);
    await page.mouse.down();
    for (const spot of rest) await page.mouse.move(spot.x, spot.y, { steps: 12 });
    await before();
    await page.mouse.up();
  }

  /** Two or three fingers on these spots that go the same way; a mouse spans a line or a lasso first, then draws it along. */
  async carry(spots, by, { before = async () => undefined } = {}) {
    const { page, fingers } = this.studio;
    const moved = (at) => ({ x: at.x + by.x, y: at.y + by.y });
    if (this.touch) {
      await fingers.down(Object.fromEntries(spots.map((at, i) => [i + 1, at])));
      await fingers.move(Object.fromEntries(spots.map((at, i) => [i + 1, moved(at)])), { steps: 14, ms: 800 });
      await before();
      return fingers.up();
    }
    await page.keyboard.down(kHeld[spots.length]);
    await this.draw(spots.length > 2 ? [...spots, spots[0]] : spots);
    await page.keyboard.up(kHeld[spots.length]);
    await kWait(150);
    const middle = (k) => spots.reduce((sum, at) => sum + at[k] / spots.length, 0);
    const from = { x: middle('x'), y: middle('y') };
    await this.draw([from, moved(from)], { before });
  }

  /** Types into a field of a panel. */
  async type(target, text) {
    const locator = typeof target === 'string' ? this.studio.page.locator(target).first() : target.first();
    await locator.fill(text);
    await locator.press('Enter');
  }

  /** Spots of the ground on the screen, told from the middle of a group [m]. */
  around(offsets, group = 0) {
    return this.studio.page.evaluate(
      ([list, k]) => {
        const { view, frame } = globalThis.__muster;
        const { x, y } = frame.groups[k];
        return list.map(([dx, dy]) => view.worldToScreen({ x: x + dx, y: y + dy }));
      },
      [offsets, group],
    );
  }
}
