// The list of scenarios, every one of them, and a world with two groups.
import { expect } from '../support/expect.mjs';
import { distance, extreme, mean, points, shifted } from '../support/geometry.mjs';

/** The look promises no more draws than this in any scene. */
const kMostDraws = 60;

const drawCalls = (studio) => studio.page.evaluate(() => globalThis.__muster.view.stats.drawCalls);

async function choose(studio, item) {
  await studio.page.locator('.scenario-button').click();
  await item.click();
}

export async function scenarioPicker(studio) {
  const items = studio.page.locator('.scenario-item');
  await studio.page.locator('.scenario-button').click();
  expect((await items.count()) >= 6, `the list holds the scenarios: ${await items.count()}`);
  const [name, count] = await Promise.all([
    items.nth(1).locator('.scenario-name').textContent(),
    items.nth(1).locator('.scenario-count').textContent(),
  ]);
  await studio.shot('scenario-list');
  await studio.page.keyboard.press('Escape');
  expect(
    await studio.page.evaluate(() => document.activeElement.classList.contains('scenario-button')),
    'Escape gives the focus back',
  );
  await choose(studio, items.nth(1));
  await studio.until(
    'the chosen scenario',
    (wanted) => document.querySelector('.scenario-button .title').textContent === wanted,
    name,
  );
  await studio.until('its crowd', (n) => globalThis.__muster.frame.x.length === n, Number(count));
  expect(
    await studio.page.evaluate(() => document.activeElement.id === 'scene'),
    'a choice by mouse gives the focus to the scene',
  );
}

/** Every scenario that ships shows its crowd between the panels and keeps to the draws that the look allows. */
export async function everyScenario(studio) {
  const scenarios = await studio.page.evaluate(() => globalThis.__muster.state.scenarios);
  for (const { name, characters } of scenarios) {
    await studio.send({ type: 'LoadScenario', name });
    await studio.until(
      `the scenario ${name}`,
      ([id, n]) => {
        const { frame, state } = globalThis.__muster;
        return state.scenario === id && frame.sceneRevision > 0 && frame.x.length === n;
      },
      [name, characters],
    );
    await studio.until(
      'a picture of it',
      (frame) => globalThis.__muster.view.stats.shownFrame > frame,
      (await studio.frame()).frame,
    );
    await studio.pictures(2);
    await studio.shot(`scenario-${name.replace('/', '-')}`);
    const calls = await drawCalls(studio);
    console.log(`measured: ${name}: ${calls} draws`);
    expect(calls > 0 && calls <= kMostDraws, `${name} takes ${calls} draws, at most ${kMostDraws} allowed`);
    const seen = await studio.page.evaluate(() => {
      const { frame, view } = globalThis.__muster;
      const at = Array.from(frame.x, (x, i) => view.worldToScreen({ x, y: frame.y[i] }));
      return at.filter((p) => p.x > 0 && p.y > 0 && p.x < innerWidth && p.y < innerHeight).length / at.length;
    });
    expect(seen > 0.95, `${name} opens on its crowd: ${seen} of it is in view`);
  }
}

/** Triangles of a picture, as many as of the four before it. */
async function settledTriangles(studio) {
  const list = [];
  await studio.eventually(async () => {
    await studio.pictures(1);
    list.push(await studio.page.evaluate(() => globalThis.__muster.view.stats.triangles));
    const newest = list.slice(-5);
    expect(newest.length === 5 && newest.every((one) => one === newest[0]), `the picture settles: ${newest}`);
  });
  return list.at(-1);
}

/** What was first drawn small must not stay so: a page that saw other worlds before draws as much as a fresh one. */
export async function growingCrowd(studio) {
  const drawn = async () => {
    await studio.until('its crowd', () => globalThis.__muster.frame?.x.length === 100);
    await studio.send({ type: 'Playback', action: 1 });
    await studio.until('its bodies', () => globalThis.__muster.view.people.drawn.some((one) => one.body === 'body-1'));
    return settledTriangles(studio);
  };
  await studio.send({ type: 'LoadScenario', name: 'course' });
  const grown = await drawn();
  await studio.shot('growing-crowd');
  await studio.page.reload();
  const fresh = await drawn();
  expect(
    Math.abs(grown - fresh) < 0.02 * fresh,
    `triangles after a smaller world: ${grown}, of a fresh page: ${fresh}`,
  );
}

const verticesOf = (frame, group) => points(frame.groups[group].vertices);
const crowdOf = (frame, group) =>
  frame.x.map((x, i) => ({ x, y: frame.y[i], group: frame.groupOf[i] })).filter((one) => one.group === group);

/** The newest frame, with the group of every character: frames leave that out where it is known. */
async function wholeFrame(studio) {
  const frame = await studio.frame();
  const counts = await studio.page.evaluate(() => globalThis.__muster.state.groups.map((group) => group.count));
  return { ...frame, groupOf: counts.flatMap((count, group) => Array.from({ length: count }, () => group)) };
}

export async function twoGroups(studio) {
  const before = await wholeFrame(studio);
  const corner = extreme(verticesOf(before, 1), 0.3, 1);
  const target = shifted(corner, 1, 5);
  const [from, to] = await studio.screen([corner, target]);
  await studio.fingers.down({ 1: from });
  await studio.until('a control on the second group', () => {
    const [first, second] = globalThis.__muster.frame.groups;
    return first.controls.length === 0 && second.controls.length === 1;
  });
  await studio.fingers.move({ 1: to }, { ms: 500 });
  await studio.until(
    'the second mesh to follow',
    ([x, y]) => {
      const v = globalThis.__muster.frame.groups[1].vertices;
      return Array.from({ length: v.length / 2 }, (_, i) => Math.hypot(v[2 * i] - x, v[2 * i + 1] - y)).some(
        (d) => d < 0.8,
      );
    },
    [target.x, target.y],
    30000,
  );
  const active = () => studio.page.evaluate(() => globalThis.__muster.state.active);
  expect((await active()) === 1, 'touching a formation chooses its group');
  await studio.shot('two-groups');
  await studio.fingers.up();
  await studio.until(
    'its crowd to follow',
    ([y, first]) => {
      const { frame } = globalThis.__muster;
      const crowd = Array.from(frame.y).slice(first);
      return crowd.reduce((s, v) => s + v, 0) / crowd.length > y + 1;
    },
    [mean(crowdOf(before, 1)).y, crowdOf(before, 0).length],
    30000,
  );
  const after = await wholeFrame(studio);
  const still = Math.max(...verticesOf(after, 0).map((v, i) => distance(v, verticesOf(before, 0)[i])));
  expect(still < 0.05, `the mesh of the first group stays: ${still} m`);
  const walked = Math.max(...crowdOf(after, 0).map((p, i) => distance(p, crowdOf(before, 0)[i])));
  expect(walked < 0.3, `nobody of the first group walks: ${walked} m`);
  await chooseByChip(studio, after);
}

/** The pressed chip is what formations act on. */
async function chooseByChip(studio, before) {
  const chips = studio.page.locator('.groups .chip');
  expect((await chips.count()) === 2, 'a chip for each group');
  await chips.nth(0).click();
  expect((await chips.nth(0).getAttribute('aria-pressed')) === 'true', 'the first chip is pressed');
  expect((await chips.nth(1).getAttribute('aria-pressed')) === 'false', 'the second is not');
  await studio.page.locator('.formation', { hasText: 'Ring' }).click();
  await studio.until(
    'the ring',
    (v) => globalThis.__muster.frame.groups[0].meshVersion > v,
    before.groups[0].meshVersion,
  );
  await studio.pictures(1);
  await studio.shot('two-groups-ring');
  const after = await studio.frame();
  expect(after.groups[1].meshVersion === before.groups[1].meshVersion, 'the other group keeps its formation');
  await studio.until(
    'the pressed button',
    () => document.querySelector('.formation[aria-pressed="true"] .label')?.textContent === 'Ring',
  );
  await chips.nth(1).click();
  await studio.until(
    'the formation of the other group',
    () => document.querySelector('.formation[aria-pressed="true"] .label')?.textContent === 'Wedge',
  );
}
