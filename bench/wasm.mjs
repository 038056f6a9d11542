// Times every scenario natively and as WebAssembly under Node, by turns, and prints the ratios as a table.
// Usage: node bench/wasm.mjs [--seconds 6] [--rounds 2] [--plays 12] [--threads 1] NAME=PROGRAM.js...
// Build first: cmake --build build/release --target scenario_times; bash scripts/wasm.sh scenario_times
import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';

const options = { seconds: '6', rounds: '2', threads: '1', plays: '12' };
const builds = [];
const given = process.argv.slice(2);
while (given.length > 0) {
  const word = given.shift();
  if (word.startsWith('--')) options[word.slice(2)] = given.shift();
  else builds.push(word.split('='));
}
if (builds.length === 0) builds.push(['WebAssembly', 'build/wasm/bench/scenarios/scenario_times.js']);

const scenarios = ['scenarios', 'scenarios/paper'].flatMap((folder) =>
  readdirSync(folder)
    .filter((name) => name.endsWith('.json'))
    .map((name) => join(folder, name)),
);

/** One scenario in one build: milliseconds of all steps, of the longest, and the hash. */
function time(program, scenario) {
  const call = program.endsWith('.js') ? ['node', program] : [program];
  const words = [...call.slice(1), options.seconds, options.threads, options.plays, scenario];
  const [, total, worst, hash] = execFileSync(call[0], words, { encoding: 'utf8' }).trim().split(' ');
  return { total: Number(total), worst: Number(worst), hash };
}

const programs = [['native', 'build/release/bench/scenarios/scenario_times'], ...builds];
const logs = builds.map(() => 0);
const worst = builds.map(() => 0);
console.log(`| scenario | native ms | ${builds.map(([name]) => `${name} | ratio`).join(' | ')} |`);
console.log(`| --- | --- | ${builds.map(() => '--- | ---').join(' | ')} |`);
let differ = 0;
for (const scenario of scenarios) {
  const least = programs.map(() => null);
  for (let round = 0; round < Number(options.rounds); round += 1) {
    programs.forEach(([, program], i) => {
      const now = time(program, scenario);
      if (least[i] && least[i].hash !== now.hash) differ += 1;
      if (!least[i] || now.total < least[i].total) least[i] = now;
    });
  }
  const ratios = least.slice(1).map(({ total }) => total / least[0].total);
  ratios.forEach((ratio, i) => {
    logs[i] += Math.log(ratio) / scenarios.length;
    worst[i] = Math.max(worst[i], ratio);
  });
  differ += least.filter(({ hash }) => hash !== least[0].hash).length;
  const cells = ratios.map((ratio, i) => `${least[i + 1].total.toFixed(1)} | ${ratio.toFixed(2)}`);
  console.log(`| ${scenario.replace(/^scenarios.|.json$/g, '')} | ${least[0].total.toFixed(1)} | ${cells.join(' | ')} |`);
}
builds.forEach(([name], i) =>
  console.log(`${name}: geometric mean ${Math.exp(logs[i]).toFixed(3)}, worst ${worst[i].toFixed(2)}`),
);
console.log(differ === 0 ? 'All hashes are equal.' : `${differ} hashes differ.`);
process.exitCode = differ === 0 ? 0 : 1;
