// Connection, latency, takes.
import { expect } from '../support/expect.mjs';
import { extreme, percentile, points, shifted } from '../support/geometry.mjs';
import { startStudio } from '../support/server.mjs';

const ROUNDS = 3;
const TOUCHES = 30;
/** With a GPU, and where the processor draws as well: that shares its cores with the simulation and the browser. */
const LIMIT_MS = 50;
const SOFTWARE_LIMIT_MS = 200;

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

/** One round of touches [ms]: from event to the first changed frame's arrival, and to the picture of it. */
async function latencyRound(studio) {
  const before = await studio.page.evaluate(() => {
    const { client, latency, view } = globalThis.__muster;
    latency.splice(0);
    const steps = (globalThis.__steps = []);
    globalThis.__endSteps = client.on('frame', ({ frame }) => steps.push(frame.stepMs));
    return { pictures: view.stats.pictures, time: performance.now() };
  });
  for (let i = 0; i < TOUCHES; ++i) await touchCorner(studio, i);
  await studio.wait(500);
  return studio.page.evaluate(({ pictures, time }) => {
    const { latency, view } = globalThis.__muster;
    globalThis.__endSteps();
    return {
      steps: globalThis.__steps,
      received: latency.map((one) => 1000 * (one.received - one.down)),
      drawn: latency.map((one) => 1000 * (one.shown - one.down)),
      rate: (1000 * (view.stats.pictures - pictures)) / (performance.now() - time),
    };
  }, before);
}

const spread = (times) => `p50 ${percentile(times, 0.5).toFixed(1)} ms, p95 ${percentile(times, 0.95).toFixed(1)} ms`;

/** From a finger's event to the first frame of the simulation that shows its effect, drawn by the page's render call.
 * What a GPU, or the processor in its place, does after that call is not counted. The best of some rounds counts:
 * other programs on the machine may disturb one. */
export async function latency(studio) {
  await studio.wait(1500);
  const software = await studio.page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const info = gl?.getExtension('WEBGL_debug_renderer_info');
    return /llvmpipe|softpipe|swiftshader|software/i.test(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '');
  });
  const limit = software ? SOFTWARE_LIMIT_MS : LIMIT_MS;
  let best = Infinity;
  let bestReceived = Infinity;
  for (let round = 0; round < ROUNDS; ++round) {
    await studio.restart();
    await studio.wait(300);
    const { received, drawn, rate, steps } = await latencyRound(studio);
    expect(drawn.length >= TOUCHES, `every touch was shown: ${drawn.length} of ${TOUCHES}`);
    console.log(`measured: touch to changed frame received, ${received.length} events: ${spread(received)}`);
    console.log(
      `measured: touch to changed frame drawn, ${drawn.length} events: ${spread(drawn)} (${rate.toFixed(0)} pictures/s)`,
    );
    console.log(
      `measured: live simulation steps of 100 characters, ${steps.length} frames: ${spread(steps)}; wanted p95 16 ms`,
    );
    best = Math.min(best, percentile(drawn, 0.95));
    bestReceived = Math.min(bestReceived, percentile(received, 0.95));
  }
  await studio.shot('latency');
  console.log(
    `measured: touch to changed frame, best p95 ${best.toFixed(1)} ms; wanted ${LIMIT_MS} ms, asserted ${limit} ms${software ? ' (no GPU)' : ''}`,
  );
  console.log(
    `measured: touch to changed frame received, best p95 ${bestReceived.toFixed(1)} ms; wanted ${LIMIT_MS} ms`,
  );
  // Until it is received nothing is drawn, but a processor that draws beside it still takes its share.
  expect(bestReceived <= (software ? 2 * LIMIT_MS : LIMIT_MS), `p95 until received is ${bestReceived.toFixed(1)} ms`);
  expect(best <= limit, `p95 of the best round is ${best.toFixed(1)} ms, at most ${limit} allowed`);
}

/** A page that hangs must not slow the simulation, and sees the newest frame when it wakes. */
export async function stalledPage(studio) {
  const result = await studio.page.evaluate(async () => {
    const muster = globalThis.__muster;
    const before = { time: performance.now(), step: muster.frame.step };
    while (performance.now() - before.time < 2000);
    await new Promise((resolve) => setTimeout(resolve, 250));
    return { steps: muster.frame.step - before.step, seconds: (performance.now() - before.time) / 1000 };
  });
  const expected = 60 * result.seconds;
  expect(
    result.steps > 0.85 * expected,
    `${result.steps} steps in ${result.seconds} s: the simulation went on and the page is up to date`,
  );
}

/** The server goes and comes back. */
export async function lostAndFound(studio, server) {
  await server.stop();
  await studio.until('the banner', () => document.documentElement.hasAttribute('data-lost'));
  expect(await studio.page.locator('.banner', { hasText: 'Connection lost' }).isVisible(), 'the banner tells of it');
  await studio.wait(300);
  await studio.shot('lost');
  const again = await startStudio({ port: server.port });
  expect(again.port === server.port, 'the same port again');
  await studio.page
    .locator('.banner', { hasText: 'Try now' })
    .locator('button', { hasText: 'Try now' })
    .click({ timeout: 1500 })
    .catch(() => undefined);
  await studio.until(
    'the connection',
    () => globalThis.__muster.connected && !document.documentElement.hasAttribute('data-lost'),
    null,
    20000,
  );
  const { step } = await studio.frame();
  await studio.send({ type: 'Transport', action: 0 });
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
  await studio.wait(800);
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
  expect(await studio.page.locator('.replay-label').isVisible(), 'the transport tells of the replay');
  expect(await studio.page.locator('.record').isDisabled(), 'a replay is not recorded');
  await studio.wait(300);
  await studio.shot('replay');
  const broken = await studio.page.evaluate(
    async () => (await fetch('take', { method: 'POST', body: 'no take' })).status,
  );
  expect(broken === 400, `what is no take is refused: ${broken}`);
  await studio.page.locator('.leave').click();
  await studio.until(
    'the scenario',
    () => !globalThis.__muster.frame.replaying && globalThis.__muster.state.scenario === 'hundred',
  );
  expect(!(await studio.page.locator('.leave').isVisible()), 'there is nothing to leave any more');
}
