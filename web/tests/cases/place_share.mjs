// A place keeps its name on the server, and is shared by links.
import { serious } from './look.mjs';
import { expect } from '../support/expect.mjs';
import { startStudio } from '../support/server.mjs';
import { StudioPage } from '../support/studio_page.mjs';
import { dialogOf, openPlaces, present, reload } from './place_files.mjs';

const nameOf = (studio) => studio.page.locator('.scenario-button .title').textContent();

async function savePlace(studio, name) {
  await openPlaces(studio, 'Save this place');
  await dialogOf(studio).locator('#place-save input[type=text]').fill(name);
}

const wallAt = (x) => ({ kind: 'putThing', obstacle: { name: 'Wall', centre: [x, 5], radius: 0.5 } });

/** A place keeps its name, on the server too: after a restart the studio is in it again, and a link opens it. */
async function keptByName(studio, server) {
  await studio.send({ type: 'Edit', label: 'Wall', gesture: 0, commands: [wallAt(5)], bodies: [] });
  await studio.eventually(async () => expect((await present(server)).obstacles.length === 1, 'the wall stands'));
  await savePlace(studio, 'My yard');
  await dialogOf(studio).getByRole('button', { name: 'Save', exact: true }).click();
  await dialogOf(studio).locator('[role=status]', { hasText: '“My yard” is saved: it stands in the list' }).waitFor();
  expect((await nameOf(studio)) === 'My yard', `the title: ${await nameOf(studio)}`);
  await dialogOf(studio).getByRole('button', { name: 'Share…' }).click();
  const share = studio.page.locator('.share-dialog');
  await share.waitFor();
  const link = await share.locator('input').first().inputValue();
  expect(link === `${server.url}#scenario=places/my-yard`, `the link: ${link}`);
  expect(/Only this computer can open this link/.test(await share.textContent()), 'it tells who can open it');
  await studio.shot('place-share');
  await serious(studio, 'a shared place');
  await studio.page.keyboard.press('Escape');
  await studio.page.keyboard.press('Escape');
  // Another place is tried and edited, and left again.
  await studio.send({ type: 'LoadScenario', name: 'open' });
  await studio.until('another place', () => globalThis.__muster.state.scenario === 'open');
  await studio.send({ type: 'Edit', label: 'Wall', gesture: 0, commands: [wallAt(7)], bodies: [] });
  await studio.until('its copy', () => localStorage.getItem('muster.autosave') === 'Open square', null, 8000);
  await studio.page.goto(link);
  await studio.until('the place of the link', () => globalThis.__muster?.state?.scenario === 'places/my-yard');
  server.kill();
  await studio.wait(300);
  const again = await startStudio({ scenario: '', port: server.port, takes: server.takes });
  try {
    await reload(studio, again.url);
    await studio.until('the place again', () => globalThis.__muster.state.title === 'My yard');
    expect((await present(again)).obstacles.length === 1, 'with its wall');
    await studio.wait(1500);
    expect((await studio.page.locator('.place-banner:not([hidden])').count()) === 0, 'no other place is offered');
    await studio.page.locator('.scenario-button').click();
    await studio.page.locator('.scenario-group', { hasText: 'Kept here' }).waitFor();
    await studio.shot('place-kept-list');
  } finally {
    await again.stop();
  }
}

/** The crowd of a place that ships goes on to be drawn when the place is shared. */
async function crowdOfAShared(studio) {
  const triangles = () => studio.page.evaluate(() => globalThis.__muster.view.stats.triangles);
  const before = await triangles();
  await openPlaces(studio, 'Save this place');
  await dialogOf(studio).getByRole('button', { name: 'Share…' }).click();
  await studio.page.locator('.share-dialog').waitFor();
  await studio.page.keyboard.press('Escape');
  await studio.page.keyboard.press('Escape');
  await studio.until('the new name', () => globalThis.__muster.state.scenario.startsWith('places/'));
  await studio.pictures(3);
  const after = await triangles();
  expect(after > 0.8 * before, `people and formations are drawn: ${after} triangles, ${before} before`);
  await studio.shot('place-shared-crowd');
}

/** On a studio for the network the link is that of the network, with its code; and by a site, where one is known. */
async function sharedByNetwork(studio) {
  await savePlace(studio, 'Our yard');
  await dialogOf(studio).getByRole('button', { name: 'Share…' }).click();
  const share = studio.page.locator('.share-dialog');
  await share.locator('svg.qr').waitFor();
  const [link, site] = await share.locator('input').evaluateAll((all) => all.map(({ value }) => value));
  expect(/^http:\/\/[\d.]+:\d+\/\?token=[0-9a-f]{32}#scenario=places\/our-yard$/.test(link), `the link: ${link}`);
  expect(/^https:\/\/example\.org\/crowd\/#place=[\w-]{200,}$/.test(site), `by the site: ${site}`);
  await studio.shot('place-share-network');
  const guest = await StudioPage.open(studio.context.browser(), link, { size: studio.size });
  try {
    await guest.until('the place', () => globalThis.__muster.state.scenario === 'places/our-yard');
    await guest.wait(500);
    expect((await guest.page.locator('.consent[open]').count()) === 0, 'who is there already is not asked');
  } finally {
    await guest.close();
  }
}

export const kShareCases = [
  ['place files: kept by name', keptByName, ['desktop', 'phone'], { touch: false, scenario: 'scenarios/open.json' }],
  ['places: the crowd of a shared one', crowdOfAShared, ['tablet'], { scenario: 'scenarios/fountain.json' }],
  [
    'place files: shared by network',
    sharedByNetwork,
    ['desktop', 'phone'],
    { scenario: 'scenarios/open.json', options: ['--lan', '--site', 'https://example.org/crowd/'] },
  ],
];
