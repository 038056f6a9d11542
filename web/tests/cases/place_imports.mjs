// Files of other programs that become places: plans of towns, models, grid maps.
import { inSight } from '../support/reach.mjs';
import { expect } from '../support/expect.mjs';
import { madeCharacter } from '../support/made_glb.mjs';
import { madeMap, madeModel, madeObj, madeTown } from '../support/made_places.mjs';
import { serious } from './look.mjs';
import { choose, dialogOf, drop, fits, openPlaces, present, reload, title, untilTitle } from './place_files.mjs';

const obstacles = (studio) =>
  studio.page.evaluate(() => ({
    shown: globalThis.__muster.view.solid.length,
    notice: globalThis.__muster.state.notice?.text,
  }));

/** GeoJSON by picker as a new place, and by drop into the present one, which one undo takes back. */
export async function importTown(studio, server) {
  await openPlaces(studio, 'Import a file');
  const dialog = dialogOf(studio);
  await choose(studio, { name: 'old_town.geojson', buffer: madeTown({ bad: 2 }) });
  await dialog.locator('.place-import:not([hidden])').waitFor();
  const said = () => dialog.locator('.place-import .place-note').textContent();
  await studio.eventually(async () => expect(/obstacles on 80 × 48 m/.test(await said()), `measured: ${await said()}`));
  expect(
    /3 of 7 outlines were left out: .*2 cross themselves/.test(await said()),
    `and what is left out: ${await said()}`,
  );
  await studio.wait(200);
  await serious(studio, 'import of GeoJSON');
  await fits(studio, 'import');
  await inSight(dialog.locator('.place-acts button'));
  await studio.shot('place-import-town');
  await dialog.locator('label', { hasText: 'Scale' }).locator('input').fill('0.5');
  await studio.eventually(async () => expect(/on 4\d × \d+ m/.test(await said()), `half as large: ${await said()}`));
  await dialog.locator('label', { hasText: 'Scale' }).locator('input').fill('');
  await studio.eventually(async () => expect(/number is missing/.test(await said()), 'an empty field is told of'));
  await dialog.locator('label', { hasText: 'Scale' }).locator('input').fill('1');
  await dialog.locator('button', { hasText: 'New place' }).click();
  await untilTitle(studio, 'Old town');
  await studio.fit();
  await studio.wait(400);
  await studio.shot('place-town');
  const town = await present(server);
  const heights = town.obstacles.map(({ height }) => height);
  expect(heights.includes(15) && heights.includes(40) && heights.includes(2.2), `heights are read: ${heights}`);
  const names = town.obstacles.map(({ name }) => name);
  expect(names.includes('Tower'), 'and names');
  // The courtyard is open ground.
  const before = town.obstacles.length;
  await drop(studio, { name: 'again.json', buffer: madeTown({ bad: 0 }) });
  await dialog.locator('.place-import:not([hidden])').waitFor();
  await dialog.locator('label', { hasText: 'Scale' }).locator('input').fill('0.2');
  await studio.wait(400);
  await studio.shot('place-import-add');
  await dialog.locator('button', { hasText: 'Add to this place' }).click();
  await studio.eventually(async () =>
    expect((await present(server)).obstacles.length > before, 'obstacles are added to the place'),
  );
  const { notice } = await obstacles(studio);
  // What the new walls do to the crowd may be told after it.
  expect(/obstacles are added|is cut off/.test(notice ?? ''), `it is told: ${notice}`);
  await studio.send({ type: 'UndoEdit', redo: false });
  await studio.eventually(async () =>
    expect((await present(server)).obstacles.length === before, 'one undo takes all of them back'),
  );
}

/** OBJ and GLB: footprints in the place, the model on the screen, also after a reload. */
export async function importModels(studio, server) {
  const dialog = dialogOf(studio);
  await openPlaces(studio, 'Import a file');
  await choose(studio, { name: 'yard.obj', buffer: madeObj() });
  const note = dialog.locator('.place-import .place-note');
  await studio.eventually(async () =>
    expect(/2 obstacles on/.test(await note.textContent()), await note.textContent()),
  );
  await studio.wait(200);
  await serious(studio, 'import of a model');
  await fits(studio, 'import of a model');
  await studio.shot('place-import-obj');
  await dialog.locator('button', { hasText: 'New place' }).click();
  await untilTitle(studio, 'Yard');
  const yard = await present(server);
  const byName = Object.fromEntries(yard.obstacles.map((one) => [one.name, one]));
  expect(
    byName['yard.obj: Hut']?.height === 2.95,
    `a hut of 3 m on its floor: ${JSON.stringify(yard.obstacles).slice(0, 300)}`,
  );
  expect(byName['yard.obj: Bench']?.height === 0.45, 'and a bench of half a metre');
  await studio.eventually(async () =>
    expect((await obstacles(studio)).shown === 0, 'the model is shown in place of its footprints'),
  );
  await studio.fit();
  await studio.wait(400);
  await studio.shot('place-yard');
  await reload(studio, server.url);
  await studio.eventually(async () => expect((await obstacles(studio)).shown === 0, 'also after a reload'));
  // A GLB by drop, added beside it, without being shown.
  const small = { Statue: [[0, 0, 1, 2.5, 1]] };
  await drop(studio, { name: 'statue.glb', buffer: madeModel({ objects: small, shift: 5 }) });
  await dialog.locator('.place-import:not([hidden])').waitFor();
  await dialog.locator('.place-check input').uncheck();
  await dialog.locator('label', { hasText: 'Added at' }).locator('input').fill('5');
  await dialog.locator('button', { hasText: 'Add to this place' }).click();
  await studio.eventually(async () =>
    expect(
      (await present(server)).obstacles.some(({ name, height }) => name === 'statue.glb: Statue' && height === 2.5),
      'the statue stands in the place',
    ),
  );
  await studio.eventually(async () => expect((await obstacles(studio)).shown === 1, 'and is drawn as an obstacle'));
  await drop(studio, { name: 'hall.glb', buffer: madeModel() });
  await dialog.locator('.place-import:not([hidden])').waitFor();
  await studio.eventually(async () => expect(/2 obstacles/.test(await note.textContent()), 'a whole yard as GLB'));
  await dialog.locator('button', { hasText: 'New place' }).click();
  await untilTitle(studio, 'Hall');
  await studio.fit();
  await studio.wait(400);
  await studio.shot('place-hall');
}

/** A grid map becomes a place that embeds it. */
export async function importMap(studio, server) {
  await drop(studio, { name: 'rooms.txt', buffer: madeMap() });
  const dialog = dialogOf(studio);
  await dialog.locator('.place-import:not([hidden])').waitFor();
  expect(
    !(await dialog.locator('button', { hasText: 'Add to this place' }).isVisible()),
    'a map is a place of its own',
  );
  await dialog.locator('label', { hasText: 'People' }).locator('input').fill('20');
  await dialog.locator('label', { hasText: 'Cell' }).locator('input').fill('2');
  await studio.wait(400);
  await serious(studio, 'import of a map');
  await studio.shot('place-import-map');
  await dialog.locator('button', { hasText: 'New place' }).click();
  await untilTitle(studio, 'Rooms');
  const place = await present(server);
  expect(place.map.rows.length === 16 && place.map.metresPerCell === 2, 'the map is in the file');
  expect(place.groups[0].count === 20, 'with twenty people');
  await studio.fit();
  await studio.wait(400);
  await studio.shot('place-map');
}

const kSmallMap = `type octile
height 8
width 12
map
@@@@@@@@@@@@
@..@...@...@
@..@.WWW.@.@
@....WWW.@.@
@..@.....@.@
@..@@@.@@@.@
@..........@
@@@@@@@@@@@@
`;
const kPond = (at) => ({
  type: 'Feature',
  properties: { natural: 'water', name: 'Pond' },
  geometry: { type: 'Polygon', coordinates: [at] },
});

/** All of the place can be seen. */
async function allInSight(studio, [[left, low], [right, high]]) {
  await studio.eventually(async () => {
    const spots = await studio.page.evaluate(
      (list) => list.map(([x, y]) => globalThis.__muster.view.worldToScreen({ x, y })),
      [
        [left, low],
        [right, low],
        [right, high],
        [left, high],
      ],
    );
    const { width, height } = studio.page.viewportSize();
    const out = spots.filter(({ x, y }) => x < 0 || y < 0 || x > width || y > height);
    expect(out.length === 0, `corners in sight: ${JSON.stringify(spots)}`);
  });
}

/** What is imported has water, people stand on its free ground, both buttons are in sight, and then all of it. */
export async function importWater(studio, server) {
  await drop(studio, { name: 'small.map', buffer: Buffer.from(kSmallMap) });
  const dialog = dialogOf(studio);
  await dialog.locator('.place-import:not([hidden])').waitFor();
  await inSight(dialog.locator('.place-acts button:visible'));
  await studio.shot('place-import-small');
  expect(/There is room for \d+ people/.test(await dialog.textContent()), 'the room is told');
  await dialog.locator('button', { hasText: 'New place' }).click();
  await untilTitle(studio, 'Small');
  const small = await present(server);
  const rows = kSmallMap.split('\n').slice(4);
  const free = ([x, y]) => rows[7 - Math.floor(y)][Math.floor(x)] === '.';
  await studio.until('its people', () => globalThis.__muster.frame.x.length < 49);
  const stand = await studio.page.evaluate(() => {
    const { x, y } = globalThis.__muster.frame;
    return Array.from(x, (one, i) => [one, y[i]]);
  });
  expect(stand.length > 9 && stand.length < 50 && stand.every(free), `on free ground: ${JSON.stringify(stand)}`);
  expect(small.patches.length === 1 && small.patches[0].motion === 'swim', JSON.stringify(small.patches));
  await allInSight(studio, [
    [0, 0],
    [12, 8],
  ]);
  await studio.pictures(2);
  await studio.shot('place-small');
  const corners = [
    [0, 0],
    [40, 0],
    [40, 25],
    [0, 25],
    [0, 0],
  ];
  const house = [
    [60, 0],
    [150, 0],
    [150, 80],
    [60, 80],
    [60, 0],
  ];
  const made = {
    type: 'FeatureCollection',
    crs: { type: 'name', properties: { name: 'urn:ogc:def:crs:EPSG::25833' } },
    features: [
      kPond(corners),
      { type: 'Feature', properties: { building: 'yes' }, geometry: { type: 'Polygon', coordinates: [house] } },
    ],
  };
  await drop(studio, { name: 'park.geojson', buffer: Buffer.from(JSON.stringify(made)) });
  await dialog.locator('.place-import:not([hidden])').waitFor();
  await studio.eventually(async () =>
    expect(/1 obstacle and 1 piece of water on 150 × 80 m/.test(await dialog.textContent()), 'it is told'),
  );
  await inSight(dialog.locator('.place-acts button:visible'));
  await studio.shot('place-import-park');
  await dialog.locator('button', { hasText: 'New place' }).click();
  await untilTitle(studio, 'Park');
  const park = await present(server);
  expect(park.obstacles.length === 1 && park.patches[0].motion === 'swim', 'a house and a pond to swim in');
  await studio.until('its people', () => globalThis.__muster.frame.x.length === 50);
  await allInSight(studio, park.box);
  await studio.pictures(2);
  await studio.shot('place-park');
}

/** Every bad file gets one sentence that names it, by picker and by drop; nothing changes. */
export async function badFiles(studio, server) {
  const before = await title(studio);
  const cases = [
    ['cut.geojson', madeTown().subarray(0, 200), /^“cut\.geojson” cannot be read: it is no whole JSON file\.$/],
    [
      'points.json',
      Buffer.from('{"type": "Point", "coordinates": [1, 2]}'),
      /^“points\.json” holds no polygons and no lines\.$/,
    ],
    [
      'broken.obj',
      Buffer.from('v 0 0 0\nv 1 0 0\nf 1 2 9\n'),
      /^“broken\.obj” is broken in line 3: it has no corner 9\.$/,
    ],
    ['cut.glb', madeModel().subarray(0, 300), /^“cut\.glb” cannot be read: .*\.$/],
    ['short.map', madeMap().subarray(0, 100), /^“short\.map” is broken in line \d+: .*\.$/],
    [
      'wrong.json',
      Buffer.from('{"format": "muster-scenario", "version": 1, "groups": 7}'),
      /^“wrong\.json” could not be opened: .*groups.*\.$/,
    ],
    ['torn.json', Buffer.from('{"format": "muster-scenario", "version": 1, '), /^“torn\.json” cannot be read: .*\.$/],
    ['walk.bvh', Buffer.from('HIERARCHY\nROOT Hips\n'), /^“walk\.bvh” is recorded motion: .*\.$/],
    ['noise.bin', Buffer.from([1, 2, 3, 0, 255]), /^“noise\.bin” is no take, .*\.$/],
    ['nothing.obj', Buffer.alloc(0), /^“nothing\.obj” is empty\.$/],
  ];
  const dialog = dialogOf(studio);
  for (const [name, buffer, sentence] of cases) {
    for (const way of ['picker', 'drop']) {
      if (way === 'picker') await openPlaces(studio, 'Import a file');
      await (way === 'picker' ? choose : drop)(studio, { name, buffer });
      await studio.eventually(async () => {
        const inside = await studio.page
          .locator('dialog.place-dialog[open] .place-said:not([hidden])')
          .allTextContents();
        const banner = await studio.page.locator('.banner.notice:not([hidden]) strong').allTextContents();
        expect(
          [...inside, ...banner].some((text) => sentence.test(text)),
          `${name} by ${way}: ${[...inside, ...banner]}`,
        );
      }, 5000);
      if (name === 'broken.obj' && way === 'picker') {
        await serious(studio, 'a bad file');
        await studio.shot('place-bad-file');
      }
      if ((await dialog.count()) > 0) await studio.page.keyboard.press('Escape');
      await studio.page.evaluate(() => document.querySelector('.banner.notice:not([hidden]) .notice-close')?.click());
    }
  }
  expect((await title(studio)) === before, 'the place is as before');
  expect((await present(server)).name === before, 'on the server, too');
  // A body is a character, whatever picker it came by.
  await openPlaces(studio, 'Import a file');
  await choose(studio, { name: 'person.glb', buffer: madeCharacter() });
  await studio.until('everybody to be it', () =>
    globalThis.__muster.view.people.drawn.every((one) => one.body === 'person.glb'),
  );
  expect((await dialog.count()) === 0, 'and the dialog is out of the way');
}

const kOpen = { touch: false, scenario: 'scenarios/open.json' };

export const kImportCases = [
  ['place files: GeoJSON', importTown, ['desktop', 'portrait', 'phone'], kOpen],
  ['place files: models', importModels, ['desktop', 'phone'], kOpen],
  ['place files: grid map', importMap, ['desktop'], kOpen],
  ['place files: water', importWater, ['wide', 'phone'], kOpen],
  ['place files: bad files', badFiles, ['desktop'], kOpen],
];
