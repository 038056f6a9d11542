// Places as files: saved, opened, imported, kept while somebody edits.
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect } from '../support/expect.mjs';
import { runProgram, startStudio } from '../support/server.mjs';
import { serious } from './look.mjs';
export const dialogOf = (studio) => studio.page.locator('dialog.place-dialog[open]');
export const title = (studio) => studio.page.evaluate(() => globalThis.__muster.state.title);
export const present = async (server) => JSON.parse(await (await fetch(new URL('scenario', server.url))).text());

/** Opens the dialog from the list of scenarios. */
export async function openPlaces(studio, label) {
  await studio.page.locator('.scenario-button').click();
  await studio.page.locator('.place-menu-item', { hasText: label }).click();
  await dialogOf(studio).waitFor();
}

export const untilTitle = (studio, wanted) =>
  studio.until(`the place ${wanted}`, (one) => globalThis.__muster.state.title === one, wanted);

/** Lets files fall on the page, as from a folder. */
export async function drop(studio, ...files) {
  await studio.page.evaluate(
    (list) => {
      const dataTransfer = new DataTransfer();
      for (const { name, text } of list)
        dataTransfer.items.add(new File([Uint8Array.from(atob(text), (one) => one.charCodeAt(0))], name));
      globalThis.dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true, bubbles: true }));
    },
    files.map(({ name, buffer }) => ({ name, text: Buffer.from(buffer).toString('base64') })),
  );
}

export const choose = (studio, ...files) =>
  studio.page
    .locator('input[aria-label="Open or import a place"]')
    .setInputFiles(files.map(({ name, buffer }) => ({ name, buffer, mimeType: '' })));

export async function reload(studio, url) {
  await studio.page.goto(url);
  await studio.until('the page again', () => (globalThis.__muster?.frame?.groups.length ?? 0) > 0);
}

/** Nothing of the dialog is wider than the window. */
export async function fits(studio, what) {
  const wide = await studio.page.evaluate(() => {
    const dialog = document.querySelector('dialog.place-dialog');
    const edge = dialog.getBoundingClientRect().right + 0.5;
    const beyond = [...dialog.querySelectorAll('*:not(svg *)')].filter(
      (node) => node.getClientRects().length > 0 && node.getBoundingClientRect().right > edge,
    );
    const small = [...dialog.querySelectorAll('button, input, select')]
      .filter((node) => node.getClientRects().length > 0 && node.type !== 'checkbox')
      .filter((node) => node.getBoundingClientRect().height < 43.9);
    return [...beyond, ...small].map((node) => `${node.tagName} ${node.className} ${node.textContent}`.slice(0, 60));
  });
  expect(wide.length === 0, `${what}: out of the dialog or too small: ${wide.join('; ')}`);
}

/** Save, reload, open; rename, duplicate, remove and bring back. */
export async function saveAndOpen(studio, server) {
  const { page } = studio;
  await openPlaces(studio, 'Save this place');
  const dialog = dialogOf(studio);
  await dialog.locator('input[type="text"]').fill('My square');
  await serious(studio, 'dialog for saving a place');
  await fits(studio, 'saving');
  await studio.shot('place-save');
  await dialog.locator('#place-save button[type=submit]').click();
  await studio.eventually(async () =>
    expect(/“My square” is saved/.test(await dialog.textContent()), 'the place is saved'),
  );
  await page.keyboard.press('Escape');
  await reload(studio, server.url);
  await openPlaces(studio, 'Saved places');
  const items = dialog.locator('.place-item');
  await studio.eventually(async () => expect((await items.count()) === 1, 'it is on the shelf after a reload'));
  const facts = await items.first().textContent();
  expect(/32 × 32 m · 49 people/.test(facts), `with its facts: ${facts}`);
  expect((await items.locator('img').count()) === 1, 'and a picture');
  await items.locator('button[aria-label="Duplicate My square"]').click();
  await studio.eventually(async () => expect((await items.count()) === 2, 'it is duplicated'));
  await dialog.locator('button[aria-label="Rename My square copy"]').click();
  await dialog.locator('.place-rename input').fill('Other square');
  await studio.shot('place-rename');
  await dialog.locator('.place-rename input').press('Enter');
  await studio.eventually(async () =>
    expect(/Other square/.test(await dialog.textContent()), 'the duplicate has another name'),
  );
  await serious(studio, 'saved places');
  await fits(studio, 'saved places');
  await studio.shot('place-shelf');
  await dialog.locator('button[aria-label="Remove My square"]').click();
  await studio.eventually(async () => expect((await items.count()) === 1, 'it is removed'));
  await dialog.locator('button', { hasText: 'Bring it back' }).click();
  await studio.eventually(async () => expect((await items.count()) === 2, 'and back'));
  await dialog.locator('button[aria-label="Open Other square"]').click();
  await untilTitle(studio, 'Other square');
  await dialog.waitFor({ state: 'detached' }).catch(() => undefined);
  expect((await dialog.count()) === 0, 'the dialog closes');
  expect((await present(server)).groups[0].count === 49, 'the same people stand there');
}

/** Every template opens, and what is downloaded is played by the command line to the end that the server's file has. */
export async function templates(studio, server) {
  const names = [];
  await openPlaces(studio, 'New place');
  const cards = dialogOf(studio).locator('.place-card');
  expect((await cards.count()) === 8, 'eight templates');
  await serious(studio, 'templates');
  await fits(studio, 'templates');
  await studio.shot('place-templates');
  for (let i = 0; i < 8; ++i) {
    if (i > 0) await openPlaces(studio, 'New place');
    const name = await cards.nth(i).locator('strong').textContent();
    names.push(name);
    await cards.nth(i).click();
    await untilTitle(studio, name);
    await studio.until('its people', () => globalThis.__muster.frame.groups.length > 0);
    await studio.fit();
    await studio.shot(`template-${i + 1}`);
    if (studio.size !== 'desktop' && i === 1) return;
  }
  console.log(`measured: templates: ${names.join(', ')}`);
  await openPlaces(studio, 'Save this place');
  const [download] = await Promise.all([
    studio.page.waitForEvent('download'),
    dialogOf(studio).locator('button', { hasText: 'Download' }).click(),
  ]);
  const file = `${names.at(-1).toLowerCase().replaceAll(' ', '-')}.json`;
  expect(download.suggestedFilename() === file, `${download.suggestedFilename()}, not ${file}`);
  const folder = mkdtempSync(join(tmpdir(), 'muster-place-'));
  const [mine, own] = ['downloaded.json', 'server.json'].map((name) => join(folder, name));
  await download.saveAs(mine);
  writeFileSync(own, JSON.stringify(await present(server)));
  const hashes = [mine, own].map((file) => {
    const { status, stdout, stderr } = runProgram('play', file, '--seconds', '2', '--json');
    expect(status === 0, `the command line plays ${file}: ${stderr}`);
    return JSON.parse(stdout).hash;
  });
  console.log(`measured: downloaded place plays to ${hashes[0]}`);
  expect(hashes[0] === hashes[1] && String(hashes[0]).length > 4, `the same hash: ${hashes.join(', ')}`);
  expect(readFileSync(mine).length > 100, 'and is a whole file');
}

/** What is edited is kept, and offered where the server has begun anew. */
export async function autosave(studio, server) {
  const wall = {
    kind: 'putThing',
    obstacle: {
      name: 'Wall',
      polygon: [
        [3, 3],
        [6, 3],
        [6, 3.5],
        [3, 3.5],
      ],
      height: 2,
    },
  };
  await studio.send({ type: 'Edit', label: 'Wall', gesture: 0, commands: [wall], bodies: [] });
  await studio.eventually(async () =>
    expect(
      (await present(server)).obstacles.some(({ name }) => name === 'Wall'),
      'the wall stands',
    ),
  );
  await studio.until('the copy in the browser', () => localStorage.getItem('muster.autosave') !== null);
  await reload(studio, server.url);
  await studio.wait(1500);
  expect(
    (await studio.page.locator('.place-banner:not([hidden])').count()) === 0,
    'nothing is offered while the server has it',
  );
  server.kill();
  await studio.wait(300);
  const again = await startStudio({ scenario: server.scenario, port: server.port, takes: server.takes });
  try {
    await reload(studio, again.url);
    await studio.page.locator('.place-banner').waitFor();
    const words = await studio.page.locator('.place-banner strong').textContent();
    expect(/^Your place ‘Open square’ of \d\d:\d\d is kept$/.test(words), words);
    await serious(studio, 'a kept place');
    await studio.shot('place-kept');
    await studio.page.locator('.place-banner button', { hasText: 'Open' }).click();
    await studio.eventually(async () =>
      expect(
        (await present(again)).obstacles.some(({ name }) => name === 'Wall'),
        'the wall is back',
      ),
    );
    await reload(studio, again.url);
    await studio.wait(1500);
    expect((await studio.page.locator('.place-banner:not([hidden])').count()) === 0, 'and it is not offered again');
    await openPlaces(studio, 'Saved places');
    await studio.eventually(async () =>
      expect(/Autosaved – Open square, \d\d:\d\d/.test(await dialogOf(studio).textContent()), 'it is on the shelf'),
    );
  } finally {
    await again.stop();
  }
}

const kOpen = { touch: false, scenario: 'scenarios/open.json' };

export const kPlaceCases = [
  ['place files: save and open', saveAndOpen, ['desktop', 'portrait', 'phone', 'narrow'], kOpen],
  ['place files: templates', templates, ['desktop', 'portrait', 'phone', 'narrow'], kOpen],
  ['place files: autosave', autosave, ['desktop', 'phone'], kOpen],
];
