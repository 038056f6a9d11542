// Several directors on one world: names, colours, who holds what, groups of their own, and the invitation.
import { expect } from '../support/expect.mjs';
import { layout } from './look.mjs';
import { kSizes, StudioPage } from '../support/studio_page.mjs';

const kCorner = { x: 0.3, y: 0.3 };

/** Another page on the same studio, in a browser of its own. */
function second(studio, options = {}) {
  return StudioPage.open(studio.context.browser(), studio.page.url(), { size: studio.size, ...options });
}

async function openPanel(studio) {
  await studio.page.locator('.directors-button').click();
  await studio.page.locator('.directors-panel').waitFor();
}

/** A box is on the screen, whole. */
async function expectInside(studio, selector) {
  const box = await studio.page.locator(selector).boundingBox();
  const { width, height } = kSizes[studio.size];
  expect(
    box.x >= 0 && box.y >= 0 && box.x + box.width <= width + 0.5 && box.y + box.height <= height + 0.5,
    `${selector} is on the screen: ${JSON.stringify(box)}`,
  );
}

const rows = (studio) =>
  studio.page.locator('.director').evaluateAll((all) =>
    all.map((row) => ({
      name: row.querySelector('input')?.value ?? row.querySelector('.director-name').textContent,
      holds: row.querySelector('.holds').textContent,
      colour: getComputedStyle(row.querySelector('.face')).backgroundColor,
    })),
  );

/** Two people direct: each sees the other's name, colour and finger; one is given a group and can direct no other. */
export async function twoDirectors(studio) {
  expect(!(await studio.page.locator('.directors').isVisible()), 'who is alone sees no list');
  const other = await second(studio);
  try {
    await studio.page.locator('.directors-button').waitFor();
    await layout(studio);
    await openPanel(other);
    await other.page.locator('input.director-name').fill('Ben');
    await other.page.locator('input.director-name').press('Enter');
    await openPanel(studio);
    await studio.eventually(async () => expect((await rows(studio))[1].name === 'Ben', 'the name has come'));
    const [mine, theirs] = await rows(studio);
    expect(mine.colour !== theirs.colour, 'colours differ');
    await expectInside(studio, '.directors-panel');
    await other.page.keyboard.press('Escape');
    await fingerOfAnother(studio, other);
    await oneGroupOnly(studio, other);
    await other.page.reload();
    await other.until('the first frame', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
    await studio.eventually(async () => expect((await rows(studio))[1]?.name === 'Ben', 'the browser kept the name'));
  } finally {
    await other.close();
  }
  await studio.page.locator('.directors').waitFor({ state: 'hidden' });
}

/** The finger of another is seen with who holds it, and lifts when that page is closed. */
async function fingerOfAnother(studio, other) {
  const group = (await other.frame()).groups[0];
  const [at] = await other.screen([{ x: group.x + kCorner.x, y: group.y + kCorner.y }]);
  await other.fingers.down({ 1: at });
  await other.fingers.move({ 1: { x: at.x + 20, y: at.y + 12 } }, { steps: 4, ms: 120 });
  await studio.eventually(async () => expect(/^holds /.test((await rows(studio))[1].holds), 'who holds what is told'));
  await studio.pictures(2);
  await studio.shot('directors');
  const marks = await studio.page.evaluate(() => globalThis.__muster.view.marks_.others.size);
  expect(marks === 1, `a ring for the other's finger: ${marks}`);
  await other.fingers.up();
}

async function oneGroupOnly(studio, other) {
  const [first, wanted] = (await studio.frame()).groups;
  await studio.page.locator('.director select').nth(1).selectOption(String(wanted.id));
  await other.page.locator('.notice', { hasText: 'to direct' }).waitFor();
  await other.send({
    type: 'Commands',
    commands: [{ kind: 'changeGroup', group: first.id, formation: { kind: 'ring' } }],
  });
  await other.page.locator('.notice', { hasText: 'not yours to direct' }).waitFor();
  await other.send({
    type: 'Commands',
    commands: [{ kind: 'changeGroup', group: wanted.id, formation: { kind: 'ring' } }],
  });
  await studio.eventually(async () => {
    const { groups } = await studio.page.evaluate(() => globalThis.__muster.state);
    expect(groups[1].formation === 'ring' && groups[0].formation !== 'ring', 'only their own group changed');
  });
}

/** A studio for the network shows its link and code. */
export async function invitation(studio) {
  await openPanel(studio);
  await studio.page.locator('.invitation svg.qr').waitFor();
  const link = await studio.page.locator('.invitation code').textContent();
  expect(/^http:\/\/[\d.]+:\d+\/\?token=[0-9a-f]{32}$/.test(link), `the link: ${link}`);
  await expectInside(studio, '.directors-panel');
  await studio.shot('invitation');
}

const playing = (studio, wanted) =>
  studio.until('the world to ' + (wanted ? 'play' : 'wait'), (on) => globalThis.__muster.state.playing === on, wanted);
const banner = (studio, text) => studio.page.locator('.shared-banner', { hasText: text });
const press = (studio, name) => studio.page.getByRole('button', { name, exact: true }).click();

async function named(page, name) {
  await page.send({ type: 'SetName', name });
}

/** Who pauses and who builds is named to the other, who can play; after building the world goes on. */
export async function sharedClock(studio) {
  const ada = await second(studio);
  try {
    await named(ada, 'Ada');
    await studio.page.locator('.directors-button').waitFor();
    await ada.send({ type: 'Playback', action: 1 });
    await banner(studio, 'Ada paused.').waitFor();
    expect(!(await banner(ada, 'paused').isVisible()), 'who paused is not told');
    await expectInside(studio, '.shared-banner');
    await studio.shot('shared-paused');
    await banner(studio, 'Ada paused.').locator('button', { hasText: 'Play' }).click();
    await playing(ada, true);
    await ada.page.keyboard.press('Shift+E');
    await banner(studio, 'Ada is building; the world waits.').waitFor();
    await studio.shot('shared-building');
    await playing(studio, false);
    await ada.page.keyboard.press('Shift+E');
    await playing(studio, true);
    await banner(studio, 'building').waitFor({ state: 'hidden' });
  } finally {
    await ada.close();
  }
}

/** Who would change the place asks the other; both can go back to the place as it was. */
export async function sharedPlace(studio) {
  const ada = await second(studio);
  try {
    await named(ada, 'Ada');
    await studio.page.locator('.directors-button').waitFor();
    await ada.until('the other', () => globalThis.__muster.state.directors.length === 2);
    const { title, scenario } = await studio.page.evaluate(() => globalThis.__muster.state);
    await studio.until('a second', () => globalThis.__muster.frame.step > 60);
    const wish = async () => {
      await ada.page.locator('.scenario-button').click();
      await ada.page.locator('.scenario-item', { hasText: 'Open square' }).first().click();
      await ada.page.locator('.consent').waitFor();
    };
    await wish();
    expect(
      /directing here.*Change the place for all\?/.test(await ada.page.locator('.consent h2').textContent()),
      'it asks',
    );
    await ada.shot('shared-consent');
    await press(ada, 'Ask them');
    await banner(studio, 'Ada would like to open Open square.').waitFor();
    await studio.shot('shared-asked');
    await expectInside(studio, '.shared-banner');
    await press(studio, 'Not now');
    await ada.page.locator('.consent h2', { hasText: 'would rather not now' }).waitFor();
    await press(ada, 'Cancel');
    expect((await studio.page.evaluate(() => globalThis.__muster.state.scenario)) === scenario, 'nothing changed');
    await wish();
    await press(ada, 'Ask them');
    await banner(studio, 'Ada would like to').waitFor();
    await press(studio, 'Allow');
    await banner(studio, 'Ada opened Open square.').waitFor();
    await studio.shot('shared-changed');
    const step = (await studio.frame()).step;
    await press(studio, `Back to ${title}`);
    await studio.until('the place', (name) => globalThis.__muster.state.scenario === name, scenario);
    expect(step < 60 && (await studio.frame()).step > 60, 'it goes on where it was');
    await banner(ada, `went back to ${title}.`).waitFor();
    await wish();
    await press(ada, 'Change for all');
    await banner(studio, 'Ada opened Open square.').waitFor();
    await banner(ada, 'Open square is open for all.')
      .locator('button', { hasText: `Back to ${title}` })
      .click();
    await studio.until('the place', (name) => globalThis.__muster.state.scenario === name, scenario);
  } finally {
    await ada.close();
  }
}
