// Names that a source file keeps to itself have to be unique in its module: where code is to be small, a module is compiled as one.
// Usage: private_names.mjs. Prints each name that two files of a module have; exit code 1 where there is one.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const modules = [...readFileSync('CMakeLists.txt', 'utf8').matchAll(/^\s*muster_module\((\S+)/gm)].map(([, path]) => (path.startsWith('bindings') ? path : `src/${path}`));
const files = execFileSync('git', ['ls-files', '-co', '--exclude-standard', 'src/*.cpp', 'bindings/c/*.cpp'], { encoding: 'utf8' }).trim().split('\n');
const moduleOf = (file) => modules.filter((path) => file.startsWith(`${path}/`)).sort((a, b) => b.length - a.length)[0];

/** Constants, types and functions of the unnamed namespaces: what stands at the beginning of a line there. */
function namesIn(text) {
  const names = [];
  for (const [, whole] of text.matchAll(/^namespace \{$([^]*?)^\}  \/\/ namespace$/gm)) {
    const inside = whole.replace(/^namespace (\w+) \{$[^]*?^\}  \/\/ namespace \1$/gm, '');
    for (const [, name] of inside.matchAll(/^(?:inline |static )?constexpr [\w:<>, *&]*?\b(k[A-Z]\w*)\b/gm)) names.push(name);
    for (const [, name] of inside.matchAll(/^(?:struct|class|enum class|enum) (\w+)(?: final)? *[:{]/gm)) names.push(name);
    for (const [, name, parameters] of inside.matchAll(/^[\w:][\w:<>,*& ]* [*&]?(\w+)\(([^)]*)\)(?: noexcept)? \{/gm))
      names.push(`${name}(${parameters.replace(/\b\w+(?=,|$)/g, '').replace(/\s+/g, ' ')})`);
  }
  return names;
}

const owners = new Map();
for (const file of files) {
  const module = moduleOf(file);
  if (module === undefined) continue;
  for (const name of new Set(namesIn(readFileSync(file, 'utf8')))) {
    const key = `${module}: ${name}`;
    owners.set(key, [...(owners.get(key) ?? []), file]);
  }
}
const twice = [...owners].filter(([, found]) => found.length > 1);
for (const [key, found] of twice) console.error(`${key} stands in ${found.join(' and ')}: give one of them a name of its own`);
process.exit(twice.length > 0 ? 1 : 0);
