// Making a place: a template, then obstacles, a wall and a net, and people who go through it.

export const scenario = 'scenarios/open.json';

const tool = (studio, name) => studio.page.locator('.build-panel').getByRole('button', { name, exact: true });

export async function play({ studio, hand, take }) {
  const { page } = studio;
  await hand.press('.scenario-button');
  await studio.wait(300);
  await take('The list of places');
  await hand.press(page.locator('.scenario').getByText('New place'));
  await page.locator('.place-card').first().waitFor();
  await studio.wait(400);
  await take('New place: templates');
  await hand.press('.place-card');
  await studio.until(
    'the new place',
    () => !document.querySelector('dialog[open]') && globalThis.__muster.frame.groups.length > 0,
  );
  await studio.wait(800);
  await hand.press(page.getByRole('button', { name: 'Build', exact: true }));
  await page.locator('.build-panel').waitFor();
  await studio.wait(300);
  await take('Build');
  await hand.press(tool(studio, 'Box'));
  await hand.draw(
    await hand.around([
      [4, -3],
      [6, -0.5],
    ]),
    { before: () => take('A box is drawn') },
  );
  await hand.press(tool(studio, 'Wall'));
  await hand.draw(
    await hand.around([
      [4, 1.5],
      [4, 5],
    ]),
  );
  await hand.press(tool(studio, 'Net'));
  await hand.draw(
    await hand.around([
      [5.5, 1],
      [8, 3.5],
    ]),
  );
  await studio.wait(600);
  await take('A wall and ground to crawl on');
  await hand.press(page.getByRole('button', { name: 'Build', exact: true }));
  await hand.draw(
    await hand.around([
      [0, 0],
      [8, 2],
    ]),
    { ms: 900 },
  );
  await studio.send({ type: 'Playback', action: 0 });
  await studio.wait(4500);
  await take('People find their way through it');
}
