// Connection, latency, takes.
import { expect } from '../support/expect.mjs';
import { extreme, percentile, points, shifted } from '../support/geometry.mjs';
import { startStudio } from '../support/server.mjs';

const kTouches = 20;

/** A touch on another corner each time: the last control is still on its way. */
async function touchCorner(studio, i) {
  const [x, y] = [
    [1, 0.5],
    [-1, 0.5],
    [-0.5, -1],
    [0.5, -1],
  ][i % 4];
  const corner = extreme(points((await studio.frame()).groups[0].vertices), x, y);
  const [from, to] = await studio.screen([corner, shifted(corner, 0.4, 0.2)]);
  await studio.fingers.down({ 1: from });
  await studio.fingers.move({ 1: to }, { steps: 2, ms: 60 });
  await studio.fingers.up();
  await studio.wait(60 + (i % 7) * 5);
}

/** In the page: counts, for each touch, the frames that arrive until one shows it, and the pictures from then on. */
function watchTouches() {
  const { client, latency, view } = globalThis.__muster;
  latency.splice(0);
  const seen = { frames: [], pictures: [], steps: [], times: latency };
  let frames = 0;
  let waiting = [];
  let arrived = [];
  const sent = client.send.bind(client);
  client.send = (message) => {
    if (message.type === 'Touches')
      for (const { time, phase } of message.events) if (phase <= 1) waiting.push({ time, frames });
    sent(message);
  };
  client.on('frame', ({ frame }) => {
    frames += 1;
    seen.steps.push(frame.stepMs);
    const shown = waiting.filter((one) => one.time <= frame.touchEcho);
    waiting = waiting.filter((one) => one.time > frame.touchEcho);
    for (const one of shown) seen.frames.push(frames - one.frames);
    for (const { time } of shown) arrived.push({ time, frame: frame.frame, pictures: view.stats.pictures });
  });
  const look = () => {
    const { pictures, shownFrame } = view.stats;
    for (const one of arrived) if (one.frame <= shownFrame) seen.pictures.push(pictures - one.pictures);
    arrived = arrived.filter((one) => one.frame > shownFrame);
    requestAnimationFrame(look);
  };
  look();
  globalThis.__touches = seen;
}

const spread = (list, unit) =>
  `p50 ${percentile(list, 0.5).toFixed(1)}${unit}, p95 ${percentile(list, 0.95).toFixed(1)}${unit}`;

/** A touch is shown by one of the next frames of the simulation, and drawn by the next picture. Times are only printed: they
 * depend on what else the machine does. */
export async function latency(studio) {
  await studio.page.evaluate(watchTouches);
  for (let i = 0; i < kTouches; ++i) await touchCorner(studio, i);
  await studio.until('every touch', (count) => globalThis.__touches.times.length >= count, kTouches);
  await studio.pictures(2);
  const { frames, pictures, steps, times } = await studio.page.evaluate(() => globalThis.__touches);
  await studio.shot('latency');
  const ms = (name) =>
    spread(
      times.map((one) => 1000 * (one[name] - one.down)),
      ' ms',
    );
  console.log(`measured: touch to changed frame received, ${times.length} events: ${ms('received')}`);
  console.log(`measured: touch to changed frame drawn, ${times.length} events: ${ms('shown')}`);
  console.log(`measured: live simulation steps of 100 characters, ${steps.length} frames: ${spread(steps, ' ms')}`);
  console.log(
    `measured: frames from a touch to the one that shows it: ${spread(frames, '')}; pictures from then on: ${spread(pictures, '')}`,
  );
  expect(times.length >= kTouches, `every touch was shown: ${times.length} of ${kTouches}`);
  expect(
    times.every((one) => one.down <= one.received && one.received <= one.shown),
    'down, received and shown follow each other',
  );
  expect(percentile(frames, 0.5) <= 3, `half of the touches are shown within 3 frames: ${frames}`);
  expect(percentile(pictures, 0.95) <= 2, `a frame that shows a touch is drawn at once: ${pictures} pictures`);
}

/** In the page: steps of the world, and frames that the page takes, while it hangs or not for so long [ms]. */
async function worldMeanwhile([ms, hang]) {
  const { client } = globalThis.__muster;
  const wait = (time) => new Promise((resolve) => setTimeout(resolve, time));
  const start = { time: performance.now(), step: globalThis.__muster.frame.step };
  while (hang && performance.now() - start.time < ms);
  if (!hang) await wait(ms);
  let frames = 0;
  const end = client.on('frame', () => (frames += 1));
  await wait(250);
  end();
  return {
    frames,
    steps: globalThis.__muster.frame.step - start.step,
    seconds: (performance.now() - start.time) / 1000,
  };
}

/** A page that hangs must not slow the simulation, and sees the newest frame when it wakes. */
export async function stalledPage(studio) {
  const idle = await studio.page.evaluate(worldMeanwhile, [2000, false]);
  const hung = await studio.page.evaluate(worldMeanwhile, [2000, true]);
  const rate = (one) => one.steps / one.seconds;
  console.log(
    `measured: steps a second while the page draws ${rate(idle).toFixed(1)}, while it hangs ${rate(hung).toFixed(1)}`,
  );
  expect(rate(hung) > 0.6 * rate(idle), `the simulation goes on: ${rate(hung)} steps a second of ${rate(idle)}`);
  expect(
    hung.frames < 0.5 * hung.steps,
    `the page takes the newest frame, not all that came: ${hung.frames} of ${hung.steps} steps`,
  );
}

/** The server goes and comes back. */
export async function lostAndFound(studio, server) {
  await server.stop();
  await studio.until('the banner', () => document.documentElement.hasAttribute('data-lost'));
  expect(await studio.page.locator('.banner', { hasText: 'Connection lost' }).isVisible(), 'the banner tells of it');
  await studio.shot('lost');
  const again = await startStudio({ port: server.port });
  expect(again.port === server.port, 'the same port again');
  await studio.connected();
  const { step } = await studio.frame();
  await studio.send({ type: 'Playback', action: 0 });
  await studio.until('new frames', (n) => globalThis.__muster.frame.step !== n, step);
  return again;
}

/** A take is recorded, downloaded, and opened again. */
export async function recordAndReplay(studio) {
  await studio.page.locator('.record').click();
  await studio.until('the record clock', () => /^0:0\d\.\d$/.test(document.querySelector('.record-label').textContent));
  const corner = extreme(points((await studio.frame()).groups[0].vertices), 1, 0);
  const [from, to] = await studio.screen([corner, shifted(corner, 3, 0)]);
  await studio.fingers.down({ 1: from });
  await studio.fingers.move({ 1: to }, { ms: 400 });
  await studio.fingers.up();
  await studio.until('half a second of it', () => globalThis.__muster.frame.recordedSeconds > 0.5);
  await studio.shot('record');
  await studio.page.locator('.record').click();
  await studio.until('the end of the record', () => globalThis.__muster.frame.recordedSeconds < 0);
  const opened = await studio.page.evaluate(async () => {
    const take = await (await fetch('take')).blob();
    const answer = await fetch('take', { method: 'POST', body: take });
    return { size: take.size, status: answer.status, text: await answer.text() };
  });
  expect(opened.size > 100, `the take has ${opened.size} bytes`);
  expect(opened.status === 200, `it opens again: ${opened.status} ${opened.text}`);
  await studio.until('the replay', () => globalThis.__muster.frame.replaying);
  await studio.until('the time line', () => document.querySelector('.time-line')?.hidden === false);
  expect(!(await studio.page.locator('.record').isVisible()), 'a replay is not recorded');
  await studio.pictures(1);
  await studio.shot('replay');
  const broken = await studio.page.evaluate(
    async () => (await fetch('take', { method: 'POST', body: 'no take' })).status,
  );
  expect(broken === 400, `what is no take is refused: ${broken}`);
  await studio.page.locator('.time-close').click();
  await studio.until(
    'the scenario',
    () => !globalThis.__muster.frame.replaying && globalThis.__muster.state.scenario === 'hundred',
  );
  await studio.until('the time line to go', () => document.querySelector('.time-line').hidden);
}
