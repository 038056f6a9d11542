// What a change concerns: parts of ./test and suites of C++ tests, over the graph of targets that CMake writes into the build folder
// (graph.txt). Usage: affected.mjs [--build FOLDER] [--since COMMIT | FILE...]
//
//     --since COMMIT   the files that differ from that commit, with those that are not committed
//
// It prints lines "part NAME" and "cpp/SUITE", or the one line "everything". A file that no rule knows concerns everything.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));

/** The targets that a part runs, by the part. */
const kPartTargets = {
  hashes: ['muster_program'],
  wasm: ['scenario_hashes'],
  javascript: ['muster_c_io', 'muster_program'],
  site: ['muster_page_engine', 'muster_program'],
  python: ['muster_motion', 'muster_export', 'muster_measures', 'muster_program'],
  paper: ['muster_lab'],
  verify: ['muster_lab'],
  export: ['muster_program'],
  player: ['muster_program'],
  server: ['muster_program'],
  browser: ['muster_program'],
};

/** Suites that run programs. */
const kSuitePrograms = { cli: ['muster_program', 'muster_lab'] };

const kPage = ['web', 'site', 'player', 'browser', 'javascript', 'server'];

/** Parts and suites by the beginning of a path, null for everything; what the graph says comes on top. The first rule that fits
 * holds. `headers` stands for the installed headers in the part consumer. */
const kRules = [
  [/^docs\/(python\.md|notebooks\/)/, ['python']],
  [/^docs\/javascript\.md$/, ['javascript']],
  [/^docs\/(api\/|.*(?<!\.md|\.png|\.jpg|\.mp4)$)/, null],
  [/^(docs\/|README\.md$|LICENSE$|\.gitignore$|\.clang-(format|tidy)$|web\/README\.md$|samples\/README\.md$|packaging\/README\.md$)/, []],
  [/^scripts\/(style\.sh|style\/|lonely_headers\.mjs|blender\/)/, []],
  [/^scripts\/wasm(\.sh|\/)/, ['wasm', 'javascript', 'site']],
  [/^web\/src\/protocol\//, [...kPage, 'cpp/session']],
  [/^web\/package/, [...kPage, 'export']],
  [/^web\//, kPage],
  [/^bindings\/python\//, ['python']],
  [/^bindings\/javascript\//, ['javascript']],
  [/^tests\/javascript\//, ['javascript']],
  [/^tests\/python\//, ['python']],
  [/^tests\/(consumer|player|server|site)\//, (path) => [path.split('/')[1]]],
  [/^tests\/hashes\//, ['hashes', 'wasm', 'javascript', 'python', 'site']],
  [/^tests\/lab\/reproduce\/run\.sh$/, ['paper']],
  [/^tests\/lab\/verify\/run\.sh$/, ['verify']],
  [/^tests\/lab\/measures\/reference\.py$/, ['cpp/measures']],
  [/^tests\/files\/export\/[^/]*\.(sh|mjs)$/, ['export']],
  [/^samples\/js_/, ['javascript']],
  [/^samples\/.*\.json$/, null],
  [/^samples\//, ['consumer']],
  [/^packaging\//, ['consumer']],
  [/^bench\//, ['cpp/bench']],
  [/^tests\/[^/]+\.(cpp|h)$/, null],
  [/^include\//, ['consumer', 'headers']],
];

const isSource = (path) => /\.(cpp|h|c|inc|in)$/.test(path) && !/^(web|cmake)\//.test(path);

/** The targets of a build: what each is made of, and who depends on it. */
export class Graph {
  files = new Map(); // Of a file: the targets that it is a part of.
  folders = new Map(); // Of a folder: the targets with a source in it or below.
  users = new Map(); // Of a target: those that link it or wait for it.
  targets = new Set();

  constructor(text) {
    const names = (list) => list.match(/[\w-]+(?:\.[\w-]+)*/g) ?? [];
    for (const line of text.split('\n').filter(Boolean)) {
      const [target, files, used] = line.split('\t');
      this.targets.add(target);
      for (const file of files.split(';').filter(Boolean)) {
        const objects = /^\$<TARGET_OBJECTS:([\w-]+)>$/.exec(file);
        if (objects) {
          this.#add(this.users, objects[1], target);
          continue;
        }
        this.#add(this.files, file, target);
        for (let folder = dirname(file); folder !== '.'; folder = dirname(folder)) this.#add(this.folders, folder, target);
      }
      // Links come as names and inside generator expressions; what only gives headers is a target like any other.
      for (const one of used.split(';')) for (const name of names(one)) this.#add(this.users, name, target);
    }
    // The headers of a module belong to what gives them.
    for (const target of this.targets)
      if (target.endsWith('_inside')) this.#add(this.users, target.replace(/_inside$/, ''), target);
  }

  #add(map, key, value) {
    if (!map.has(key)) map.set(key, new Set());
    map.get(key).add(value);
  }

  /** The targets that a file is a part of: a header is a part of all that have sources in its folder or, where none has, in the
   * nearest folder above. */
  owners(file) {
    if (!isSource(file) || this.files.has(file)) return new Set(this.files.get(file));
    for (let folder = dirname(file); folder !== '.'; folder = dirname(folder))
      if (this.folders.has(folder)) return new Set(this.folders.get(folder));
    return new Set();
  }

  /** The targets named and all that depend on them. */
  dependents(targets) {
    const found = new Set(targets);
    for (const target of found) for (const user of this.users.get(target) ?? []) found.add(user);
    return found;
  }
}

/** Who includes a header of the tests, which all tests may: by its path, the files that name it. */
let testIncludes = null;
function includersOf(header) {
  if (!testIncludes) {
    testIncludes = new Map();
    const files = execFileSync('git', ['ls-files', '-z', '--cached', '--others', '--exclude-standard', 'tests/*.h', 'tests/*.cpp'], { cwd: root, encoding: 'utf8' });
    for (const file of files.split('\0').filter((name) => name && existsSync(join(root, name))))
      for (const [, path] of readFileSync(join(root, file), 'utf8').matchAll(/^#include "([^"]+)"/gm))
        for (const one of [join('tests', path), join(dirname(file), path)]) testIncludes.set(one, [...(testIncludes.get(one) ?? []), file]);
  }
  const found = new Set([header]);
  for (const one of found) for (const includer of testIncludes.get(one) ?? []) found.add(includer);
  return found;
}

/** Parts and suites that a file concerns, and its targets; null where it concerns everything. */
export function affectedBy(graph, file) {
  const rule = kRules.find(([pattern]) => pattern.test(file));
  const owners = graph.owners(file);
  if (/^tests\/.*\.h$/.test(file)) for (const one of includersOf(file)) for (const owner of graph.owners(one)) owners.add(owner);
  if (rule?.[1] === null || (!rule && owners.size === 0)) return null;
  const ruled = typeof rule?.[1] === 'function' ? rule[1](file) : (rule?.[1] ?? []);
  const parts = new Set(['style', ...ruled.filter((name) => !name.startsWith('cpp/'))]);
  const suites = new Set(ruled.filter((name) => name.startsWith('cpp/')).map((name) => name.slice(4)));
  const targets = graph.dependents(owners);
  for (const target of targets) if (target.endsWith('_suite')) suites.add(target.replace(/_suite$/, ''));
  const meets = (names) => names.some((name) => targets.has(name));
  for (const [suite, programs] of Object.entries(kSuitePrograms)) if (meets(programs)) suites.add(suite);
  for (const [part, names] of Object.entries(kPartTargets)) if (meets(names)) parts.add(part);
  return { parts, suites, targets };
}

export const readGraph = (build) => new Graph(readFileSync(join(root, build, 'graph.txt'), 'utf8'));

/** The files that differ from a commit, with those that are not committed. */
function changedSince(commit) {
  const git = (...words) => execFileSync('git', words, { cwd: root, encoding: 'utf8' }).split('\0').filter(Boolean);
  // Both names of what was moved.
  return [
    ...git('diff', '--name-only', '--no-renames', '-z', commit, '--'),
    ...git('ls-files', '--others', '--exclude-standard', '-z'),
  ];
}

function main(words) {
  let build = 'build/release';
  let files = [];
  while (words.length > 0) {
    const word = words.shift();
    if (word === '--build') build = words.shift();
    else if (word === '--since') files = files.concat(changedSince(words.shift()));
    else files.push(word);
  }
  const graph = readGraph(build);
  const lines = new Set();
  for (const file of files) {
    const found = affectedBy(graph, file);
    if (!found) {
      console.log('everything');
      return;
    }
    for (const part of found.parts) lines.add(`part ${part}`);
    for (const suite of found.suites) lines.add(`cpp/${suite}`);
  }
  if (lines.size === 0) lines.add('everything');
  for (const line of [...lines].sort()) console.log(line);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) main(process.argv.slice(2));
