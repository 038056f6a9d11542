// Prints the sizes of the package and its speed beside the native program: no check. Usage: measure.mjs PLACE PROGRAM
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

const [place, program] = process.argv.slice(2);
process.env.PLACE = place;
const { begin, engine, root, withScenarios } = await import('./checks.mjs');
const folder = join(place, 'node_modules/muster-engine/dist');
const kilobytes = (name) => Math.round(gzipSync(readFileSync(join(folder, name)), { level: 9 }).length / 1000);
const tarball = readdirSync(place).find((name) => name.endsWith('.tgz'));
console.log(
  `measured: with gzip muster.wasm takes ${kilobytes('muster.wasm')} kB, index.js ${kilobytes('index.js')} kB; the tarball ` +
    `${Math.round(readFileSync(join(place, tarball)).length / 1000)} kB`,
);

const began = performance.now();
const muster = withScenarios(await engine.loadMuster());
console.log(`measured: the library is loaded in ${Math.round(performance.now() - began)} ms under Node`);
const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];
for (const name of ['block', 'market']) {
  const given = [
    'play',
    join(root, `scenarios/${name}.json`),
    '--demo',
    '--threads',
    '1',
    '--set',
    'plan.solver=1',
    '--json',
  ];
  const { steps, step_ms: native } = JSON.parse(execFileSync(program, given, { encoding: 'utf8', cwd: root }));
  const { world } = begin(muster, name, 'fast');
  const times = [];
  for (let k = 0; k < steps; k += 1) {
    const from = performance.now();
    world.step();
    times.push(performance.now() - from);
  }
  const { count } = world.characters();
  const [ours, theirs] = [median(times), native.p50];
  console.log(
    `measured: ${name}, ${count} characters: ${ours.toFixed(3)} ms a step (median of ${steps}), native ${theirs.toFixed(3)} ms, ` +
      `${(ours / theirs).toFixed(1)} times`,
  );
}
