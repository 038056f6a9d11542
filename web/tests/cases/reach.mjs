// Every panel, menu and dialog at every size: each of its controls can be hit, and nothing lies outside the window.
import { expect } from '../support/expect.mjs';
import { press, unreachable } from '../support/reach.mjs';
import { StudioPage } from '../support/studio_page.mjs';
import { pause, play, record, stop } from './takes.mjs';

/** Buttons of menus, by what their menu is called here. */
const kMenus = [
  ['places', '.scenario-button'],
  ['takes menu', '.playback .takes'],
  ['layers', '.phone-bar [aria-label="Layers"]'],
  ['more', '.phone-bar [aria-label="More"]'],
  ['directors', '.directors-button'],
  ['conduct', '.order-tile[aria-label="Conduct"]'],
  ['speed of parts', '.time-speed'],
  ['film camera', '.time-camera'],
  ['time of a person', '.path-time-open'],
  ['clip of a person', '.path-clip-open'],
  ['look of a person', '.path-look-open'],
];

/** Panels that stay until they are left: how they open, and what tells that they are. */
const kPanels = [
  ['figures', (studio) => press(studio, '.plain'), '.figure', (studio) => press(studio, '.plain')],
  ['field of obstacles', (studio) => key(studio, 'v'), '.legend', (studio) => key(studio, 'v')],
  ['cost', (studio) => key(studio, 'c'), '.legend', (studio) => key(studio, 'c')],
  ['measures', (studio) => key(studio, 'Shift+M'), '.measure-panel', (studio) => key(studio, 'Shift+M')],
  [
    'words',
    async (studio) => (await key(studio, '/')) && typed(studio, 'No'),
    '.words [role="option"]',
    (studio) => studio.page.keyboard.press('Escape'),
  ],
  ['notice', (studio) => key(studio, 'Control+z'), '.notice', (studio) => press(studio, '.notice-close')],
  ['takes shelf', (studio) => item(studio, 'All takes'), '.take-shelf', (studio) => press(studio, '.shelf-close')],
];

const kDialogs = [
  ['help', (studio) => key(studio, 'h')],
  ['control', (studio) => item(studio, 'Control')],
  ...['New place', 'Saved places', 'Import a file', 'Save this place'].map((name) => [
    name,
    async (studio) => (await press(studio, '.scenario-button')) && menuItem(studio, name),
  ]),
];

/** Of who steers. */
const kSteering = [
  ['words as a formation', (studio) => press(studio, '.formation[data-opens="text"]')],
  ['formation of one’s own', (studio) => press(studio, '.formation[data-opens="shape"]')],
  [
    'QR code',
    async (studio) => {
      if (!(await press(studio, '.formation[data-opens="shape"]'))) return false;
      await studio.page.locator('dialog[open] button', { hasText: 'QR code' }).click();
      await studio.page.locator('dialog[open] input[inputmode="url"]').fill('https://example.org/a');
      return true;
    },
  ],
  ['group to add', async (studio) => (await press(studio, '.add-group')) || (await item(studio, 'Add a group'))],
];

async function key(studio, keys) {
  await studio.page.evaluate(() => document.querySelector('#scene').focus());
  await studio.page.keyboard.press(keys);
  return true;
}

async function typed(studio, text) {
  await studio.page.locator('.words input').fill(text);
  return true;
}

const menuItem = (studio, name) =>
  studio.page.evaluate((wanted) => {
    const found = [...document.querySelectorAll('.menu-item, .place-menu-item')].find(
      (node) => node.textContent.includes(wanted) && node.getClientRects().length > 0,
    );
    found?.click();
    return found !== undefined;
  }, name);

/** An item of the menu of takes, which small windows have in More. */
async function item(studio, name) {
  const opened = (await press(studio, '.playback .takes')) || (await press(studio, '.phone-bar [aria-label="More"]'));
  return opened && menuItem(studio, name);
}

/** What is open at present, and where it fails. */
export class Reach {
  constructor(studio) {
    this.studio = studio;
    this.wrong = [];
    this.looked = [];
  }

  async look(name) {
    await this.studio.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 30))));
    const found = await unreachable(this.studio);
    this.looked.push(name);
    this.wrong.push(...found.map((what) => `${name}: ${what}`));
    if (found.length > 0) await this.studio.shot(`reach-${name.replace(/\W+/g, '-')}`);
  }

  /** Opens it, looks, and closes it. A panel that a window of this size opens otherwise is passed over. */
  async one(name, open, shown, close) {
    if (!(await open(this.studio))) return;
    await this.studio.until(
      name,
      (what) => [...document.querySelectorAll(what)].some((node) => node.checkVisibility()),
      shown,
    );
    await this.look(name);
    await close(this.studio);
  }

  async menus() {
    for (const [name, button] of kMenus) {
      if (!(await press(this.studio, button))) continue;
      await this.look(name);
      await this.studio.page.keyboard.press('Escape');
      const left = await this.studio.page.evaluate(
        () => document.activeElement.ariaLabel ?? document.activeElement.className,
      );
      const expanded = await this.studio.page.locator(`#ui ${button}`).first().getAttribute('aria-expanded');
      if (expanded !== 'false') this.wrong.push(`${name}: Escape leaves it open, with the focus on ${left}`);
    }
  }

  async dialogs(list) {
    for (const [name, open] of list) {
      if (!(await open(this.studio))) continue;
      await this.studio.page.locator('dialog[open]').waitFor();
      await this.look(name);
      await this.studio.page.keyboard.press('Escape');
      await this.studio.until(`the end of ${name}`, () => document.querySelector('dialog[open]') === null);
    }
  }

  async panels() {
    for (const [name, open, shown, close] of kPanels) await this.one(name, open, shown, close);
  }

  tell() {
    console.log(`      ${this.looked.length} looks: ${this.looked.join(', ')}`);
    expect(this.wrong.length === 0, `${this.wrong.length} cannot be hit:\n        ${this.wrong.join('\n        ')}`);
  }
}

/** Orders for a queue that has something to show. */
async function giveOrders(studio) {
  const spots = await studio.page.evaluate(() => {
    const { x, y } = globalThis.__muster.frame.groups[0];
    return [3, 6, 9].map((away) => [x + away, y + 2]);
  });
  const group = await studio.page.evaluate(() => globalThis.__muster.state.groups[0].id);
  const commands = spots.map((to, i) => ({
    kind: 'order',
    group,
    order: { target: to },
    mode: i === 0 ? 'replace' : 'append',
  }));
  await studio.send({ type: 'Playback', action: 0 });
  await studio.send({ type: 'Commands', commands });
}

export async function steering(studio, reach = new Reach(studio)) {
  await reach.look('first visit');
  await press(studio, '.hint-done');
  await reach.look('all that stands');
  for (const tab of await tabs(studio)) {
    await press(studio, `[role="tab"][data-tab="${tab}"]`);
    await reach.look(`tab ${tab}`);
    await reach.menus();
    if (tab === 'formation') await reach.dialogs(kSteering);
  }
  await reach.dialogs(kDialogs);
  await reach.panels();
  await key(studio, 'Shift+E');
  await studio.page.locator('.build-panel').waitFor();
  const hiddenTools = await studio.page.evaluate(() => {
    const { scrollWidth, clientWidth } = document.querySelector('.build-tools');
    return scrollWidth - clientWidth;
  });
  expect(hiddenTools <= 0, `${hiddenTools} px of the tools are out of sight`);
  for (const tool of await studio.page
    .locator('.build-tool')
    .count()
    .then((count) => [...Array(count).keys()])) {
    await studio.page.evaluate((n) => document.querySelectorAll('.build-tool')[n].click(), tool);
    await reach.look(`build ${tool}`);
  }
  await mistake(studio);
  await reach.look('what does not fit');
  await key(studio, 'Shift+E');
  await giveOrders(studio);
  await press(studio, '[role="tab"][data-tab="orders"]');
  await studio.until('the queue', () => document.querySelector('.queue-chip')?.checkVisibility());
  await press(studio, '.queue-chip');
  await reach.look('queue');
  if (await press(studio, '.queue-act[aria-label="On the way"]')) {
    await studio.page.locator('.sequence').waitFor();
    await reach.look('formations along the way');
    await press(studio, '.sequence button[aria-label^="Close"]');
  }
  await record(studio, 0.3);
  await reach.look('recording');
  await stop(studio);
  await reach.look('card of a take');
  if (await press(studio, '.order-tile[aria-label="Conduct"]')) await reach.look('conduct beside the card');
  await studio.page.keyboard.press('Escape');
  await press(studio, '.card-close');
  reach.tell();
}

/** A hedge that nobody can jump over, where the camera looks. */
async function mistake(studio) {
  await studio.page.evaluate(async () => {
    const { clips } = await (await globalThis.__muster.ask('scenario')).json();
    const { x, y } = globalThis.__muster.frame.groups[0];
    const polygon = [
      [x - 2, y - 3],
      [x + 2, y - 3],
      [x + 2, y - 2],
      [x - 2, y - 2],
    ];
    const patch = { name: 'Hedge', polygon, motion: clips.findIndex(({ name }) => name === 'jump') };
    const commands = [{ kind: 'putThing', patch }];
    globalThis.__muster.client.send({ type: 'Edit', label: 'Hedge', gesture: 0, commands, bodies: [] });
  });
  await studio.page.locator('.build-note').waitFor();
}

/** The tabs of the sheet; one nameless where the window has room for all. */
async function tabs(studio) {
  const names = await studio.page.evaluate(() =>
    [...document.querySelectorAll('[role="tab"]')]
      .filter((node) => node.checkVisibility())
      .map((node) => node.dataset.tab),
  );
  return names.length > 0 ? names : ['formation'];
}

export async function watching(studio, reach = new Reach(studio)) {
  await record(studio, 0.6);
  await stop(studio);
  await play(studio);
  await pause(studio);
  await reach.look('time line');
  await reach.menus();
  await reach.dialogs(kDialogs);
  await reach.panels();
  await press(studio, '.time-path');
  await studio.page.locator('.path-bar').waitFor();
  await key(studio, 'v');
  await key(studio, 'Control+z');
  await studio.page.locator('.notice').waitFor();
  await reach.look('path, legend and a notice');
  await key(studio, 'v');
  await press(studio, '.path-whose button:last-child');
  const { x, y } = await studio.frame();
  const [person] = await studio.screen([{ x: x[0], y: y[0] }]);
  await studio.fingers.down({ 1: person });
  await studio.fingers.up();
  await studio.page.locator('.path-time-open').waitFor();
  await press(studio, '.path-pin-add');
  await reach.look('path of a person');
  await reach.menus();
  await press(studio, '.path-close');
  await unfolded(studio, reach);
  await press(studio, '.time-export');
  await studio.page.locator('.export-dialog[open]').waitFor();
  await reach.look('export');
  for (const kind of await studio.page
    .locator('.export-kind input')
    .count()
    .then((count) => [...Array(count).keys()])) {
    await studio.page.evaluate((n) => document.querySelectorAll('.export-kind input')[n].click(), kind);
    await reach.look(`export ${kind}`);
  }
  reach.tell();
  await exportKeepsFocus(studio);
}

/** The tracks of a take, with nothing chosen, a block, and a view of the camera. */
async function unfolded(studio, reach) {
  await press(studio, '.time-tracks');
  await studio.until('a block', () => document.querySelector('.track-block')?.checkVisibility(), null, 30000);
  await reach.look('tracks');
  await press(studio, '.track-block');
  await reach.look('tracks, a block');
  await press(studio, '.track-camera .track-name button');
  await studio.until('a view', () => document.querySelector('.track-key') !== null);
  await press(studio, '.track-key');
  await reach.look('tracks, a view');
  await press(studio, '.time-tracks');
}

/** After an export the dialog has the focus, so that Escape closes it. */
async function exportKeepsFocus(studio) {
  await studio.page.locator('.export-kind input').nth(1).check();
  await studio.page.locator('.export-begin').press('Enter');
  await studio.until('the picture', () => /Saved/.test(document.querySelector('.export-said').textContent));
  const inside = await studio.page.evaluate(() => document.activeElement.closest('.export-dialog') !== null);
  expect(inside, 'after an export the focus is in its dialog');
  await studio.page.keyboard.press('Escape');
  await studio.until('the end of the export', () => !document.querySelector('.export-dialog[open]'));
}

const kAllSizes = ['wide', 'landscape', 'tablet', 'portrait', 'phone'];
/** Two groups, and an invitation to direct. */
export const kTogether = {
  scenario: 'web/tests/scenarios/two-groups.json',
  options: ['--lan'],
  search: '?quality=light',
  everySize: true,
};

/** What is told and asked where others direct. */
async function together(studio) {
  const other = await StudioPage.open(studio.context.browser(), studio.page.url(), { size: studio.size });
  try {
    await studio.until('the other', () => globalThis.__muster.state.directors.length === 2);
    const reach = new Reach(studio);
    await other.send({ type: 'Playback', action: 1 });
    await studio.page.locator('.shared-banner').waitFor();
    await reach.look('somebody paused');
    await other.send({ type: 'AskOthers', request: 'open Open square' });
    await studio.page.locator('.shared-banner', { hasText: 'Allow' }).waitFor();
    await reach.look('somebody asks');
    const choose = async () => (await press(studio, '.scenario-button')) && press(studio, '.scenario-item');
    await reach.dialogs([['to change the place', choose]]);
    reach.tell();
  } finally {
    await other.close();
  }
}

export const kReachCases = [
  ['reach: steering', (studio) => steering(studio), kAllSizes, { ...kTogether, hint: true }],
  ['reach: watching a take', (studio) => watching(studio), kAllSizes, kTogether],
  ['reach: directing together', (studio) => together(studio), kAllSizes, kTogether],
];
