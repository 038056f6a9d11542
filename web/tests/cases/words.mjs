// Directing by words: a sentence is shown before it is done, done by Enter, and taken back in one step.
import { expect } from '../support/expect.mjs';

const kSentence = 'half of North to the fountain in a ring, the rest hold';

const said = (studio) => studio.page.locator('#words-said').textContent();

async function openLine(studio) {
  if (studio.size === 'phone') {
    await studio.tab('orders');
    await studio.page.locator('.order-tile[data-tool="words"]').click();
  } else {
    await studio.page.evaluate(() => document.querySelector('#scene').focus());
    await studio.page.keyboard.press('/');
  }
  await studio.page.locator('.words input').waitFor();
}

function groupsToBe(studio, count) {
  return studio.until(`${count} groups`, (n) => globalThis.__muster.frame.groups.length === n, count, 20000);
}

/** A name that is begun can be completed by keys, and a wrong word is named. */
async function completes(studio) {
  const { page } = studio;
  await page.keyboard.type('Nor');
  await page.locator('.words [role="option"]', { hasText: 'North' }).first().waitFor();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  expect((await page.locator('.words input').inputValue()) === 'North ', 'the name is completed');
  await page.keyboard.type('go to the fountin');
  await studio.eventually(async () => {
    const text = await said(studio);
    expect(text.includes('fountin') && text.includes('did you mean Fountain'), `a hint: ${text}`);
  });
  await studio.shot('words-problem');
}

async function directByWords(studio) {
  const { page } = studio;
  await openLine(studio);
  await completes(studio);
  const before = await studio.frame();
  await page.locator('.words input').fill(kSentence);
  await studio.eventually(async () => {
    const text = await said(studio);
    expect(/32 of North go to Fountain in a ring/.test(text), `what would be done: ${text}`);
    expect(/the rest of North \(32\) holds/i.test(text), `what the rest would do: ${text}`);
  });
  await studio.pictures(3);
  await studio.shot('words-preview');
  expect((await studio.frame()).groups.length === before.groups.length, 'a preview changes nothing');
  await page.keyboard.press('Enter');
  await groupsToBe(studio, before.groups.length + 1);
  await studio.until(
    'orders of the part',
    () => globalThis.__muster.frame.groups.at(-1).orders.length === 1,
    null,
    20000,
  );
  await studio.eventually(async () => {
    const { groups } = await studio.frame();
    const part = groups.at(-1);
    expect(part.orders[0].formation?.kind === 'ring' && groups[0].held, 'a ring, and the rest holds');
  });
  const undo = await page.evaluate(() => globalThis.__muster.state.history);
  expect(undo.undo === 1 && undo.undoLabel === kSentence, `one step of the history: ${JSON.stringify(undo)}`);
  await studio.shot('words-done');
  await page.keyboard.press('Escape');
  await page.locator('.words').waitFor({ state: 'hidden' });
  await page.keyboard.press('z');
  await groupsToBe(studio, before.groups.length);
  await studio.until('that it is undone', () => !globalThis.__muster.frame.groups[0].held);
}

const kMarket = { touch: false, scenario: 'scenarios/market.json', everySize: true };

export const kWordsCases = [['words', directByWords, ['desktop', 'portrait', 'phone'], kMarket]];
