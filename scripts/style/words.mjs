// Lists words of C++ names and comments that docs/glossary.md replaces by others (words.txt). `--all FOLDER...` lists every
// word of these folders instead, the rarest in the glossary first, for reading through. Exit code 1 where a word is found.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');

/** Phrases that are exempt, also where a comment breaks them over two lines. */
const kExempt = ['lines? ?of ?sight', 'told apart', 'in turn'].map(
  (phrase) => new RegExp(`${phrase.replace(/ (\??)/g, '(?:[ _]|\\s*\\n\\s*//+ )$1')}`, 'gi'),
);

/** The text without exempt phrases and without the strings that a program prints, line by line. Names of test cases stay. */
function linesOf(text) {
  const blank = (phrase) => (phrase.includes('\n') ? '\n' : ' ');
  return kExempt
    .reduce((rest, phrase) => rest.replace(phrase, blank), text)
    .split('\n')
    .map((line) => (/TEST_CASE|\/\//.test(line) ? line : line.replace(/"(?:[^"\\]|\\.)*"/g, '""')));
}

/** All words of a piece of code or prose, in lower case: names are split where a capital or a digit begins. */
function wordsOf(text) {
  return text
    .replace(/([a-z0-9])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .match(/[a-z]+/g) ?? [];
}

const files = execFileSync('git', ['ls-files', '*.h', '*.cpp'], { cwd: root, encoding: 'utf8' }).split('\n').filter(Boolean);

function listAll(folders) {
  const known = new Set(wordsOf(readFileSync(join(root, 'docs/glossary.md'), 'utf8')));
  const count = new Map();
  for (const file of files.filter((name) => folders.some((folder) => name.startsWith(folder))))
    for (const word of wordsOf(readFileSync(join(root, file), 'utf8'))) if (!known.has(word)) count.set(word, (count.get(word) ?? 0) + 1);
  for (const [word, times] of [...count].sort((a, b) => b[1] - a[1])) console.log(`${word} ${times}`);
}

function listReplaced() {
  const rules = readFileSync(join(here, 'words.txt'), 'utf8')
    .split('\n')
    .filter((line) => line && !line.startsWith('#'))
    .map((line) => {
      const [word, folders, ...use] = line.trim().split(/\s+/);
      return { word, folders: folders === '*' ? [''] : folders.split(','), use: use.join(' ') };
    });
  const byWord = new Map(rules.map((rule) => [rule.word, rule]));
  let found = 0;
  for (const file of files) {
    linesOf(readFileSync(join(root, file), 'utf8')).forEach((line, index) => {
      for (const word of new Set(wordsOf(line))) {
        const rule = byWord.get(word);
        if (!rule || !rule.folders.some((folder) => file.startsWith(folder))) continue;
        console.log(`${file}:${index + 1}: "${word}" is replaced by: ${rule.use}`);
        found += 1;
      }
    });
  }
  return found;
}

if (process.argv[2] === '--all') listAll(process.argv.slice(3));
else if (listReplaced() > 0) process.exit(1);
