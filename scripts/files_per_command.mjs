// Counts in how many files each command is named that people write by hand: what adding one costs.
// Usage: files_per_command.mjs [FOLDER] [--each]. FOLDER is a checkout, this one if left out. Tests, samples, benches and documents do
// not count, nor do files that a generator has made.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const words = process.argv.slice(2).filter((word) => word !== '--each');
const folder = words[0] ?? '.';
const kCounted = /^(src|include|bindings|apps|web\/src|protocol|schema|scripts\/capi)\/.*\.(h|cpp|c|ts|mjs|py|pyi|txt|json)$/;
const kMade = /^(\/\/|\/\*|#|""") ?(Made|Generated|Written) by/;

const names = (() => {
  const header = ['include/muster/generated/command_kinds.h', 'include/muster/command.h'].map((path) => join(folder, path)).find(existsSync);
  const [, list] = readFileSync(header, 'utf8').match(/using CommandKinds = std::variant<([^>]+)>/);
  return list.split(',').map((name) => name.trim());
})();

/** "SplitGroup" as C++, C, Python and files of functions spell it; "Touch", a word of its own, only as a type or a declaration. */
function spellings(name) {
  if (!/[a-z][A-Z]/.test(name)) return new RegExp(`(?<![\\w:."])(Muster)?${name}(?=[{&*>])|MUSTER_COMMAND_${name.toUpperCase()}\\b|^command ${name} `, 'm');
  const snake = name.replace(/(?<!^)([A-Z])/g, '_$1').toLowerCase();
  return new RegExp(`(?<![A-Za-z])(Muster)?(${name}|${name[0].toLowerCase()}${name.slice(1)}(Event)?|${snake}|MUSTER_COMMAND_${snake.toUpperCase()})(?![A-Za-z])`);
}

const files = execFileSync('git', ['-C', folder, 'ls-files', '-co', '--exclude-standard'], { encoding: 'utf8', maxBuffer: 1 << 26 })
  .split('\n')
  .filter((path) => kCounted.test(path) && !/(^|\/)(tests?|generated)\/|\.test\.ts$/.test(path) && existsSync(join(folder, path)))
  .map((path) => ({ path, text: readFileSync(join(folder, path), 'utf8') }))
  .filter(({ text }) => !kMade.test(text.slice(0, 400)));

const counts = names.map((name) => {
  const pattern = spellings(name);
  const naming = files.filter(({ path, text }) => pattern.test(text) || pattern.test(path));
  return { name, paths: naming.map(({ path }) => path) };
});
if (process.argv.includes('--each'))
  for (const { name, paths } of counts) console.log(`${String(paths.length).padStart(3)} ${name}: ${paths.join(' ')}`);
const sizes = counts.map(({ paths }) => paths.length).sort((a, b) => a - b);
const mean = sizes.reduce((sum, size) => sum + size, 0) / sizes.length;
console.log(`${names.length} commands, named in ${mean.toFixed(1)} hand-written files on average (${sizes[0]} to ${sizes[sizes.length - 1]})`);
