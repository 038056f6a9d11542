// Build and motion set of a group: chosen in its panel, seen in the picture, taken back.
import { expect } from '../support/expect.mjs';
import { open, scene, screen } from './build.mjs';
import { serious } from './look.mjs';

/** The bodies that are drawn in this picture. */
const bodies = (studio) =>
  studio.page.evaluate(() =>
    globalThis.__muster.view.people.drawn.filter((one) => one.near + one.far + one.tiny > 0).map((one) => one.body),
  );

/** The names of the clips that are played. */
const clips = (studio) =>
  studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    return [...new Set(Array.from(frame.clip, (clip) => view.people.clips[clip]))];
  });

/** People are sent off; their gaits are those of marching. */
async function march(studio, group) {
  if (!(await studio.page.evaluate(() => globalThis.__muster.frame.playing)))
    await studio.send({ type: 'Playback', action: 0 });
  await studio.send({ type: 'Commands', commands: [{ kind: 'order', group, order: { target: [6, 5] } }] });
  await studio.eventually(async () => {
    const names = await clips(studio);
    expect(names.includes('march-walk') || names.includes('march-jog'), `they march: ${names}`);
    expect(!names.includes('walk') && !names.includes('jog'), `nobody walks plainly: ${names}`);
  });
}

const field = (page, name) => page.locator('.build-panel label', { hasText: name }).locator('select');

async function choose(studio, touch) {
  const { page } = studio;
  await open(studio);
  const [{ position }] = await page.evaluate(async () => (await (await fetch('/scenario')).json()).groups);
  const [at] = await screen(studio, [{ x: position[0], y: position[1] }]);
  if (touch) await page.touchscreen.tap(at.x, at.y);
  else await page.mouse.click(at.x, at.y);
  await studio.eventually(async () => expect((await bodies(studio)).length === 2, 'both bodies at first'));
  const build = field(page, 'Build');
  await build.scrollIntoViewIfNeeded();
  const box = await build.boundingBox();
  expect(!touch || box.height >= 44, `a field for fingers: ${box.height}`);
  await build.selectOption('Narrow');
  await scene(studio, 'narrow', ({ groups: [one] }) => one.definition.build === 'narrow');
  await studio.eventually(async () => {
    const shown = await bodies(studio);
    expect(shown.length === 1 && shown[0] === 'body-2', `only narrow bodies: ${shown}`);
  });
  await field(page, 'Motion set').selectOption('March');
  await scene(
    studio,
    'march',
    ({ groups: [one] }) => one.definition.motions === 'march' && one.definition.build === 'narrow',
  );
  await serious(studio, 'appearance of a group');
  await studio.shot('group-appearance');
  await page.getByRole('button', { name: 'Undo motion set' }).click();
  await scene(
    studio,
    'one step back',
    ({ groups: [one] }) => one.definition.motions === null && one.definition.build === 'narrow',
  );
  await page.getByRole('button', { name: 'Redo motion set' }).click();
  const { groups } = await scene(studio, 'and on', ({ groups: [one] }) => one.definition.motions === 'march');
  await march(studio, groups[0].id);
}

export async function byMouse(studio) {
  await choose(studio, false);
}

export async function byTouch(studio) {
  await choose(studio, true);
}
