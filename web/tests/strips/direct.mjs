// Directing: orders, a queue, a cut, an overlay, and the demonstration with a camera that follows.

export const scenario = 'scenarios/block.json';

export async function play({ studio, hand, take, touch }) {
  const { page } = studio;
  await studio.makeRoom(0.75);
  await hand.press('.order-tile[data-tool="order"]');
  const front = await hand.around([
    [6, 7],
    [11, 4],
  ]);
  await hand.draw(front, {
    before: async () => {
      await studio.wait(500);
      await take('An order: its front is drawn');
    },
  });
  await studio.wait(400);
  if (touch) {
    await hand.press('.order-tile[aria-label="Conduct"]');
    await hand.press(page.getByRole('switch', { name: 'Add to the queue' }));
    await page.keyboard.press('Escape');
  } else await page.keyboard.down('Shift');
  const [next] = await hand.around([[12, -4]]);
  await hand.tap(next);
  if (!touch) await page.keyboard.up('Shift');
  await studio.wait(900);
  await take('Another one is queued');
  await studio.wait(2500);
  await hand.press('.order-tile[data-tool="cut"]');
  await hand.draw(
    await hand.around([
      [-5, 0.2],
      [6, 0.2],
    ]),
    { before: () => take('A cut divides the group') },
  );
  await studio.wait(2500);
  await take('Two groups');
  await page.locator('#scene').focus();
  await page.keyboard.press('d');
  await studio.wait(800);
  await take('Density on the ground');
  await page.keyboard.press('d');
  await hand.press('.playback .watch');
  await studio.until('the demonstration', () => globalThis.__muster.frame.demonstrating);
  await studio.wait(5000);
  await take('Watch: the camera follows');
}
