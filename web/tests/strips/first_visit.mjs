// The first visit: the square with the fountain, the hand that shows how, the hint that ticks off what is done.

export const scenario = 'scenarios/fountain.json';
export const hint = true;

export async function play({ studio, hand, take }) {
  await take('Opened');
  await studio.until('the hand', () => Number(document.querySelector('.ghost')?.style.opacity) > 0.9);
  await studio.wait(900);
  await take('A hand shows how to drag');
  await studio.until('the hand to go', () => document.querySelector('.ghost') === null);
  const [a, b] = await hand.around([
    [0, 0],
    [3, -3],
  ]);
  await hand.draw([a, b], { before: () => take('One point is dragged') });
  await studio.wait(400);
  await hand.carry(
    await hand.around([
      [-2, -2],
      [2, -2],
    ]),
    { x: 30, y: 40 },
    { before: () => take('Two: a line') },
  );
  await studio.wait(400);
  const three = await hand.around([
    [-2, -1.5],
    [2, -1.5],
    [0, 2],
  ]);
  await hand.carry(three, { x: 24, y: -30 }, { before: () => take('Three: an area') });
  const { width, height } = studio.page.viewportSize();
  await hand.draw([
    { x: width * 0.42, y: height * 0.58 },
    { x: width * 0.46, y: height * 0.54 },
  ]);
  await studio.wait(1500);
  await take('All is done: the hint has gone');
}
