// What crowds cost the page on a phone: draws, triangles and bytes have bounds, times are only told. `--stats` runs it for
// crowds of all sizes.
import { expect } from '../support/expect.mjs';
import { percentile } from '../support/geometry.mjs';

/** Of a phone, for any crowd: draws; triangles, and for those who are too many for that the triangles of each. */
const kMost = { draws: 20, triangles: 600000, each: 37 };
/** Bytes to WebGL for a picture: two new frames of 32 each, lists of who is drawn, places; whole poses, meshes and marks. */
const bytesFor = (count) => 100 * count + 230000;
/** A fitted crowd of three thousand. */
const kFitted = { count: 3000, triangles: 300000 };

/** Open ground with up to four squares of people. */
function placeOf(count) {
  const groups = Math.max(2, Math.min(4, Math.round(count / 500)));
  const each = Math.round(count / groups);
  const gap = Math.ceil(Math.sqrt(each)) + 6;
  const reach = 1.5 * gap + 10;
  return {
    format: 'muster-scenario',
    version: 1,
    name: `Crowd of ${count}`,
    box: [
      [-reach, -reach],
      [reach, reach],
    ],
    groups: ['Blue', 'Ember', 'Green', 'Plum'].slice(0, groups).map((name, k) => ({
      name,
      count: each,
      formation: 'square',
      position: [((k % 2) - 0.5) * gap, (Math.floor(k / 2) - 0.5) * gap],
    })),
  };
}

/** Opens such a place, and lets all walk. */
async function openCrowd(studio, count) {
  const place = placeOf(count);
  const answer = await studio.page.evaluate(async (body) => {
    const opened = await globalThis.__muster.ask('scenario?name=crowd', { method: 'POST', body });
    return opened.ok ? '' : opened.text();
  }, JSON.stringify(place));
  expect(answer === '', answer);
  await studio.until('the crowd', (n) => globalThis.__muster.frame.x.length === n, count, 60000);
  const commands = place.groups.map(({ position: [x, y] }, k) => ({
    kind: 'order',
    group: k + 1,
    order: { target: [x + 10, y + 4] },
  }));
  await studio.send({ type: 'Commands', commands });
  await studio.until('bodies from the server', () =>
    globalThis.__muster.view.people.drawn.some((one) => one.body === 'body-1'),
  );
}

/** Waits until the levels of detail have settled. */
async function settled(studio) {
  await studio.cameraAtRest();
  const list = [];
  await studio.eventually(async () => {
    await studio.pictures(1);
    list.push(await studio.page.evaluate(() => JSON.stringify(globalThis.__muster.view.stats.triangles)));
    const newest = list.slice(-3).map(Number);
    const [least, most] = [Math.min(...newest), Math.max(...newest)];
    expect(newest.length === 3 && most - least < 0.02 * most, `the levels settle: ${newest}`);
  }, 60000);
}

/** Of so many pictures while everybody walks. */
function measured(studio, pictures) {
  return studio.page.evaluate(
    (count) =>
      new Promise((done) => {
        const { view } = globalThis.__muster;
        const { stats, camera } = view;
        const { webgl } = globalThis;
        const start = { ...webgl, pictures: stats.pictures };
        const times = [];
        let last = stats.pictures;
        const look = () => {
          if (stats.pictures !== last) times.push(stats.pictureMs);
          last = stats.pictures;
          if (times.length < count) return requestAnimationFrame(look);
          const bytes = (webgl.bytes - start.bytes) / (last - start.pictures);
          const sum = (level) => view.people.drawn.reduce((total, one) => total + one[level], 0);
          const levels = ['near', 'far', 'tiny', 'speck'].map(sum);
          const { drawCalls, triangles } = stats;
          done({ times, bytes, drawCalls, triangles, levels, pixels: camera.pixelsPerMetre() });
        };
        look();
      }),
    pictures,
  );
}

function expectWithin(count, view, { times, bytes, drawCalls, triangles, levels, pixels }) {
  const shown = levels.reduce((sum, one) => sum + one);
  const [half, most, worst] = [0.5, 0.95, 1].map((share) => percentile(times, share).toFixed(1));
  console.log(
    `measured: ${count} people ${view}, ${pixels.toFixed(1)} px a metre: ${drawCalls} draws, ${triangles} triangles, ` +
      `${Math.round(bytes / 1000)} kB to WebGL; ${levels.join(', ')} of each level; page ${half} ms, p95 ${most}, worst ${worst}`,
  );
  expect(drawCalls <= kMost.draws, `${drawCalls} draws, at most ${kMost.draws}`);
  const bound = Math.max(kMost.triangles, kMost.each * shown + 20000);
  expect(triangles <= bound, `${triangles} triangles, at most ${bound}`);
  expect(bytes <= bytesFor(count), `${Math.round(bytes)} bytes to WebGL for a picture, at most ${bytesFor(count)}`);
  return shown;
}

async function expectCrowd(studio, count, pictures) {
  await openCrowd(studio, count);
  await studio.fit();
  await settled(studio);
  const fitted = await measured(studio, pictures);
  const shown = expectWithin(count, 'fitted', fitted);
  expect(shown > 0.9 * count, `the crowd is in view: ${shown} of ${count}`);
  if (count === kFitted.count)
    expect(fitted.triangles <= kFitted.triangles, `${fitted.triangles} triangles, at most ${kFitted.triangles}`);
  await studio.shot(`crowd-of-${count}`);
  await studio.page.evaluate(() =>
    globalThis.__muster.view.camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, 3),
  );
  await settled(studio);
  expectWithin(count, 'from near', await measured(studio, pictures));
  await studio.shot(`crowd-of-${count}-near`);
}

export async function threeThousand(studio) {
  await expectCrowd(studio, 3000, 3);
}

export async function allSizes(studio) {
  for (const count of [300, 1000, 3000, 10000]) await expectCrowd(studio, count, 6);
}

const kOptions = { search: '?quality=full', counts: true, scenario: 'scenarios/open.json' };

export const kCostCases = [
  ['three thousand people on a phone', threeThousand, ['phone'], kOptions],
  ['stats: crowds on a phone', allSizes, ['phone', 'landscape'], { ...kOptions, ratio: 2, release: true }],
];
