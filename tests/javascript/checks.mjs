// Counting of checks, and what the cases share: the installed package, the native program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export { assert };
export const root = join(dirname(fileURLToPath(import.meta.url)), '../..');

/** The folder into which the package is installed, and the native program. */
export const [place, program] = [process.env.PLACE, process.env.PROGRAM];

/** The package as a program imports it: entry.mjs stands beside node_modules. */
export const engine = await import(pathToFileURL(join(place, 'entry.mjs')).href);

const cases = [];

/** Names a case, which fails where it throws. */
export function test(name, action) {
  cases.push({ name, action });
}

/** Runs all cases and ends the program. */
export async function runAll() {
  let [passed, failed] = [0, 0];
  for (const { name, action } of cases) {
    const began = performance.now();
    try {
      await action();
      passed += 1;
      console.log(`ok    ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed += 1;
      console.log(`FAIL  ${name}: ${error.stack}`);
    }
  }
  console.log(`${passed} passed, ${failed} failed`);
  process.exit(failed === 0 ? 0 : 1);
}

/** Expects a MusterError of that code whose sentence has these words. */
export function refused(code, words, action) {
  assert.throws(action, (error) => {
    assert.ok(error instanceof engine.MusterError, `found ${error?.stack ?? error}`);
    assert.equal(error.code, engine.Status[code], error.message);
    assert.ok(error.message.includes(words), `"${error.message}" does not say "${words}"`);
    assert.ok(!error.message.includes('\n') && error.message.length > 10, error.message);
    return true;
  });
}

export const native = (...given) =>
  execFileSync(program, given, {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    cwd: root,
  });

export const api = JSON.parse(readFileSync(join(root, 'docs/api/muster_api.json'), 'utf8'));

/** Names, plans, steps and hashes of tests/hashes/references.txt. */
export const references = readFileSync(join(root, 'tests/hashes/references.txt'), 'utf8')
  .trim()
  .split('\n')
  .map((line) => line.split(' '))
  .map(([name, plan, steps, hash]) => ({
    name,
    plan,
    steps: Number(steps),
    hash,
  }));

export const hex = (hash) => hash.toString(16).padStart(16, '0');

/** All scenarios and gestures, in the module's files. */
export function withScenarios(muster) {
  const folder = join(root, 'scenarios');
  for (const path of readdirSync(folder, { recursive: true }))
    if (path.endsWith('.json')) muster.files.write(`/scenarios/${path}`, readFileSync(join(folder, path)));
  return muster;
}

/** A world of a scenario with the commands that it carries; `plan` as in the references. */
export function begin(muster, name, plan) {
  const path = `/scenarios/${name}.json`;
  const loaded = muster.Scenario.load(path);
  const def = loaded.def();
  def.parameters.push({ name: 'plan.solver', value: plan === 'fast' ? 1 : 0 });
  const scenario = muster.Scenario.fromDef(def);
  const world = scenario.createWorld();
  const commands = muster.gesturesOfScenario(path, scenario);
  for (const command of commands) world.submit(command);
  loaded.destroy();
  scenario.destroy();
  return { def, world, commands };
}

/** A small world to try things on: 36 characters round the origin. */
export const smallDef = {
  box: { min: { x: -20, y: -20 }, max: { x: 20, y: 20 } },
  obstacles: [{ name: 'pillar', centre: { x: 9, y: 0 }, radius: 1.5 }],
  groups: [{ name: 'all', count: 36 }],
};
