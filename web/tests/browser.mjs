// The studio in a real browser: node tests/browser.mjs [--all] [--only WORD] (MUSTER=path names the program)
//
//     always      each case in the first of its sizes, `everySize` ones in all, `release` ones in none: what a push may break
//     --all       all cases in all of their sizes: a release
//     --stats     only what crowds of 300 to 10,000 cost the page on a phone and a tablet
import * as areas from './cases/areas.mjs';
import * as build from './cases/build.mjs';
import * as buildKeys from './cases/build_keys.mjs';
import * as buildPeople from './cases/build_people.mjs';
import * as buildCorners from './cases/build_corners.mjs';
import * as camera from './cases/camera.mjs';
import * as directors from './cases/directors.mjs';
import * as crowdCosts from './cases/crowd_costs.mjs';
import * as demonstration from './cases/demonstration.mjs';
import * as exports from './cases/exports.mjs';
import * as feedback from './cases/feedback.mjs';
import * as film from './cases/film_camera.mjs';
import * as findings from './cases/findings.mjs';
import * as firstMinute from './cases/first_minute.mjs';
import * as forms from './cases/forms.mjs';
import * as groupAppearance from './cases/group_appearance.mjs';
import * as groupColour from './cases/group_colour.mjs';
import * as keys from './cases/keys.mjs';
import * as letters from './cases/letters.mjs';
import * as limits from './cases/limits.mjs';
import * as look from './cases/look.mjs';
import * as measures from './cases/measures.mjs';
import * as mouseAndKeys from './cases/mouse_and_keys.mjs';
import * as objectives from './cases/objectives.mjs';
import * as orders from './cases/orders.mjs';
import * as overlays from './cases/overlays.mjs';
import * as placeFiles from './cases/place_files.mjs';
import * as placeImports from './cases/place_imports.mjs';
import * as placeShare from './cases/place_share.mjs';
import * as people from './cases/people.mjs';
import * as queue from './cases/queue.mjs';
import * as reach from './cases/reach.mjs';
import * as realMaps from './cases/real_maps.mjs';
import * as scenarios from './cases/scenarios.mjs';
import * as shapes from './cases/shapes.mjs';
import * as session from './cases/session.mjs';
import * as schemes from './cases/schemes.mjs';
import * as standing from './cases/standing.mjs';
import * as study from './cases/study.mjs';
import * as oldTakes from './cases/old_take.mjs';
import * as paths from './cases/path.mjs';
import * as takes from './cases/takes.mjs';
import * as things from './cases/things.mjs';
import * as touch from './cases/touch.mjs';
import * as tracks from './cases/tracks.mjs';
import * as undo from './cases/undo.mjs';
import * as words from './cases/words.mjs';
import { chosenCases } from './support/chosen_cases.mjs';
import { openChromium } from './support/chromium.mjs';
import { startMadeCrowd } from './support/made_crowd.mjs';
import { kPort, startStudio } from './support/server.mjs';
import { StudioPage } from './support/studio_page.mjs';

const kOpen = { scenario: 'scenarios/open.json', room: true };
const kTablets = ['desktop', 'landscape', 'portrait'];

/** Name, test, sizes, and options of the page. `room`: zoomed out, to have room to drag; `shared`: one page serves all such
 * cases of a size; `counts`: calls of WebGL are counted; `ratio`: device px per CSS px; a `scenario` gets a server of its own; `bare`: the test starts its own
 * servers and pages; `everySize`: what it looks at depends on the size of the screen most; `release`: it takes long and seldom fails alone. */
const kCases = [
  ['latency', session.latency, ['desktop'], {}],
  ['point', touch.pointDrag, kTablets, { room: true, shared: true }],
  ['line', touch.lineDrag, kTablets, { room: true, shared: true }],
  ['area', touch.areaDrag, kTablets, { room: true, shared: true }],
  ['line and area together', touch.lineAndArea, kTablets, { room: true, shared: true }],
  ['drawing ahead and lifting', touch.drawAheadAndLift, kTablets, { room: true, shared: true }],
  ['another formation on the way', touch.formationOnTheWay, kTablets, { room: true, shared: true }],
  ['pinch on empty ground', touch.pinchOnGround, kTablets, { room: true, shared: true }],
  ['ten fingers', touch.tenFingers, ['desktop'], { shared: true }],
  ['mouse: point', mouseAndKeys.mousePoint, ['desktop'], { touch: false, room: true, shared: true }],
  ['mouse: line', mouseAndKeys.mouseLine, ['desktop'], { touch: false, room: true, shared: true }],
  ['mouse: area', mouseAndKeys.mouseArea, ['desktop'], { touch: false, room: true, shared: true }],
  ['mouse: pin', mouseAndKeys.mousePin, ['desktop'], { touch: false, room: true, shared: true }],
  [
    'mouse: keys while it drags',
    mouseAndKeys.keysWhileDragging,
    ['desktop'],
    { touch: false, room: true, shared: true },
  ],
  ['mouse: camera', mouseAndKeys.mouseCamera, ['desktop'], { touch: false, shared: true }],
  ['keyboard only', mouseAndKeys.keyboardOnly, ['desktop'], { touch: false, room: true, shared: true }],
  ...keys.kKeyCases,
  ['units: split and merge', orders.splitAndMerge, kTablets, { room: true }],
  ['units: pulled apart', orders.pullApart, ['landscape'], { room: true }],
  [
    'units: chip onto chip',
    orders.chipOntoChip,
    ['desktop'],
    { touch: false, scenario: 'web/tests/scenarios/two-groups.json', room: true },
  ],
  ['orders by mouse', orders.ordersByMouse, ['desktop'], { touch: false, room: true }],
  ['orders by touch', orders.ordersByTouch, ['landscape', 'portrait', 'phone'], { room: true }],
  [
    'queue: forecast by mouse',
    queue.forecastByMouse,
    ['wide'],
    { touch: false, scenario: 'scenarios/block.json', room: true },
  ],
  ['queue: forecast by touch', queue.forecastByTouch, ['landscape'], { scenario: 'scenarios/block.json', room: true }],
  ['queue: ways', queue.waysOfQueues, ['wide'], { touch: false, scenario: 'scenarios/block.json', room: true }],
  ['queue: edits', queue.editQueue, ['wide'], { touch: false, scenario: 'scenarios/block.json', room: true }],
  [
    'queue: edits by touch',
    queue.editQueueByTouch,
    ['landscape', 'portrait', 'phone'],
    { scenario: 'scenarios/block.json', room: true },
  ],
  ...standing.kStandingCases,
  ['orders: conduct', orders.conduct, [...kTablets, 'phone'], { room: true }],
  ...undo.kUndoCases,
  ...words.kWordsCases,
  ['paused', feedback.paused, ['desktop'], { room: true }],
  ['refused', feedback.refused, ['desktop', 'phone'], {}],
  ['objectives', objectives.objectives, ['desktop'], { scenario: 'scenarios/block.json' }],
  ['overlays', overlays.overlays, ['desktop'], { scenario: 'scenarios/block.json' }],
  ['overlay after a loss', overlays.overlayAfterLoss, ['desktop', 'phone'], { scenario: 'scenarios/block.json' }],
  ['scenario picker', scenarios.scenarioPicker, ['desktop'], { touch: false, scenario: 'scenarios/open.json' }],
  ['every scenario', scenarios.everyScenario, ['desktop'], { scenario: 'scenarios/open.json' }],
  [
    'demonstration',
    demonstration.demonstration,
    [...kTablets, 'phone', 'narrow', 'zoomed', 'wide'],
    { scenario: 'scenarios/open.json' },
  ],
  ...['scenarios/course.json', 'scenarios/paper/x03-long-house.json', 'scenarios/paper/x08-congestion.json'].map(
    (scenario) => [
      `camera: watched crowd of ${scenario.replace(/.*\/|\.json/g, '')}`,
      camera.watchedCrowd,
      ['desktop', 'phone'],
      { scenario, release: true },
    ],
  ),
  [
    'camera: by touch',
    camera.cameraByTouch,
    ['wide', 'landscape', 'portrait', 'phone'],
    { scenario: 'web/tests/scenarios/two-groups.json' },
  ],
  ['camera: by keys', camera.cameraByKeys, ['desktop'], { touch: false, scenario: 'scenarios/block.json' }],
  ['camera: wheel', camera.wheelEndsOnPeople, ['desktop'], { touch: false, scenario: 'scenarios/block.json' }],
  ['first load', findings.firstLoad, ['desktop'], {}],
  ['limits: first picture', limits.firstPicture, ['wide'], { scenario: 'scenarios/fountain.json', release: true }],
  [
    'limits: editing a thousand',
    limits.editingThousand,
    ['wide'],
    { touch: false, scenario: 'web/tests/scenarios/thousand.json', release: true },
  ],
  ...firstMinute.kFirstMinuteCases,
  ['hint ticks', findings.hintTicks, ['desktop', 'phone'], { hint: true, scenario: 'scenarios/block.json' }],
  ['area after line', findings.areaAfterLine, ['desktop', 'phone'], { scenario: 'scenarios/block.json' }],
  ['drawn formation', shapes.drawnFormation, ['desktop', 'phone'], { scenario: 'scenarios/open.json' }],
  ['formation of one’s own', shapes.ownShape, ['desktop', 'portrait', 'phone'], { scenario: 'scenarios/open.json' }],
  ['written formation', shapes.writtenFormation, ['desktop'], { scenario: 'scenarios/open.json', room: true }],
  ...letters.kLetterCases,
  ['forms: look by mouse', forms.lookByMouse, ['desktop'], { touch: false, scenario: 'scenarios/block.json' }],
  ['forms: look by touch', forms.lookByTouch, ['landscape', 'portrait', 'phone'], { scenario: 'scenarios/block.json' }],
  [
    'forms: front over a house',
    forms.frontOverGranary,
    ['desktop'],
    { touch: false, scenario: 'scenarios/block.json', room: true },
  ],
  [
    'forms: try on the ground',
    forms.tryOnTheGround,
    ['desktop', 'portrait', 'phone', 'narrow'],
    { scenario: 'scenarios/block.json' },
  ],
  ['forms: draw by a key', forms.drawByKey, ['desktop'], { touch: false, scenario: 'scenarios/block.json' }],
  [
    'forms: draw by a held button',
    forms.drawByHeldButton,
    ['landscape', 'phone'],
    { scenario: 'scenarios/block.json', room: true },
  ],
  ['forms: sequence by mouse', forms.sequenceByMouse, ['wide'], { touch: false, scenario: 'scenarios/block.json' }],
  [
    'forms: sequence by touch',
    forms.sequenceByTouch,
    ['landscape', 'portrait', 'phone', 'narrow'],
    { scenario: 'scenarios/block.json' },
  ],
  ['added group', findings.addedGroup, ['desktop', 'phone'], { scenario: 'scenarios/open.json', room: true }],
  ['palm and restart', findings.palmAndRestart, ['landscape'], { scenario: 'scenarios/open.json' }],
  ['pinned marks', findings.marks, ['desktop'], { touch: false, scenario: 'scenarios/open.json' }],
  ['hidden people', findings.hiddenPeople, ['desktop'], { scenario: 'scenarios/block.json' }],
  ['small rings', findings.smallRings, ['phone', 'narrow'], { scenario: 'scenarios/open.json' }],
  [
    'nothing overlaps',
    findings.nothingOverlaps,
    ['wide', 'landscape', 'portrait', 'phone'],
    { scenario: 'scenarios/paper/x03-long-house.json', everySize: true },
  ],
  ...reach.kReachCases,
  ['build: by mouse', build.byMouse, ['desktop'], { touch: false, scenario: 'scenarios/open.json', room: true }],
  ['build: corners', buildCorners.cornersAndGuides, ['desktop', 'portrait', 'phone'], kOpen],
  ['group colour: by mouse', groupColour.byMouse, ['desktop'], { ...kOpen, touch: false }],
  ['group colour: by touch', groupColour.byTouch, ['landscape', 'portrait', 'phone', 'narrow'], kOpen],
  ['group appearance: by mouse', groupAppearance.byMouse, ['desktop'], { ...kOpen, touch: false }],
  ['group appearance: by touch', groupAppearance.byTouch, ['portrait', 'phone'], kOpen],
  [
    'build: by keys alone',
    buildKeys.byKeys,
    ['desktop'],
    { touch: false, scenario: 'scenarios/open.json', room: true },
  ],
  ['build: numbers', build.numbers, ['wide'], { touch: false, scenario: 'scenarios/open.json', room: true }],
  ['build: bodies', build.bodies, [...kTablets, 'phone'], { scenario: 'scenarios/open.json', room: true }],
  ['build: drags', build.dragsInARow, ['desktop'], { touch: false, scenario: 'scenarios/open.json', room: true }],
  ['build: drags by touch', build.dragsByTouch, ['portrait'], { scenario: 'scenarios/open.json', room: true }],
  ...buildPeople.kPeopleCases,
  ...things.kThingCases,
  ...areas.kAreaCases,
  ['build: by touch', build.byTouch, ['landscape', 'portrait', 'phone'], kOpen],
  ['measures: a door', measures.door, [...kTablets, 'phone'], { scenario: 'web/tests/scenarios/door.json' }],
  ['people', people.appear, ['desktop'], { search: '?quality=full' }],
  ['people in light quality', people.appearLight, ['desktop'], { search: '?quality=light' }],
  ['people on patches', people.motions, ['desktop'], { scenario: 'scenarios/course.json' }],
  ['a character of one’s own', people.ownCharacter, ['desktop', 'phone'], { search: '?quality=full' }],
  [
    'a thousand people',
    people.budgets,
    ['desktop'],
    { search: '?quality=full&stats', counts: true, scenario: 'web/tests/scenarios/thousand.json', release: true },
  ],
  [
    'ten thousand people',
    people.budgetsOfMany,
    ['desktop', 'portrait'],
    { search: '?quality=full&stats', counts: true, made: { count: 10000, near: 100 }, release: true },
  ],
  ...crowdCosts.kCostCases,
  ['growing crowd', scenarios.growingCrowd, ['desktop'], { scenario: 'scenarios/open.json' }],
  ['two groups', scenarios.twoGroups, ['desktop'], { scenario: 'web/tests/scenarios/two-groups.json', room: true }],
  [
    'directors: two',
    directors.twoDirectors,
    [...kTablets, 'phone'],
    { scenario: 'web/tests/scenarios/two-groups.json', room: true },
  ],
  [
    'directors: clock',
    directors.sharedClock,
    ['desktop', 'phone'],
    { scenario: 'web/tests/scenarios/two-groups.json' },
  ],
  ['directors: place', directors.sharedPlace, ['desktop', 'phone'], { scenario: 'scenarios/market.json' }],
  [
    'directors: invitation',
    directors.invitation,
    ['desktop', 'portrait', 'phone'],
    { scenario: 'scenarios/open.json', options: ['--lan'] },
  ],
  ['record and replay', session.recordAndReplay, ['desktop'], { room: true }],
  ['takes: life of a take', takes.life, ['desktop', 'phone'], { scenario: 'web/tests/scenarios/hundred.json' }],
  ['takes: scrub and trim', takes.scrubAndTrim, ['landscape', 'phone'], { scenario: 'scenarios/open.json' }],
  ['takes: late, and left', takes.lateAndLeft, ['desktop', 'phone'], { scenario: 'scenarios/open.json' }],
  ['takes: again and on top', takes.againAndOnTop, ['desktop'], { scenario: 'web/tests/scenarios/two-groups.json' }],
  ...tracks.kTracksCases,
  ['takes: film camera', film.filmCamera, ['desktop', 'portrait', 'phone'], { ...kOpen, room: false, release: true }],
  [
    'paths: by finger',
    (studio) => paths.path(studio, false),
    ['portrait', 'phone'],
    { scenario: 'scenarios/open.json' },
  ],
  [
    'paths: by mouse',
    (studio) => paths.path(studio, true),
    ['desktop'],
    { touch: false, scenario: 'scenarios/open.json' },
  ],
  ['paths: one person', paths.person, ['landscape', 'phone'], { scenario: 'scenarios/open.json' }],
  ['takes: of another version', oldTakes.oldTake, ['desktop', 'phone'], { scenario: 'scenarios/open.json' }],
  ['takes: exports', takes.exports, ['desktop'], { scenario: 'scenarios/open.json', release: true }],
  ...exports.kExportCases,
  ['takes: cut off', takes.cutOff, ['desktop', 'phone'], { scenario: 'scenarios/open.json' }],
  ...placeFiles.kPlaceCases,
  ...placeImports.kImportCases,
  ...placeShare.kShareCases,
  ['a page that hangs', session.stalledPage, ['desktop'], {}],
  ['first visit', look.firstVisit, [...kTablets, 'phone', 'narrow'], { hint: true, everySize: true }],
  ['layout', look.layout, [...kTablets, 'phone', 'narrow', 'zoomed'], { everySize: true }],
  ['access', look.accessible, [...kTablets, 'phone', 'zoomed'], { everySize: true }],
  ...look.kAccessCases,
  ['lost and found', session.lostAndFound, ['landscape'], {}],
  ['control schemes by mouse', schemes.byMouse, ['desktop'], { touch: false, room: true }],
  ['control schemes by touch', schemes.byTouch, ['landscape', 'phone'], { room: true }],
  ['study: a whole run', study.wholeRun, ['wide'], { bare: true, release: true }],
  ['study: stopped, lost, two at once', study.brokenRuns, ['wide'], { bare: true, release: true }],
  ['study: without touch', study.withoutTouch, ['desktop'], { bare: true }],
  ['study: look', study.look, ['wide', 'landscape', 'portrait', 'phone'], { bare: true }],
  ...realMaps.cases(),
];

let server = await startStudio();
const browser = await openChromium();
let passed = 0;
const [failed, again] = [[], []];

/** The page that shared cases go on with, and what it is. */
let shared = { studio: null, key: '' };

async function closeShared() {
  await shared.studio?.close().catch(() => undefined);
  shared = { studio: null, key: '' };
}

/** The page for a case on the common server: the last one, where both share it. */
async function openPage(size, options) {
  const key = options.shared ? `${size} ${options.touch !== false}` : '';
  if (key && shared.key === key) {
    await shared.studio.renew();
    return shared.studio;
  }
  await closeShared();
  const studio = await StudioPage.open(browser, `${server.url}${options.search ?? ''}`, { size, ...options });
  if (key) shared = { studio, key };
  await studio.restart();
  return studio;
}

/** The page for a case with a server of its own. */
async function openOwnPage(own, size, options) {
  await closeShared();
  const studio = await StudioPage.open(browser, `${own.url}${options.search ?? ''}`, { size, ...options });
  if (!options.made) await studio.restart();
  return studio;
}

/** Runs a case once; what went wrong, or nothing. */
async function attempt({ name, test, size, options }) {
  let studio = null;
  let own = null;
  try {
    if (options.bare) {
      await closeShared();
      await test(browser, size);
      return '';
    }
    if (options.scenario)
      own = await startStudio({ scenario: options.scenario, port: kPort + 200, options: options.options });
    if (options.made) own = await startMadeCrowd({ ...options.made, bodies: server.url });
    studio = own ? await openOwnPage(own, size, options) : await openPage(size, options);
    await studio.fit();
    if (options.room) await studio.makeRoom();
    const left = await test(studio, own ?? server);
    if (!own) server = left ?? server;
    if (studio.errors.length > 0) throw new Error(`the page complained: ${studio.errors.join('; ')}`);
    return '';
  } catch (error) {
    await studio?.shot(`failed-${name.replace(/\W+/g, '-')}`).catch(() => undefined);
    // What a failed case leaves behind, on its page or in the common server, is no concern of the next.
    await closeShared();
    await server.stop();
    server = await startStudio();
    return error.message || 'it threw';
  } finally {
    if (studio !== shared.studio) await studio?.close().catch(() => undefined);
    await own?.stop();
  }
}

/** A machine that is busy with something else may make a case fail, so each has a second try on a new page and server; what
 * needed it is told. */
async function runCase(one) {
  const title = `${one.name} (${one.size}`;
  let reason = '';
  for (let tried = 1; tried <= 2; ++tried) {
    const started = Date.now();
    const wrong = await attempt(one);
    if (!wrong) {
      passed += 1;
      if (tried > 1) again.push(`${title})`);
      return console.log(`ok    ${title}, ${((Date.now() - started) / 1000).toFixed(1)} s)`);
    }
    reason = wrong;
    console.log(`${tried === 1 ? 'again' : 'FAIL '} ${title}): ${wrong}`);
  }
  failed.push(`${title}): ${reason}`);
}

try {
  for (const one of chosenCases(kCases, process.argv)) await runCase(one);
} finally {
  await closeShared();
  await browser.close();
  await server.stop();
}
for (const name of again) console.log(`measured: passed at the second try: ${name}`);
for (const name of failed) console.log(`failed: ${name}`);
console.log(`${passed} passed, ${failed.length} failed`);
process.exit(failed.length > 0 ? 1 : 0);
