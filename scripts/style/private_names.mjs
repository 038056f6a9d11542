// Names that a source file keeps to itself have to be unique in its module, and constants have to differ from those of headers:
// where code is to be small, a module is compiled as one.
// Usage: private_names.mjs. Prints each name that stands twice; exit code 1 where there is one.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const declared = [...readFileSync('CMakeLists.txt', 'utf8').matchAll(/^\s*muster_module\(([^)]*)\)/gm)].map(([, text]) => text.split(/\s+/));
const folderOf = (path) => (path.startsWith('bindings') ? path : `src/${path}`);
const modules = declared.map(([path]) => folderOf(path));
/** The modules that a module uses, by folder. */
const uses = new Map(declared.map((words) => [folderOf(words[0]), words.includes('USES') ? words.slice(words.indexOf('USES') + 1) : []]));
const folderNamed = (name) => modules.find((path) => path.endsWith(`/${name}`) || path === name);

/** True where the module sees the headers of the other one. */
function sees(module, other, seen = new Set()) {
  if (module === other) return true;
  if (module === undefined || seen.has(module)) return false;
  seen.add(module);
  return (uses.get(module) ?? []).some((name) => sees(folderNamed(name), other, seen));
}

const files = execFileSync('git', ['ls-files', '-co', '--exclude-standard', 'src/*.cpp', 'bindings/c/*.cpp'], { encoding: 'utf8' }).trim().split('\n');
const moduleOf = (file) => modules.filter((path) => file.startsWith(`${path}/`)).sort((a, b) => b.length - a.length)[0];

const namespaceOf = (file) => readFileSync(file, 'utf8').match(/^namespace ([\w:]+) \{$/m)?.[1] ?? '';

/** Constants, types and functions of the unnamed namespaces: what stands at the beginning of a line there. */
function namesIn(text) {
  const names = [];
  for (const [, whole] of text.matchAll(/^namespace \{$([^]*?)^\}  \/\/ namespace$/gm)) {
    const inside = whole.replace(/^namespace (\w+) \{$[^]*?^\}  \/\/ namespace \1$/gm, '');
    for (const [, name] of inside.matchAll(/^(?:inline |static )?constexpr [\w:<>, *&]*?\b(k[A-Z]\w*)(?=[ {[]*[={[])/gm)) names.push(name);
    for (const [, name] of inside.matchAll(/^(?:struct|class|enum class|enum) (\w+)(?: final)? *[:{]/gm)) names.push(name);
    for (const [, name, parameters] of inside.matchAll(/^[\w:][\w:<>,*& ]* [*&]?(\w+)\(([^)]*)\)(?: noexcept)? \{/gm))
      names.push(`${name}(${parameters.replace(/\b\w+(?=,|$)/g, '').replace(/\s+/g, ' ')})`);
  }
  return names;
}

const owners = new Map();
const headers = execFileSync('git', ['ls-files', '-co', '--exclude-standard', 'src/*.h', 'include/*.h'], { encoding: 'utf8' }).trim().split('\n');
const shared = new Map();
for (const header of headers)
  for (const [, name] of readFileSync(header, 'utf8').matchAll(/^inline constexpr [\w:<>, *&]*?\b(k[A-Z]\w*)(?=[ {[]*[={[])/gm)) shared.set(name, header);
for (const file of files) {
  const module = moduleOf(file);
  if (module === undefined) continue;
  for (const name of new Set(namesIn(readFileSync(file, 'utf8')))) {
    const key = `${module}: ${name}`;
    const found = shared.get(name);
    const isOwn = found !== undefined && found.replace(/\.h$/, '') === file.replace(/\.cpp$/, '');
    const header = found !== undefined && !isOwn && namespaceOf(file).startsWith(namespaceOf(found)) && (found.startsWith('include/') || sees(module, moduleOf(found))) ? [found] : [];
    owners.set(key, [...(owners.get(key) ?? header), file]);
  }
}
const twice = [...owners].filter(([, found]) => found.length > 1);
for (const [key, found] of twice) console.error(`${key} stands in ${found.join(' and ')}: give one of them a name of its own`);
process.exit(twice.length > 0 ? 1 : 0);
