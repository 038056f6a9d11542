// Takes: recorded, named, played, scrubbed and trimmed, exported, and found on the shelf.

export const scenario = 'scenarios/block.json';

export async function play({ studio, hand, take, size }) {
  const { page } = studio;
  await hand.press('.record');
  await studio.until('the record clock', () => globalThis.__muster.frame.recordedSeconds >= 0);
  await hand.draw(
    await hand.around([
      [0, 0],
      [4, 5],
      [9, 6],
    ]),
    { ms: 1500, before: () => take('Recording') },
  );
  await studio.wait(1500);
  await hand.press('.record');
  await page.locator('.take-card:not([hidden])').waitFor();
  await studio.wait(700);
  await take('The take: name and length');
  await hand.press('.card-play');
  await page.locator('.time-line:not([hidden])').waitFor();
  await studio.wait(900);
  await take('Played on the time line');
  await studio.send({ type: 'Playback', action: 1 });
  const box = await page.locator('.time-track').boundingBox();
  const at = (share) => ({ x: box.x + box.width * share, y: box.y + box.height / 2 });
  await hand.draw([at(0.3), at(0.7), at(0.5)], { ms: 900 });
  await hand.draw([at(0.995), at(0.85)]);
  await studio.wait(500);
  await take('Scrubbed and trimmed');
  await hand.press(page.locator('.time-line').getByText('Export'));
  await page.locator('dialog[open]').waitFor();
  await studio.wait(400);
  await take('Export');
  await page.keyboard.press('Escape');
  await hand.press('.time-close');
  if (size === 'phone') {
    await hand.press('.phone-bar button[aria-label="More"]');
    await hand.press(page.locator('.phone-menu .menu-item', { hasText: 'All takes' }));
  } else {
    await hand.press('.playback .takes');
    await hand.press(page.locator('.take-list .menu-item', { hasText: 'All takes' }));
  }
  await page.locator('.take-shelf:not([hidden])').waitFor();
  await studio.wait(600);
  await take('The shelf');
}
