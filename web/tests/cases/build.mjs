// Building a place: drawn, moved, undone, chosen, told to others.
import { expect } from '../support/expect.mjs';
import { serious } from './look.mjs';

/** Spots of the world on the screen, between the panels; they stay while the camera stays. */
export const screen = (studio, points) =>
  studio.page.evaluate((list) => list.map((p) => globalThis.__muster.view.worldToScreen(p)), points);

export async function open(studio) {
  await studio.page.evaluate(() => {
    globalThis.__scenes = [];
    globalThis.__muster.client.on('scene', (scene) => globalThis.__scenes.push(scene));
  });
  await studio.tab('view');
  await studio.page.getByRole('button', { name: 'Build', exact: true }).click();
  await studio.page.locator('.build-panel').waitFor();
  await studio.until('paused', () => !globalThis.__muster.state.playing);
}

/** The newest scene, once `test` holds of it. */
export async function scene(studio, what, test) {
  let last = null;
  await studio.eventually(async () => {
    last = await studio.page.evaluate(() => globalThis.__scenes.at(-1) ?? null);
    expect(last !== null && test(last), what);
  });
  return last;
}

export const tool = (studio, name) =>
  studio.page.locator('.build-panel').getByRole('button', { name, exact: true }).click();

export async function drag(studio, from, to, options = {}) {
  const [a, b] = await screen(studio, [from, to]);
  if (options.touch) {
    await studio.fingers.down({ 1: a });
    await studio.fingers.move({ 1: b }, { steps: 6, ms: 120 });
    await studio.fingers.up();
    return;
  }
  const { mouse } = studio.page;
  await mouse.move(a.x, a.y);
  await mouse.down();
  await mouse.move((a.x + b.x) / 2, (a.y + b.y) / 2, { steps: 3 });
  await mouse.move(b.x, b.y, { steps: 3 });
  await mouse.up();
}

async function press(studio, at) {
  const [p] = await screen(studio, [at]);
  await studio.page.mouse.click(p.x, p.y);
}

export const near = (a, b, reach = 0.6) => Math.hypot(a[0] - b[0], a[1] - b[1]) <= reach;

/** Every tool by mouse, with undo and redo, several at once, and the keyboard. */
export async function byMouse(studio) {
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Box');
  await drag(studio, { x: 2, y: -3 }, { x: 4, y: -1 });
  let now = await scene(studio, 'a box', (one) => one.obstacles.length === 1);
  expect(near(now.obstacles[0].polygon[0], [2, -3]), `where it was drawn: ${JSON.stringify(now.obstacles[0].polygon)}`);
  await page.keyboard.press('v');
  await drag(studio, { x: 3, y: -2 }, { x: 3, y: 2 });
  now = await scene(studio, 'moved by four metres', (one) => near(one.obstacles[0].polygon[0], [2, 1]));
  await page.getByRole('button', { name: 'Undo move' }).click();
  await scene(studio, 'back', (one) => one.obstacles[0].polygon[0][1] < 0);
  await page.keyboard.press('Control+Shift+Z');
  await scene(studio, 'moved again', (one) => one.obstacles[0].polygon[0][1] > 0);
  await tool(studio, 'Pillar');
  await drag(studio, { x: -3, y: 3 }, { x: -3, y: 4 });
  await tool(studio, 'Item');
  await press(studio, { x: -2, y: -3 });
  await tool(studio, 'Checkpoint');
  await drag(studio, { x: 5, y: 4 }, { x: 5, y: 5.5 });
  await tool(studio, 'Net');
  await drag(studio, { x: -5, y: -1 }, { x: -3, y: 1 });
  now = await scene(studio, 'all of them', (one) => one.patches.length === 1 && one.items.length === 1);
  expect(now.obstacles.length === 2 && Math.abs(now.obstacles[1].radius - 1) < 0.3, 'a disc');
  expect(now.clips[now.patches[0].motion].name === 'crawl', 'a patch on which people crawl');
  expect(now.checkpoints.length === 1 && now.checkpoints[0].radius > 1, 'a checkpoint');
  await studio.shot('build');
  await tool(studio, 'Wall');
  await page.locator('.build-panel').getByLabel('Width [m]').fill('0.5');
  await page.locator('.build-panel').getByLabel('Width [m]').press('Enter');
  await drag(studio, { x: -1, y: 5 }, { x: 3, y: 5 });
  now = await scene(studio, 'a wall', (one) => one.obstacles.length === 3);
  const ys = now.obstacles[2].polygon.map(([, y]) => y);
  expect(Math.abs(Math.max(...ys) - Math.min(...ys) - 0.5) < 0.01, 'as wide as was typed');
  await tool(studio, 'Polygon');
  for (const corner of [
    { x: 5, y: -4 },
    { x: 7, y: -4 },
    { x: 6, y: -2 },
  ])
    await press(studio, corner);
  await page.keyboard.press('Enter');
  await scene(studio, 'a polygon', (one) => one.obstacles.length === 4);
  await tool(studio, 'Route');
  await drag(studio, { x: 3, y: 2 }, { x: 6, y: 2 });
  now = await scene(studio, 'a mover', (one) => one.obstacles.some(({ path }) => path.loop));
  await tool(studio, 'People');
  await page.locator('.build-panel').getByLabel('People', { exact: true }).fill('9');
  await page.locator('.build-panel').getByLabel('People', { exact: true }).press('Enter');
  await drag(studio, { x: -4, y: -5 }, { x: -4, y: -3 });
  now = await scene(studio, 'people', (one) => one.groups.length === 2);
  expect(now.groups[1].count === 9 && Math.abs(now.groups[1].definition.angle - Math.PI / 2) < 0.2, 'who face north');
  await tool(studio, 'Select');
  await page.keyboard.press('Control+a');
  const before = now.obstacles.length + now.patches.length + now.items.length + now.checkpoints.length;
  expect(before === 7, `seven things lie there: ${before}`);
  await page.keyboard.press('Escape');
  await drag(studio, { x: -1.5, y: 5.8 }, { x: 3.5, y: 4.2 });
  await page.keyboard.press('Delete');
  await scene(studio, 'without the wall', (one) => one.obstacles.length === 3);
  await page.keyboard.press('Control+z');
  await scene(studio, 'with the wall', (one) => one.obstacles.length === 4);
  const saved = await page.evaluate(async () => (await globalThis.__muster.ask('scenario')).json());
  expect(saved.obstacles.length === 4 && saved.groups.length === 2, 'all of it is in the file');
  await studio.tab('view');
  await page.getByRole('button', { name: 'Build', exact: true }).click();
  expect(!(await page.locator('.build-panel').isVisible()), 'the panel is gone');
}

/** Numbers, layers, gaps and ground that cannot be reached. */
export async function numbers(studio) {
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Box');
  await drag(studio, { x: 3, y: 3 }, { x: 5, y: 5 });
  let now = await scene(studio, 'a box', (one) => one.obstacles.length === 1);
  await tool(studio, 'Select');
  await page.locator('.build-panel').getByLabel('Name', { exact: true }).fill('Kiosk');
  await page.locator('.build-panel').getByLabel('Name', { exact: true }).press('Enter');
  await scene(studio, 'its name', (one) => one.obstacles[0].name === 'Kiosk');
  await page.locator('.build-panel').getByLabel('Height [m]').fill('4.5');
  await page.locator('.build-panel').getByLabel('Height [m]').press('Enter');
  await scene(studio, 'its height', (one) => one.obstacles[0].height === 4.5);
  await page.locator('.build-panel').getByLabel('X [m]').fill('-4');
  await page.locator('.build-panel').getByLabel('X [m]').press('Enter');
  now = await scene(studio, 'its place', (one) => one.obstacles[0].polygon[0][0] < 0);
  expect(near(now.obstacles[0].polygon[0], [-5, 3], 0.2), 'where it was typed');
  await page.locator('.build-layers summary').click();
  await page.locator('.build-panel').getByLabel('Lock obstacles').check();
  const [at] = await screen(studio, [{ x: -4, y: 4 }]);
  await page.mouse.click(at.x, at.y);
  expect((await page.locator('.build-chosen-fields h3').count()) === 0, 'what is locked cannot be chosen');
  await page.locator('.build-panel').getByLabel('Lock obstacles').uncheck();
  await page.locator('.build-panel').getByLabel('Hide obstacles').check();
  await studio.eventually(async () =>
    expect((await page.locator('.build-layer .build-obstacle').count()) === 0, 'what is hidden is not drawn'),
  );
  await page.locator('.build-panel').getByLabel('Hide obstacles').uncheck();
  await page.evaluate(() => {
    const walls = [
      [3, -6, 7, -5.7],
      [3, -2.3, 7, -2],
      [3, -5.7, 3.3, -2.3],
      [6.7, -5.5, 7, -2.3],
    ].map(([x0, y0, x1, y1]) => ({
      kind: 'putThing',
      obstacle: {
        polygon: [
          [x0, y0],
          [x1, y0],
          [x1, y1],
          [x0, y1],
        ],
      },
    }));
    globalThis.__muster.client.send({ type: 'Edit', label: 'Walls', gesture: 0, commands: walls, bodies: [] });
  });
  await page.locator('.build-gap-label').first().waitFor();
  const shown = await page.evaluate(() => ({
    label: document.querySelector('.build-gap-label').textContent,
    area: document.querySelector('.build-unreached').getAttribute('d').length,
  }));
  expect(shown.label === '0.2 m' && shown.area > 50, `a gap of 0.2 m, and ground behind it: ${JSON.stringify(shown)}`);
  await studio.shot('build-gaps');
  await serious(studio, 'building');
}

/** The same with fingers: three that tap take the last step back. */
export async function byTouch(studio) {
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Box');
  const spots = [
    { x: 1, y: 2 },
    { x: 3, y: 3.5 },
  ];
  await drag(studio, ...spots, { touch: true });
  await scene(studio, 'a box', (one) => one.obstacles.length === 1);
  await studio.shot('build-touch');
  await tool(studio, 'Select');
  await drag(studio, { x: 2, y: 2.7 }, { x: -1, y: 2.7 }, { touch: true });
  await scene(studio, 'moved by three metres', (one) => near(one.obstacles[0].polygon[0], [-2, 2]));
  const [a, b, c] = await screen(studio, [
    { x: 0, y: 1 },
    { x: 1.5, y: 1 },
    { x: 3, y: 1 },
  ]);
  await studio.fingers.down({ 1: a, 2: b, 3: c });
  await studio.fingers.up();
  await scene(studio, 'three fingers take it back', (one) => one.obstacles[0].polygon[0][0] > 0);
  const pose = await page.evaluate(() => ({ ...globalThis.__muster.view.camera.pose }));
  await studio.fingers.down({ 1: a, 2: c });
  await studio.fingers.move({ 1: { x: a.x - 40, y: a.y }, 2: { x: c.x + 40, y: c.y } });
  await studio.fingers.up();
  const after = await page.evaluate(() => ({ ...globalThis.__muster.view.camera.pose }));
  expect(after.distance < 0.95 * pose.distance, 'two fingers zoom');
  await serious(studio, 'building by touch');
}

/** What a group of people is: typed, dragged by a slider, and where its class stands. */
export async function bodies(studio) {
  const { page } = studio;
  await open(studio);
  const [{ position: at }] = await page.evaluate(
    async () => (await (await globalThis.__muster.ask('scenario')).json()).groups,
  );
  const edits = await watchEdits(studio);
  await press(studio, { x: at[0], y: at[1] });
  const panel = page.locator('.build-panel');
  await panel.getByLabel('Body radius [m]').fill('0.35');
  await panel.getByLabel('Body radius [m]').press('Tab');
  await scene(studio, 'wider people', ({ groups: [one] }) => one.body.radius === 0.35);
  expect((await edits()).length === 1, 'one edit for a typed number');
  const slider = panel.getByLabel('Top speed, slider');
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  expect(box.height >= 44, `a slider for fingers: ${box.height}`);
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width * 0.35, y);
  await page.mouse.down();
  for (let k = 0; k < 16; ++k) {
    await page.mouse.move(box.x + box.width * (0.35 + 0.03 * k), y);
    await studio.wait(30);
  }
  await scene(studio, 'the world follows', ({ groups: [one] }) => one.body.maxSpeed > 3);
  await page.mouse.up();
  const sent = (await edits()).slice(1);
  expect(sent.length >= 3 && new Set(sent.map(({ gesture }) => gesture)).size === 1, `one drag: ${sent.length}`);
  await panel.getByRole('combobox', { name: 'Class', exact: true }).selectOption('2');
  await scene(studio, 'a class', ({ groups: [one] }) => one.body.unitClass === 2);
  await panel.getByLabel('Class 2 stands').selectOption('Rim');
  await scene(studio, 'a role', ({ groups: [one] }) => one.definition.roles[0]?.area === 'rim');
  await panel.getByLabel('Class 2 stands').scrollIntoViewIfNeeded();
  await studio.shot('build-bodies');
  await serious(studio, 'bodies of people');
  const [saved] = await page.evaluate(async () => (await (await globalThis.__muster.ask('scenario')).json()).groups);
  expect(saved.bodies[0].radius === 0.35 && saved.bodies[0].class === 2, 'all of it is in the file');
  for (const name of ['Undo role', 'Undo class', 'Undo top speed', 'Undo body radius'])
    await page.getByRole('button', { name }).click();
  await scene(studio, 'as before', ({ groups: [one] }) => {
    const { radius, maxSpeed, unitClass } = one.body;
    return radius === 0.25 && maxSpeed === 2 && unitClass === 0 && one.definition.roles.length === 0;
  });
}

/** Numbers of the edits that the page has sent, with the time of each [ms]. */
async function watchEdits(studio) {
  await studio.page.evaluate(() => {
    const { client } = globalThis.__muster;
    const send = client.send.bind(client);
    globalThis.__edits = [];
    client.send = (message) => {
      if (message.type === 'Edit') globalThis.__edits.push({ gesture: message.gesture, at: performance.now() });
      return send(message);
    };
  });
  return () => studio.page.evaluate(() => globalThis.__edits);
}

/** The middle of a handle. It is drawn anew whenever the scene comes. */
async function handleAt(studio, shape) {
  const at = await studio.page.waitForFunction((name) => {
    const handle = document.querySelector(`.build-layer ${name}.build-handle`);
    const { x, y, width, height } = handle?.getBoundingClientRect() ?? {};
    return handle && { x: x + width / 2, y: y + height / 2 };
  }, shape);
  return at.jsonValue();
}

/** A box that is dragged, and what the first drag of it did is there for the next one at once. */
export async function dragsInARow(studio) {
  const { page } = studio;
  await open(studio);
  await tool(studio, 'Box');
  await drag(studio, { x: 1, y: 1 }, { x: 3, y: 3 });
  await scene(studio, 'a box', (one) => one.obstacles.length === 1);
  await page.keyboard.press('v');
  const edits = await watchEdits(studio);
  const [a, b] = await screen(studio, [
    { x: 2, y: 2 },
    { x: -2, y: 2 },
  ]);
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  for (let k = 1; k <= 24; ++k) {
    await page.mouse.move(a.x + ((b.x - a.x) * k) / 24, a.y + ((b.y - a.y) * k) / 24);
    await studio.wait(30);
  }
  await scene(studio, 'the world has followed', (one) => one.obstacles[0].polygon[0][0] < -1);
  const during = await edits();
  expect(during.length >= 3, `edits while it was dragged: ${during.length}`);
  expect(new Set(during.map(({ gesture }) => gesture)).size === 1 && during[0].gesture !== 0, 'of one number');
  const apart = during.slice(1).map(({ at }, k) => at - during[k].at);
  // The page notes the time before, so some milliseconds are lost where it is busy.
  expect(Math.min(...apart) >= 80, `at most ten a second: ${apart.map(Math.round).join()}`);
  await page.mouse.up();
  // At once: by the handle at its lower right corner, from where the drag has left it.
  const grip = await handleAt(studio, 'rect');
  await page.mouse.move(grip.x, grip.y);
  await page.mouse.down();
  await page.mouse.move(grip.x + 24, grip.y + 24, { steps: 3 });
  await page.mouse.up();
  let now = await scene(studio, 'scaled', ({ obstacles: [box] }) => box.polygon[1][0] - box.polygon[0][0] > 2.2);
  const middle = (box) => (box.polygon[0][0] + box.polygon[2][0]) / 2;
  expect(Math.abs(middle(now.obstacles[0]) + 2) < 0.1, `where it was dragged to: ${middle(now.obstacles[0])}`);
  expect(new Set((await edits()).map(({ gesture }) => gesture)).size === 2, 'two drags have two numbers');
  await page.getByRole('button', { name: 'Undo scale' }).click();
  now = await scene(
    studio,
    'as large as before',
    ({ obstacles: [box] }) => box.polygon[1][0] - box.polygon[0][0] < 2.1,
  );
  expect(Math.abs(middle(now.obstacles[0]) + 2) < 0.1, 'and where it was');
  await page.getByRole('button', { name: 'Undo move' }).click();
  await scene(studio, 'where it was drawn', ({ obstacles: [box] }) => box.polygon[0][0] === 1);
  await page.getByRole('button', { name: 'Undo add box' }).waitFor();
  await givenUp(studio);
}

/** A drag that is given up by Escape goes back, and is no step of the history. */
async function givenUp(studio) {
  const { page } = studio;
  const [a, b] = await screen(studio, [
    { x: 2, y: 2 },
    { x: 2, y: -2 },
  ]);
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps: 5 });
  await scene(studio, 'it follows', ({ obstacles: [box] }) => box.polygon[0][1] < 0);
  await page.keyboard.press('Escape');
  await scene(studio, 'it is back', ({ obstacles: [box] }) => box.polygon[0][1] === 1);
  await page.mouse.up();
  await page.getByRole('button', { name: 'Undo add box' }).waitFor();
}

/** The same with a finger: people are dragged, and turned at once. */
export async function dragsByTouch(studio) {
  const { page, fingers } = studio;
  await open(studio);
  const edits = await watchEdits(studio);
  const [{ position: at, angle = 0 }] = await page.evaluate(
    async () => (await (await globalThis.__muster.ask('scenario')).json()).groups,
  );
  const [a, b] = await screen(studio, [
    { x: at[0], y: at[1] },
    { x: at[0] + 3, y: at[1] },
  ]);
  await fingers.down({ 1: a });
  await fingers.move({ 1: b }, { steps: 20, ms: 700 });
  expect((await edits()).length >= 3, 'the world is told while the finger is down');
  await fingers.up();
  const from = await handleAt(studio, 'circle');
  const [middle] = await screen(studio, [{ x: at[0] + 3, y: at[1] }]);
  await fingers.down({ 1: from });
  await fingers.move({ 1: { x: middle.x - (middle.y - from.y), y: middle.y } }, { steps: 6, ms: 150 });
  await fingers.up();
  const now = await scene(
    studio,
    'turned to the left',
    ({ groups: [one] }) => Math.abs(one.definition.angle - angle - Math.PI / 2) < 0.3,
  );
  expect(
    near(now.groups[0].definition.position, [at[0] + 3, at[1]], 0.6),
    `and moved: ${now.groups[0].definition.position}`,
  );
  await page.getByRole('button', { name: 'Undo turn' }).click();
  await scene(studio, 'not turned', ({ groups: [one] }) => one.definition.angle === angle);
  await page.getByRole('button', { name: 'Undo move' }).click();
  await scene(studio, 'not moved', ({ groups: [one] }) => near(one.definition.position, at, 1e-9));
}
