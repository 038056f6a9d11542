// scripts/affected.mjs errs on the safe side: its answers against all tracked files, and against what the compiler and the linker of a
// build say. Usage: check.mjs BUILD
import { execFileSync } from 'node:child_process';
import { existsSync, realpathSync } from 'node:fs';
import { isAbsolute, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { affectedBy, readGraph } from '../../scripts/affected.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const build = process.argv[2] ?? 'build/release';
const graph = readGraph(build);
let passed = 0;
let failed = 0;

function test(name, faults) {
  if (faults.length === 0) passed += 1;
  else failed += 1;
  for (const fault of faults.slice(0, 10)) console.log(`${name}: ${fault}`);
}

const run = (program, ...words) => execFileSync(program, words, { cwd: root, encoding: 'utf8', maxBuffer: 1 << 29 });
const tracked = run('git', 'ls-files', '-z').split('\0').filter(Boolean);
const isProse = (file) => /^(docs|packaging|web|samples)\/.*\.(md|png|jpg|mp4)$|^(README\.md|LICENSE|\.gitignore|\.clang-\w+)$/.test(file);
const isCheckOfStyle = (file) => /^scripts\/(style|blender|lonely_headers)/.test(file);

test(
  'a file concerns more than style, unless it is prose',
  tracked.filter((file) => {
    const found = affectedBy(graph, file);
    return found && found.parts.size + found.suites.size < 2 && !isProse(file) && !isCheckOfStyle(file);
  }),
);
test(
  'what no rule knows concerns everything',
  ['CMakeLists.txt', 'cmake/MusterTargets.cmake', 'test', 'scripts/common.sh', 'schema/messages.txt', 'new/thing.xyz', 'scenarios/open.json'].filter(
    (file) => affectedBy(graph, file) !== null,
  ),
);

/** The target that makes a file of the build; null for what CMake makes by itself. */
const targetOf = (output) => /(?:^|\/)CMakeFiles\/([\w-]+)\.dir\//.exec(output)?.[1] ?? null;

// Ninja has noted, of each object, the files that the compiler opened. Symbolic links into the sources are followed.
const seen = new Map();
const real = new Map();
let object = '';
function fileOf(path) {
  if (!real.has(path)) {
    const whole = isAbsolute(path) ? path : join(root, build, path);
    real.set(path, existsSync(whole) ? relative(root, realpathSync(whole)) : '');
  }
  return real.get(path);
}
for (const line of run('ninja', '-C', build, '-t', 'deps').split('\n')) {
  if (/^\S/.test(line)) object = targetOf(line.split(':')[0]);
  else if (object && line.trim() && !line.trim().startsWith('/usr/')) {
    const key = `${object}\t${line.trim()}`;
    if (!seen.has(key)) seen.set(key, [object, line.trim()]);
  }
}
const isTracked = new Set(tracked);
const answers = new Map();
const answerTo = (file) => {
  if (!answers.has(file)) answers.set(file, affectedBy(graph, file));
  return answers.get(file);
};
const forgotten = [];
let pairs = 0;
for (const [target, path] of seen.values()) {
  const file = fileOf(path);
  if (!isTracked.has(file)) continue;
  pairs += 1;
  const found = answerTo(file);
  const suite = /^(.*)_suite$/.exec(target)?.[1];
  if (found && (suite ? !found.suites.has(suite) : !found.targets.has(target) && target !== 'test_main'))
    forgotten.push(`${file} is compiled into ${target}`);
}
test('whoever includes a file is concerned', forgotten);
test('the compiler has told of files', pairs > 100 ? [] : [`${pairs} of them`]);

// What is linked into a program concerns it.
const programs = run('ninja', '-C', build, '-t', 'targets', 'all').split('\n').filter((line) => /CXX_EXECUTABLE_LINKER/.test(line));
const notLinked = [];
for (const line of programs) {
  const output = line.split(':')[0];
  const program = [...graph.targets].find((target) => /LINKER__(.*)_(Release|RelWithDebInfo|Debug)/.exec(line)?.[1] === target);
  if (!program) continue;
  for (const [, library] of run('ninja', '-C', build, '-t', 'query', output).matchAll(/^ {4}\|? ?lib(muster_\w+)\.a$/gm))
    if (!graph.dependents([library]).has(program)) notLinked.push(`${library} is linked into ${program}`);
}
test('whoever links a library is concerned', notLinked);
test('programs were found', programs.length > 5 ? [] : [`${programs.length} of them`]);

console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
