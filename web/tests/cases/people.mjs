// The characters' bodies and motion, and what they cost.
import { expect, expectBetween } from '../support/expect.mjs';
import { percentile } from '../support/geometry.mjs';
import { madeCharacter } from '../support/made_glb.mjs';

/** The look promises no more draws and triangles. Calls of WebGL and bytes sent to it stand for the page's own work: a half more
 * than measured. */
const kBudget = { draws: 60, triangles: 1400000, near: 150, calls: 310, bytes: 680000 };

/** Of ten thousand. */
const kMany = { draws: 60, triangles: 2000000, calls: 260, bytes: 2300000 };

const drawn = (studio) => studio.page.evaluate(() => globalThis.__muster.view.people.drawn);
const stats = (studio) => studio.page.evaluate(() => ({ ...globalThis.__muster.view.stats }));
const sum = (list, what) => list.reduce((total, one) => total + one[what], 0);

/** Share of the pixels in a box round the crowd that are the blue of its shirts. */
async function blueShare(studio) {
  const box = await studio.page.evaluate(() => {
    const { frame, view } = globalThis.__muster;
    const at = Array.from(frame.x, (x, i) => view.worldToScreen({ x, y: frame.y[i] }));
    const [x, y] = [at.map((p) => p.x), at.map((p) => p.y)];
    return {
      x: Math.min(...x),
      y: Math.min(...y) - 20,
      width: Math.max(...x) - Math.min(...x),
      height: Math.max(...y) - Math.min(...y),
    };
  });
  const png = (await studio.page.screenshot({ clip: box })).toString('base64');
  return studio.page.evaluate(async (data) => {
    const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const pen = canvas.getContext('2d');
    pen.drawImage(picture, 0, 0);
    const { data: pixels } = pen.getImageData(0, 0, picture.width, picture.height);
    let blue = 0;
    for (let i = 0; i < pixels.length; i += 4) if (pixels[i + 2] > 1.7 * pixels[i] && pixels[i + 2] > 70) blue += 1;
    return blue / (pixels.length / 4);
  }, png);
}

async function hideMarks(studio) {
  for (const layer of ['m', 'l', 't']) await studio.page.keyboard.press(layer);
  await studio.pictures(3);
}

async function expectPeople(studio, what) {
  await studio.until('bodies from the server', () =>
    globalThis.__muster.view.people.drawn.some((one) => one.body === 'body-1'),
  );
  await hideMarks(studio);
  const bodies = await drawn(studio);
  console.log(`measured: ${what}: ${bodies.map((one) => `${one.body} ${one.near} near, ${one.far} far`).join('; ')}`);
  expect(sum(bodies, 'near') + sum(bodies, 'far') === 100, `all hundred are drawn: ${JSON.stringify(bodies)}`);
  expect(
    bodies.length === 2 && bodies.every((one) => one.near + one.far > 25),
    `two bodies share the crowd: ${JSON.stringify(bodies)}`,
  );
  const share = await blueShare(studio);
  console.log(`measured: ${what}: ${(100 * share).toFixed(1)} % of the crowd's box is blue`);
  expectBetween(share, 0.02, 0.5, 'shirts in the picture');
  await studio.shot(what.replace(/\W+/g, '-'));
  return bodies;
}

/** Bodies of the server, near ones fine, one draw for each body and level. */
export async function appear(studio) {
  const bodies = await expectPeople(studio, 'people');
  expect(sum(bodies, 'near') === 100, 'seen from here all are fine');
  await studio.until('whole poses', () => globalThis.__muster.frame.near.length === 100);
  const before = await stats(studio);
  await studio.page.evaluate(() =>
    globalThis.__muster.view.camera.zoomAt({ x: innerWidth / 2, y: innerHeight / 2 }, 0.3),
  );
  await studio.eventually(async () => {
    const far = await drawn(studio);
    expect(sum(far, 'far') === 100, `from afar all are coarse: ${JSON.stringify(far)}`);
  });
  await studio.pictures(2);
  const after = await stats(studio);
  console.log(
    `measured: a hundred near: ${before.drawCalls} draws, ${before.triangles} triangles; far: ${after.drawCalls} draws, ${after.triangles} triangles`,
  );
  // Per body a draw and one into the shadow map fewer.
  expectBetween(before.drawCalls - after.drawCalls, 1, 4, 'draws that the fine ones take more');
  expect(after.triangles < 0.4 * before.triangles, 'coarse bodies have fewer triangles');
}

export async function appearLight(studio) {
  const bodies = await expectPeople(studio, 'people in light quality');
  expect(sum(bodies, 'near') === 0, 'software renderers draw coarse bodies alone');
  const near = await studio.page.evaluate(() => globalThis.__muster.frame.near.length);
  expect(near === 0, `and ask for no whole poses: ${near}`);
}

/** Clips of the motions that characters play now. */
function playing() {
  const { frame, view } = globalThis.__muster;
  return [...new Set(Array.from(frame.clip, (clip) => view.people.clips[clip]))];
}

/** On the way over the course people climb, crawl and swim, with whole bodies. */
export async function motions(studio) {
  await studio.page.keyboard.press('w');
  await studio.until('the demonstration', () => globalThis.__muster.frame.demonstrating);
  await studio.send({ type: 'SetSpeed', factor: 8 });
  const seen = new Set();
  for (const motion of ['climb', 'crawl', 'swim']) {
    await studio.until(
      `somebody who plays ${motion}`,
      (name) => {
        const { frame, view } = globalThis.__muster;
        const clip = view.people.clips.indexOf(name);
        return frame.clip.some((one) => one === clip);
      },
      motion,
      90000,
    );
    for (const clip of await studio.page.evaluate(playing)) seen.add(clip);
    await studio.shot(`motion-${motion}`);
  }
  console.log(`measured: clips seen on the course: ${[...seen].sort().join(', ')}`);
  expect(seen.size >= 6, `many clips are played: ${[...seen].join(', ')}`);
}

const choose = (studio, name, buffer) =>
  studio.page
    .locator('input[aria-label="Open a character"]')
    .setInputFiles({ name, mimeType: 'model/gltf-binary', buffer });
const notice = (studio) => studio.page.locator('.banner.notice strong').textContent();

export async function ownCharacter(studio) {
  const mixamo = (name) => `mixamorig:${name.replace('Chest', 'Spine2')}`;
  await choose(studio, 'robot.glb', madeCharacter({ rename: mixamo, unit: 100, clip: 'Armature|Run' }));
  await studio.until('everybody to be it', () =>
    globalThis.__muster.view.people.drawn.every((one) => one.body === 'robot.glb' && one.near + one.far > 0),
  );
  expect(/robot\.glb now, with run of its own/.test(await notice(studio)), `it is told: ${await notice(studio)}`);
  await studio.shot('own-character');
  await choose(studio, 'painted.glb', madeCharacter({ picture: true }));
  await studio.until('one with a picture', () =>
    globalThis.__muster.view.people.drawn.every((one) => one.body === 'painted.glb' && one.near + one.far > 0),
  );
  await studio.pictures(2);
  await choose(studio, 'legless.glb', madeCharacter({ rename: (name) => (name === 'LeftLeg' ? null : name) }));
  await studio.until('what is missing', () =>
    /no joint for the left knee/.test(document.querySelector('.banner.notice strong').textContent),
  );
  expect((await drawn(studio))[0].body === 'painted.glb', 'the one before stays');
  await studio.page.reload();
  await studio.until('the same people after a reload', () => {
    const drawn = globalThis.__muster?.view.people.drawn ?? [];
    return drawn.length > 0 && drawn.every((one) => one.body === 'painted.glb' && one.near + one.far > 0);
  });
  await studio.page.evaluate(() =>
    [...document.querySelectorAll('.menu-item')].find((one) => one.textContent === 'Our people').click(),
  );
  await studio.until('our people', () =>
    globalThis.__muster.view.people.drawn.every((one) => one.body !== 'painted.glb'),
  );
}

/** Of so many pictures while everybody walks: the page's time of each [ms], and calls and bytes to WebGL of one. */
async function costs(studio, pictures) {
  const cost = await studio.page.evaluate(
    (count) =>
      new Promise((done) => {
        const { stats } = globalThis.__muster.view;
        const { webgl } = globalThis;
        const start = { ...webgl, pictures: stats.pictures };
        const times = [];
        let last = stats.pictures;
        const look = () => {
          if (stats.pictures !== last) times.push(stats.pictureMs);
          last = stats.pictures;
          if (times.length < count) return requestAnimationFrame(look);
          const drawn = last - start.pictures;
          done({ times, calls: (webgl.calls - start.calls) / drawn, bytes: (webgl.bytes - start.bytes) / drawn });
        };
        look();
      }),
    pictures,
  );
  return { ...cost, ...(await stats(studio)) };
}

async function expectBudget(studio, what, budget) {
  const { times, calls, bytes, drawCalls, triangles } = await costs(studio, 12);
  const [half, most] = [percentile(times, 0.5), percentile(times, 0.95)];
  const [called, sent] = [Math.round(calls), Math.round(bytes)];
  console.log(
    `measured: ${what}: ${drawCalls} draws, ${triangles} triangles, ${called} calls and ${sent} bytes to WebGL`,
  );
  console.log(`measured: ${what}: page ${half.toFixed(2)} ms a picture (p95 ${most.toFixed(2)} ms)`);
  expect(drawCalls <= budget.draws, `${drawCalls} draws, at most ${budget.draws}`);
  expect(triangles <= budget.triangles, `${triangles} triangles, at most ${budget.triangles}`);
  expect(called <= budget.calls, `${called} calls of WebGL for a picture, at most ${budget.calls}`);
  expect(sent <= budget.bytes, `${sent} bytes to WebGL for a picture, at most ${budget.bytes}`);
}

export async function budgets(studio) {
  await studio.until('bodies from the server', () =>
    globalThis.__muster.view.people.drawn.some((one) => one.body === 'body-1'),
  );
  await studio.until('near ones', (most) => globalThis.__muster.frame.near.length === most, kBudget.near);
  await studio.shot('thousand');
  await expectBudget(studio, `a thousand people, ${kBudget.near} with whole poses`, kBudget);
  expect(
    /draws · .* triangles/.test(await studio.page.locator('.stats-readout').textContent()),
    'the address shows the figures',
  );
}

/** Ten thousand who walk, from a server that makes them up: everybody is drawn, most of them tiny. */
export async function budgetsOfMany(studio, server) {
  await studio.until('bodies from the server', () =>
    globalThis.__muster.view.people.drawn.some((one) => one.body === 'body-1'),
  );
  await studio.until(
    'settled levels',
    () => globalThis.__muster.view.people.drawn.reduce((sum, one) => sum + one.far, 0) <= 1600,
    undefined,
    60000,
  );
  const bodies = await drawn(studio);
  const all = sum(bodies, 'near') + sum(bodies, 'far') + sum(bodies, 'tiny');
  console.log(
    `measured: ten thousand people: ${sum(bodies, 'near')} near, ${sum(bodies, 'far')} far, ${sum(bodies, 'tiny')} tiny`,
  );
  expect(all === 10000, `all are drawn: ${JSON.stringify(bodies)}`);
  const bytes = Math.max(...server.sizes()) / 10000;
  expectBetween(bytes, 4, 8, 'bytes of a frame for each');
  await studio.shot('ten-thousand');
  expect(
    /^10\D?000/.test(await studio.page.locator('.figure-characters .value').textContent()),
    'the readout counts them',
  );
  await expectBudget(studio, `ten thousand people, 100 with whole poses, ${bytes.toFixed(2)} bytes each`, kMany);
}
