// Several directors: another device comes, is seen, holds a point, and is given a group of its own.
import { Hand } from '../support/hand.mjs';
import { StudioPage } from '../support/studio_page.mjs';

export const scenario = 'web/tests/scenarios/two-groups.json';

export async function play({ studio, hand, take, touch, size }) {
  const { page } = studio;
  const other = await StudioPage.open(studio.context.browser(), page.url(), { size, touch });
  try {
    const theirs = new Hand(other, touch);
    await page.locator('.directors-button').waitFor();
    await studio.wait(500);
    await take('A second director has come');
    await hand.press('.directors-button');
    await page.locator('.directors-panel').waitFor();
    await studio.wait(300);
    await take('Who is there');
    await page.keyboard.press('Escape');
    await theirs.draw(
      await theirs.around(
        [
          [0.3, 0.3],
          [3, 3],
        ],
        0,
      ),
      {
        before: async () => {
          await studio.wait(400);
          await take('The finger of the other');
          await take('The same on their device', other);
        },
      },
    );
    await hand.press('.directors-button');
    const second = await page.evaluate(() => String(globalThis.__muster.frame.groups[1].id));
    await page.locator('.director select').nth(1).selectOption(second);
    await studio.wait(600);
    await take('They are given one group');
    await other.wait(300);
    await take('And are told so', other);
  } finally {
    await other.close();
  }
}
