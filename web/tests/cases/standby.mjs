// A server that is lost: the page goes on with its world, with the engine that waited in the browser.
import { expect } from '../support/expect.mjs';
import { crowd, distance } from '../support/geometry.mjs';
import { startStudio } from '../support/server.mjs';
import { StudioPage } from '../support/studio_page.mjs';
import { steer } from './site.mjs';
import { record, stop } from './takes.mjs';

const step = (studio) => studio.page.evaluate(() => globalThis.__muster.frame.step);
const ask = (studio, path, method = 'GET') =>
  studio.page.evaluate(
    async ([target, verb]) => (await globalThis.__muster.ask(target, { method: verb })).status,
    [path, method],
  );

/** `run` is given a page of a studio whose server can be killed. */
async function withServer(browser, size, options, run) {
  const server = await startStudio({ scenario: 'open', options });
  const studio = await StudioPage.open(browser, server.url, { size });
  try {
    await run(studio, server);
  } catch (error) {
    await studio.shot('failed-standby').catch(() => undefined);
    throw error;
  } finally {
    await studio.close().catch(() => undefined);
    await server.stop();
  }
}

async function steerOn(studio) {
  await studio.fit();
  await steer(studio);
}

/** The world goes on where it was, is steered, recorded and exported without a server. */
export async function goesOn(browser, { engine }, size) {
  await withServer(browser, size, ['--engine', engine], async (studio, server) => {
    await steerOn(studio);
    await record(studio, 1);
    await studio.until('the engine on standby', () => globalThis.__muster.state.standby === 'ready', null, 60000);
    await studio.wait(4000);
    const before = await step(studio);
    const places = crowd(await studio.frame());
    server.kill();
    const button = studio.page.getByRole('button', { name: 'Go on without server' });
    await button.waitFor({ timeout: 15000 });
    await studio.shot('standby-lost');
    await button.click();
    await studio.until('the engine', () => globalThis.__muster.connected, null, 30000);
    await studio.page.getByText('This browser simulates now').waitFor();
    await studio.shot('standby-on');
    const after = await step(studio);
    expect(after > before - 60 * 8, `it goes on from step ${before}: ${after}`);
    const moved = crowd(await studio.frame()).map((at, i) => distance(at, places[i]));
    expect(Math.max(...moved) < 12, `everybody is near where they were: ${Math.max(...moved)}`);
    console.log(`measured: a lost server at step ${before}, the page's engine shows step ${after} (${size})`);
    await steerOn(studio);
    expect(await studio.page.evaluate(() => globalThis.__muster.state.recorded > 1), 'the recording goes on');
    await stop(studio);
    expect((await ask(studio, 'takes')) === 200, 'the shelf is there');
    await studio.page.evaluate(() => globalThis.__muster.client.send({ type: 'LoadScenario', name: 'market' }));
    await studio.until('another scenario', () => globalThis.__muster.state.scenario === 'market');
  });
}

/** Without a built engine there is no such button. */
export async function withoutEngine(browser, { empty }, size) {
  await withServer(browser, size, ['--engine', empty], async (studio, server) => {
    server.kill();
    await studio.page.getByText('Connection lost').waitFor({ timeout: 15000 });
    const shown = await studio.page.getByRole('button', { name: 'Go on without server' }).isVisible();
    expect(!shown, 'nothing can go on without the server');
  });
}
