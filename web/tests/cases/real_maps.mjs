// A hundred characters steered by fingers through real maps: recorded, downloaded, replayed, nobody stuck.
// Minutes long, so MUSTER_REAL_MAPS=1 asks for them. The maps are test material beside the repository; without them
// these cases are skipped.
import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { expect } from '../support/expect.mjs';
import { crowd, distance, mean, points, shifted } from '../support/geometry.mjs';
import { programPath, startStudio } from '../support/server.mjs';
import { StudioPage } from '../support/studio_page.mjs';

const maps = fileURLToPath(new URL('../../../../shared/maps/', import.meta.url));
const pictures = process.env.MUSTER_PICTURES; // A folder to write the pictures of the README to.
const run = promisify(execFile);

const kMaps = {
  berlin: {
    file: 'Berlin_0_256.map',
    rows: 256,
    credit: 'Map data from OpenStreetMap contributors (ODbL); grid from the Moving AI benchmark set, N. Sturtevant.',
    // Column and row of the map: out of the square, down a lane of 7 m, over a yard, through a gap of 7 m.
    way: [
      [57, 92],
      [60.5, 108],
      [63.5, 117],
      [67, 123],
      [72, 132],
      [78, 145],
      [86, 156],
      [93.5, 160.5],
      [99.7, 165.5],
      [107, 174.5],
      [116, 186],
      [123, 195],
    ],
  },
  lak303d: {
    file: 'lak303d.map',
    rows: 194,
    credit: 'Dragon Age: Origins, BioWare; grid from the Moving AI benchmark set, N. Sturtevant.',
    // Past the pillar, out of the hall by a door of 5 m, up the bent passage.
    way: [
      [107, 166],
      [109, 152],
      [115, 145],
      [121, 142.5],
      [128, 138],
      [136, 131],
      [143, 122],
      [147, 112],
      [147, 102],
    ],
  },
};
const kStroke = 34; // Drawn at one go, at most [m].
const kPictured = 4; // The stroke after which the picture is taken: across the yard, to the gap.
const kZoom = 11; // While steering [px/m].

/** The cases, or none and a line that says why. */
export function cases() {
  if (!process.env.MUSTER_REAL_MAPS) {
    console.log('skipped: real maps, which take minutes; MUSTER_REAL_MAPS=1 asks for them');
    return [];
  }
  if (!existsSync(maps)) {
    console.log('skipped: real maps, ../shared/maps is not there');
    return [];
  }
  return [
    ['real map: Berlin', (studio) => throughMap(studio, 'berlin'), ['desktop'], {}],
    ['real map: lak303d', (studio) => throughMap(studio, 'lak303d'), ['desktop'], {}],
  ];
}

async function throughMap(first, name) {
  const map = kMaps[name];
  const folder = mkdtempSync(join(tmpdir(), 'muster-map-'));
  let server = null;
  let studio = null;
  try {
    const scenario = join(folder, `${name}.json`);
    await run(programPath(), [
      'import',
      maps + map.file,
      '-o',
      scenario,
      '--cell',
      '1',
      '--count',
      '100',
      '--credit',
      map.credit,
    ]);
    expect(JSON.parse(readFileSync(scenario, 'utf8')).credit === map.credit, 'the scenario names whose data it uses');
    server = await startStudio({ scenario, port: 18180 });
    studio = await StudioPage.open(first.context.browser(), server.url, {});
    const take = join(folder, `${name}.take`);
    await steerAndRecord(studio, new Steering(studio, map), take, name, server);
    await judgeReplay(take, name);
    if (studio.errors.length > 0) throw new Error(`the page complained: ${studio.errors.join('; ')}`);
  } catch (error) {
    await studio?.shot(`failed-${name}`).catch(() => undefined);
    throw error;
  } finally {
    await studio?.close().catch(() => undefined);
    await server?.stop();
    rmSync(folder, { recursive: true, force: true });
  }
}

async function steerAndRecord(studio, steering, take, name, server) {
  await studio.send({ type: 'Playback', action: 0 });
  await studio.page.locator('.record').click();
  await studio.until('the record', () => globalThis.__muster.frame.recordedSeconds >= 0);
  await steering.begin();
  for (let stroke = 1; !steering.done(); ++stroke) {
    await steering.drawOn();
    await studio.shot(`${name}-stroke-${stroke}`);
    if (pictures && stroke === kPictured) await picture(studio, server, `${pictures}/${name}.png`);
    // Walking takes long: it is watched at four times the speed, where the machine can.
    await studio.send({ type: 'SetSpeed', factor: 4 });
    await steering.untilNearEnd();
    await studio.send({ type: 'SetSpeed', factor: 1 });
    await studio.shot(`${name}-walked-${stroke}`);
  }
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await studio.until(
    'the end of the last path',
    () => globalThis.__muster.frame.groups[0].controls.length === 0,
    null,
    90000,
  );
  await studio.until('everybody on their places', everybodyThere, null, 90000);
  await studio.send({ type: 'SetSpeed', factor: 1 });
  await studio.wait(1200);
  await steering.look(steering.goal());
  await studio.shot(`${name}-end`);
  const frame = await studio.frame();
  const off = distance(mean(points(frame.groups[0].places)), steering.goal());
  expect(off < 4, `the crowd stands at the end of the way: ${off.toFixed(1)} m off`);
  await studio.page.locator('.record').click();
  await studio.until('the end of the record', () => globalThis.__muster.frame.recordedSeconds < 0);
  const bytes = await studio.page.evaluate(async () => [...new Uint8Array(await (await fetch('take')).arrayBuffer())]);
  writeFileSync(take, Uint8Array.from(bytes));
}

/** In the page: everybody has a place and stands within 0.5 m of one. */
function everybodyThere() {
  const { frame } = globalThis.__muster;
  const place = frame.groups[0].places;
  return Array.from(frame.x).every((x, i) => {
    for (let k = 0; k < place.length; k += 2)
      if (Math.hypot(place[k] - x, place[k + 1] - frame.y[i]) < 0.5) return true;
    return false;
  });
}

async function judgeReplay(take, name) {
  const replayed = JSON.parse((await run(programPath(), ['replay', take, '--json'])).stdout);
  expect(replayed.reproduced === true, `the take replays to the same hashes: ${JSON.stringify(replayed)}`);
  expect(replayed.finished === true && replayed.torn_bytes === 0, `the take is whole: ${JSON.stringify(replayed)}`);
  const { stuck, unmatched, overlap_pairs_max: overlaps, step_ms: times } = replayed.figures;
  const step = `step p50 ${times.p50.toFixed(2)} ms, p95 ${times.p95.toFixed(2)} ms`;
  console.log(
    `measured: ${name}, ${replayed.steps} steps, ${replayed.commands} commands, hash ${replayed.hash}, replay's ${step}`,
  );
  expect(stuck === 0 && unmatched === 0, `nobody is stuck or without a place: ${stuck}, ${unmatched}`);
  expect(overlaps === 0, `nobody overlaps: ${overlaps} pairs`);
}

/** A person with one finger: looks where to go, draws some way ahead, waits, draws on. */
class Steering {
  constructor(studio, map) {
    this.studio = studio;
    this.way = map.way.map(([column, row]) => ({ x: column, y: map.rows - row }));
    this.next = 0;
  }

  goal() {
    return this.way[this.way.length - 1];
  }

  done() {
    return this.next >= this.way.length;
  }

  /** Pinches until streets are seen, and chooses the vertex to lead by: that in the middle. */
  async begin() {
    const { vertices, middle } = await this.crowdNow();
    this.vertex = vertices.reduce(
      (best, v, i) => (distance(v, middle) < distance(vertices[best], middle) ? i : best),
      0,
    );
    for (let i = 0; i < 6 && (await this.zoom()) > kZoom; ++i) await this.pinchTogether();
  }

  async crowdNow() {
    const frame = await this.studio.frame();
    const vertices = points(frame.groups[0].vertices);
    return { vertices, middle: mean(vertices), people: crowd(frame) };
  }

  zoom() {
    return this.studio.page.evaluate(() => globalThis.__muster.view.pixelsPerMetre());
  }

  /** A free spot of the canvas far from everything that a finger could hold, as near to `wanted` as can be. */
  async emptyGround(wanted) {
    const { vertices } = await this.crowdNow();
    const mesh = await this.studio.screen(vertices);
    const { width, height } = this.studio.page.viewportSize();
    const spots = [];
    for (let x = 60; x < width; x += 40) for (let y = 60; y < height; y += 40) spots.push({ x, y });
    const free = await this.studio.page.evaluate(
      (list) => list.map(({ x, y }) => document.elementFromPoint(x, y)?.tagName === 'CANVAS'),
      spots,
    );
    const open = spots.filter((spot, i) => free[i] && mesh.every((v) => distance(v, spot) > 90));
    expect(open.length > 0, 'there is empty ground to put a finger on');
    return open.reduce((best, spot) => (distance(spot, wanted) < distance(best, wanted) ? spot : best));
  }

  async pinchTogether() {
    const { width, height } = this.studio.page.viewportSize();
    const at = await this.emptyGround({ x: 0.75 * width, y: 0.5 * height });
    const by = await this.emptyGround({ x: at.x, y: at.y + 200 });
    const centre = mean([at, by]);
    const { fingers } = this.studio;
    await fingers.down({ 1: at, 2: by });
    const half = (p) => shifted(centre, (p.x - centre.x) * 0.75, (p.y - centre.y) * 0.75);
    await fingers.move({ 1: half(at), 2: half(by) }, { ms: 200 });
    await fingers.up();
    await this.studio.wait(150);
  }

  /** Pans with one finger until the middle between crowd and `target` is in the middle of the screen. */
  async look(target) {
    const { width, height } = this.studio.page.viewportSize();
    const centre = { x: 0.45 * width, y: 0.5 * height };
    for (let i = 0; i < 8; ++i) {
      const { middle } = await this.crowdNow();
      const [at] = await this.studio.screen([mean([middle, target])]);
      const [dx, dy] = [centre.x - at.x, centre.y - at.y];
      const way = Math.hypot(dx, dy);
      if (way < 60) return;
      const share = Math.min(1, 350 / way);
      const from = await this.emptyGround(shifted(centre, -0.5 * share * dx, -0.5 * share * dy));
      await this.studio.fingers.down({ 1: from });
      await this.studio.fingers.move({ 1: shifted(from, share * dx, share * dy) }, { ms: 180 });
      await this.studio.fingers.up();
      await this.studio.wait(120);
    }
  }

  /** One stroke along the way, from the leading vertex. */
  async drawOn() {
    let at = (await this.crowdNow()).vertices[this.vertex];
    const stroke = [];
    for (let length = 0; !this.done(); ++this.next) {
      const leg = distance(at, this.way[this.next]);
      if (stroke.length > 0 && length + leg > kStroke) break;
      length += leg;
      at = this.way[this.next];
      stroke.push(at);
    }
    await this.look(at);
    const held = (await this.crowdNow()).vertices[this.vertex];
    const [start, ...stops] = await this.studio.screen([held, ...stroke]);
    await this.studio.fingers.down({ 1: start });
    await this.studio.until('the finger to hold', () =>
      globalThis.__muster.frame.groups[0].controls.some((one) => one.points.some((p) => p.down)),
    );
    for (const stop of stops) await this.studio.fingers.move({ 1: stop }, { steps: 10, ms: 200 });
    await this.studio.fingers.up();
    this.end = at;
  }

  /** The crowd has walked nearly all that was drawn. */
  async untilNearEnd() {
    const near = ([end, vertex]) => {
      const { vertices, controls } = globalThis.__muster.frame.groups[0];
      return controls.length === 0 || Math.hypot(vertices[2 * vertex] - end.x, vertices[2 * vertex + 1] - end.y) < 4;
    };
    await this.studio.until('the crowd to walk', near, [this.end, this.vertex], 120000);
  }
}

/** Another page on the same world, in full quality: what the README shows. */
async function picture(studio, server, path) {
  await studio.wait(1000);
  await studio.send({ type: 'Playback', action: 1 });
  const context = await studio.context.browser().newContext({ viewport: { width: 1440, height: 900 } });
  try {
    const page = await context.newPage();
    await page.addInitScript(() => localStorage.setItem('muster.hint', 'seen'));
    await page.goto(`${server.url}?quality=full`);
    await page.waitForFunction(() => (globalThis.__muster?.frame?.groups.length ?? 0) > 0, null, { timeout: 60000 });
    await page.waitForTimeout(16000); // Tags fade; a software renderer is slow.
    await page.screenshot({ path, timeout: 120000 });
  } finally {
    await context.close();
    await studio.send({ type: 'Playback', action: 0 });
  }
}
