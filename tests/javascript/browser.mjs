// Tests of the npm package in Chromium: a plain page with a worker, and the samples. PLACE is the folder into which the package is
// installed, PROGRAM the native program; SHOTS, where it is given, gets pictures of the samples.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, readdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { openChromium } from '../../web/tests/support/chromium.mjs';
import { serve } from '../../web/tests/support/plain_server.mjs';
import { assert, native, place, references, root, runAll, test } from './checks.mjs';

const kRuns = references.filter(({ name, plan }) => plan === 'fast' && /x01|x02|x03|x08|x11|^corridor$/.test(name));

const browser = await openChromium();

/** Opens a folder's page, and expects it to complain of nothing. */
async function withPage(folder, file, action) {
  const server = await serve(folder);
  const page = await (await browser.newContext({ viewport: { width: 1100, height: 720 } })).newPage();
  const problems = [];
  page.on('pageerror', ({ message }) => problems.push(message));
  page.on(
    'console',
    (message) => message.type() === 'error' && !/favicon/.test(message.location().url) && problems.push(message.text()),
  );
  try {
    await page.goto(server.url + file);
    await action(page);
    assert.deepEqual(problems, []);
  } finally {
    await page.context().close();
    server.stop();
  }
}

async function shot(page, name) {
  if (!process.env.SHOTS) return;
  mkdirSync(process.env.SHOTS, { recursive: true });
  await page.screenshot({ path: join(process.env.SHOTS, `${name}.png`) });
}

const wait = (page, condition, argument) => page.waitForFunction(condition, argument, { timeout: 60000 });

test('a plain page and its worker: the same hashes as native, and a take that the program reproduces', async () => {
  const folder = join(root, 'scenarios');
  const paths = readdirSync(folder, { recursive: true }).filter((path) => path.endsWith('.json'));
  const files = Object.fromEntries(paths.map((path) => [path, readFileSync(join(folder, path), 'utf8')]));
  writeFileSync(join(place, 'scenarios.json'), JSON.stringify(files));
  writeFileSync(join(place, 'runs.json'), JSON.stringify(kRuns));
  cpSync(join(root, 'tests/javascript/pages'), place, { recursive: true });
  await withPage(place, 'plain.html', async (page) => {
    await wait(page, () => globalThis.found);
    const { here, there, take, problem } = await page.evaluate(() => globalThis.found);
    assert.equal(problem, undefined);
    const wanted = kRuns.map(({ hash }) => hash);
    assert.ok(wanted.length >= 8);
    assert.deepEqual(here, wanted);
    assert.deepEqual(there, wanted);
    writeFileSync(join(place, 'page.take'), Uint8Array.from(take.bytes));
    const report = JSON.parse(native('replay', join(place, 'page.take'), '--json'));
    assert.deepEqual([report.reproduced, report.steps, report.hash], [true, 400, take.hash]);
  });
});

/** A sample with the installed package and, from the page's packages, the other one that it needs. */
function sample(name, one) {
  const folder = join(place, name);
  cpSync(join(root, 'samples', name), folder, {
    recursive: true,
    filter: (path) => !/node_modules|\/dist/.test(path),
  });
  mkdirSync(join(folder, 'node_modules'));
  cpSync(join(place, 'node_modules/muster-engine'), join(folder, 'node_modules/muster-engine'), { recursive: true });
  symlinkSync(join(root, 'web/node_modules', one), join(folder, 'node_modules', one));
  const { dependencies, devDependencies } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const { version } = JSON.parse(readFileSync(join(root, `web/node_modules/${one}/package.json`), 'utf8'));
  assert.equal({ ...dependencies, ...devDependencies }[one], version, `${one} as in web/`);
  return folder;
}

/** The point of the line "100 people at X, Y." */
const toldPoint = async (page) =>
  (await page.textContent('#line'))
    .match(/at (-?\d+\.\d), (-?\d+\.\d)/)
    .slice(1)
    .map(Number);

async function tryDiscs(page) {
  await wait(page, () => /people at/.test(document.querySelector('#line').textContent));
  const [x, y] = await toldPoint(page);
  assert.ok(Math.hypot(x + 16, y) < 0.5, `they begin at ${x}, ${y}`);
  // The front from bottom to top at x = 12 m, as the canvas shows it: 48 m across its width, or 32 m down its height.
  const scale = Math.min(1100 / 48, 720 / 32);
  const to = (metresX, metresY) => [550 + metresX * scale, 360 - metresY * scale];
  await page.mouse.move(...to(12, 6));
  await page.mouse.down();
  await page.mouse.move(...to(12, 0));
  await page.mouse.move(...to(12, -6));
  await page.mouse.up();
  // The way takes 28 m; a part of it is enough, but for pictures.
  const farther = (x) => Number(document.querySelector('#line').textContent.match(/at (-?[\d.]+)/)[1]) > x;
  await wait(page, farther, process.env.SHOTS ? 1 : -12);
  await shot(page, 'js-vite');
}

test('the sample with Vite: built offline, a hundred people follow a drawn front', async () => {
  const folder = sample('js_vite', 'vite');
  execFileSync(process.execPath, [join(folder, 'node_modules/vite/bin/vite.js'), 'build', '--logLevel', 'error'], {
    cwd: folder,
    stdio: 'inherit',
  });
  const files = readdirSync(join(folder, 'dist/assets'));
  assert.equal(files.filter((name) => name.endsWith('.wasm')).length, 1, `one module in ${files}`);
  await withPage(join(folder, 'dist'), '', tryDiscs);
});

test('the sample with Vite’s development server', async () => {
  const folder = join(place, 'js_vite');
  const { createServer } = await import(join(folder, 'node_modules/vite/dist/node/index.js'));
  const server = await createServer({
    root: folder,
    configFile: join(folder, 'vite.config.js'),
    logLevel: 'error',
    server: { port: 0, fs: { strict: true } },
  });
  await server.listen();
  const page = await browser.newPage();
  try {
    await page.goto(server.resolvedUrls.local[0]);
    await wait(page, () => /people at/.test(document.querySelector('#line').textContent));
  } finally {
    await page.close();
    await server.close();
  }
});

test('the sample with three.js alone: the blue company is sent through between the houses', async () => {
  await withPage(sample('js_three', 'three'), '', async (page) => {
    await wait(page, () => /Step \d+, 0\.00 m from/.test(document.querySelector('#line').textContent));
    await page.mouse.click(760, 430);
    await wait(page, () => Number(document.querySelector('#line').textContent.match(/([\d.]+) m from/)[1]) > 0);
    if (process.env.SHOTS) await page.waitForTimeout(25000);
    await shot(page, 'js-three');
    // Its picture holds blue and red.
    const seen = await page.evaluate(async () => {
      const canvas = document.querySelector('canvas');
      await new Promise((done) => requestAnimationFrame(done));
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
      copy.drawImage(await createImageBitmap(canvas), 0, 0);
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      const counts = { blue: 0, red: 0 };
      for (let k = 0; k < data.length; k += 4) {
        if (data[k + 2] > data[k] + 60) counts.blue += 1;
        if (data[k] > data[k + 2] + 60) counts.red += 1;
      }
      return counts;
    });
    assert.ok(seen.blue > 1000 && seen.red > 500, JSON.stringify(seen));
  });
});

await runAll();
