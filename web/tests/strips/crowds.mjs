// Making a crowd: a new group, its formation, one that is drawn, one that is written, and one of one's own.

export const scenario = 'scenarios/open.json';

const formation = (studio, name) => studio.page.locator('.formation', { hasText: name });

export async function play({ studio, hand, take }) {
  const { page } = studio;
  const dialog = page.locator('dialog.shape-dialog[open]');
  await studio.makeRoom(0.7);
  await hand.press('.add-group');
  await dialog.locator('input').nth(0).fill('Visitors');
  await dialog.locator('input').nth(1).fill('24');
  await dialog.locator('select').selectOption('ring');
  await take('A new group');
  await hand.press(dialog.locator('button[type="submit"]'));
  const [spot] = await hand.around([[1, 10]]);
  await hand.tap(spot);
  await studio.until('the group', () => globalThis.__muster.frame.groups.length === 2);
  await studio.wait(500);
  await take('It is put down');
  await hand.press(page.locator('.chip').nth(0));
  await hand.press(formation(studio, 'Wedge'));
  await studio.wait(3500);
  await take('Wedge');
  await hand.press(formation(studio, 'Draw'));
  const triangle = [0, 1, 2, 3].map((k) => [7 * Math.cos(2.1 * k + 0.7), 7 * Math.sin(2.1 * k + 0.7)]);
  await hand.draw(await hand.around(triangle), { ms: 1200, before: () => take('A formation is drawn') });
  await studio.wait(600);
  await hand.press(formation(studio, 'Text'));
  await dialog.locator('input').fill('HI');
  await hand.press(dialog.locator('button[type="submit"]'));
  await studio.wait(6000);
  await take('A word');
  await hand.press(formation(studio, 'More'));
  await dialog.waitFor();
  await studio.wait(400);
  await take('More: mirror, turn, save');
}
