// The work of compiling, in a measure that does not depend on the machine: preprocessed lines over all objects, by target.
//
//   node scripts/build_work.mjs BUILD            compares with scripts/build_work.txt; fails where a sum has grown by a tenth
//   node scripts/build_work.mjs BUILD --rewrite  writes that file anew
//
// BUILD is a configured build with a file compile_commands.json; sources that are compiled together must be there, which cmake
// writes when it configures. Lines of a precompiled header do not count, as nothing reads them again.
import { spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const kMost = 1.1;
const kFile = join(dirname(fileURLToPath(import.meta.url)), 'build_work.txt');
// What a user builds: the modules and both programs. Tests, benchmarks and the Python module do not count.
const kGroups = [
  ['program', /(^|\/)muster_(program|lab)\.dir\//],
  ['library', /(^|\/)muster_\w+\.dir\//],
];

const [build, option] = process.argv.slice(2);
if (!build || (option && option !== '--rewrite')) {
  console.error('Usage: node scripts/build_work.mjs BUILD [--rewrite]');
  process.exit(2);
}

function groupOf(object) {
  if (/(^|\/)(tests|bench|samples|bindings\/python)\//.test(object)) return undefined;
  return kGroups.find(([, pattern]) => pattern.test(object))?.[0];
}

/** Counts the lines that come out of a preprocessor. */
function linesOf(command, directory) {
  return new Promise((resolve, reject) => {
    const shell = spawn('sh', ['-c', `${command} | wc -l`], { cwd: directory });
    let text = '';
    let errors = '';
    shell.stdout.on('data', (data) => (text += data));
    shell.stderr.on('data', (data) => (errors += data));
    shell.on('close', () => (errors === '' ? resolve(Number(text)) : reject(new Error(errors.slice(0, 2000)))));
  });
}

const precompiled = new Map();

/** Counts the lines that the compiler reads for an object, but for those of a precompiled header. */
async function workOf({ command, directory }) {
  const preprocess = `${command.replace(/ -o \S+/, '').replace(/ -c /, ' ')} -E -P`;
  const all = await linesOf(preprocess, directory);
  const header = / -include (\S*cmake_pch\.hxx)/.exec(command)?.[1];
  if (header === undefined) return all;
  if (!precompiled.has(header)) precompiled.set(header, linesOf(preprocess.replace(/ \S+ -E -P$/, ' -E -P -x c++ /dev/null'), directory));
  return all - (await precompiled.get(header));
}

const commands = JSON.parse(readFileSync(join(build, 'compile_commands.json'), 'utf8'));
const counted = commands
  .map((entry) => ({ ...entry, group: groupOf(/ -o (\S+)/.exec(entry.command)?.[1] ?? '') }))
  .filter(({ group }) => group !== undefined);
const sums = new Map();
let next = 0;
async function work() {
  while (next < counted.length) {
    const entry = counted[next++];
    const lines = await workOf(entry);
    const sum = sums.get(entry.group) ?? { objects: 0, lines: 0 };
    sums.set(entry.group, { objects: sum.objects + 1, lines: sum.lines + lines });
  }
}
await Promise.all(Array.from({ length: availableParallelism() }, work));

const table = kGroups
  .map(([group]) => group)
  .sort()
  .map((group) => `${group} ${sums.get(group).objects} objects ${sums.get(group).lines} lines`);
if (option === '--rewrite') {
  writeFileSync(kFile, `${table.join('\n')}\n`);
} else {
  let failed = 0;
  const before = new Map(
    readFileSync(kFile, 'utf8').trim().split('\n').map((line) => [line.split(' ')[0], Number(line.split(' ')[3])]),
  );
  for (const [group, { lines }] of [...sums].sort()) {
    const was = before.get(group);
    const ok = was !== undefined && lines <= kMost * was;
    if (!ok) failed += 1;
    console.log(`measured: ${group}: ${lines} preprocessed lines, ${(lines / was).toFixed(3)} of those in scripts/build_work.txt`);
    if (!ok) console.log(`failed: compiling ${group} has become more work by over a tenth; where that is meant, write the file anew (--rewrite)`);
  }
  console.log(`${sums.size - failed} passed, ${failed} failed`);
  process.exit(failed === 0 ? 0 : 1);
}
