// Reads the declarations in enumerations.txt and commands.txt (README.md tells their form).
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { isType } from './types.mjs';

let file = '';  // That is read now.

export const folder = dirname(fileURLToPath(import.meta.url));
export const root = join(folder, '..');

const kCommandFlags = ['relations', 'by-hand', 'undoable', 'directs', 'edits', 'slides', 'queues'];
const kFieldFlags = ['required', 'omit', 'unchecked', 'internal'];

/** Words, quoted texts without their quotes, and bracketed units of a line. */
function tokensOf(line) {
  const tokens = [];
  for (const [, quoted, unit, word] of line.matchAll(/"((?:[^"\\]|\\.)*)"|(?<=\s)\[([^\]]+)\]|(\S+)/g)) {
    if (quoted !== undefined) tokens.push({ text: quoted.replace(/\\"/g, '"') });
    else if (unit !== undefined) tokens.push({ unit });
    else tokens.push({ word });
  }
  return tokens;
}

export function fail(line, sentence) {
  throw new Error(`schema/${file}:${line}: ${sentence}`);
}

/** The value of a word that must be there. */
export function word(tokens, line, what) {
  const token = tokens.shift();
  return token?.word ?? fail(line, `found ${token ? 'a text' : 'nothing'}, expected ${what}`);
}

export function readRange(text) {
  const [, low, high] = text.match(/^(-?[\d.e/-]+?)\.\.(-?[\d.e/-]+)$/) ?? [];
  return low === undefined ? null : { low, high };
}

/** "command TouchDown 0 file down label "..." flags". */
function readCommand(tokens, line, number) {
  const command = { name: word(tokens, line, 'a name'), number, fields: [], sentence: '', file: '', label: '', flags: new Set() };
  const found = word(tokens, line, 'a number');
  if (found !== String(number)) fail(line, `found number ${found} for ${command.name}, expected ${number}`);
  while (tokens.length > 0) {
    const next = word(tokens, line, 'a property');
    if (next === 'file') command.file = word(tokens, line, 'its word in files');
    else if (next === 'label') command.label = tokens.shift()?.text ?? fail(line, 'found no text for the label');
    else if (kCommandFlags.includes(next)) command.flags.add(next);
    else fail(line, `found ${next}, expected file, label or one of ${kCommandFlags.join(', ')}`);
  }
  if (command.file === '') fail(line, `${command.name} has no word for files, expected "file WORD"`);
  return command;
}

/** "points Vec2[0..10000] [m] "For Line: ..."". */
function readField(tokens, line) {
  const name = word(tokens, line, 'the name of a field');
  const spelled = word(tokens, line, 'a type');
  const [, base, list, optional] = spelled.match(/^(\w+)(\[(?:[^\]]*)\])?(\?)?$/) ?? fail(line, `found type ${spelled}`);
  if (!isType(base)) fail(line, `the type ${base} of ${name} is not known, expected one of schema/types.mjs`);
  const field = {
    name, type: base, isList: list !== undefined, isOptional: optional !== undefined,
    count: list === undefined ? null : readRange(list.slice(1, -1)),
    unit: '', range: null, initial: '', sentence: '', flags: new Set(),
  };
  while (tokens.length > 0) {
    const { word: next, unit, text } = tokens.shift();
    if (text !== undefined) field.sentence = text;
    else if (unit !== undefined) field.unit = unit;
    else if (next === '=') field.initial = word(tokens, line, 'a default');
    else if (kFieldFlags.includes(next)) field.flags.add(next);
    else field.range = readRange(next) ?? fail(line, `found ${next}, expected a range, a default or one of ${kFieldFlags.join(', ')}`);
  }
  if (!field.sentence.endsWith('.')) fail(line, `${name} needs a sentence that ends with a full stop`);
  return field;
}

/** "enum SplitBy c SPLIT_BY "How..."": a value stands on each line below. */
function readEnumeration(tokens, line) {
  const found = { name: word(tokens, line, 'a name'), prefix: '', isCounted: false, sentence: '', values: [] };
  while (tokens.length > 0) {
    const { word: next, text } = tokens.shift();
    if (text !== undefined) found.sentence = text;
    else if (next === 'c') found.prefix = word(tokens, line, 'the beginning of its names in C');
    else if (next === 'counted') found.isCounted = true;
    else fail(line, `found ${next}, expected c, counted or a sentence`);
  }
  if (found.prefix === '' || found.sentence === '') fail(line, `${found.name} needs a name in C and a sentence`);
  return found;
}

/**
 * Reads a file of declarations of several kinds. `kinds` has, by the keyword of each, `open`, which gives what its lines are added
 * to, and `add` for these.
 */
export function readKinds(name, kinds) {
  const found = [];
  file = name;
  readFileSync(join(folder, name), 'utf8').split('\n').forEach((raw, at) => {
    const line = at + 1;
    if (raw.trim() === '' || raw.startsWith('#')) return;
    const tokens = tokensOf(raw);
    if (!raw.startsWith(' ')) {
      const keyword = tokens.shift().word;
      if (!(keyword in kinds)) fail(line, `found ${keyword}, expected ${Object.keys(kinds).join(' or ')}`);
      found.push({ keyword, line, owner: kinds[keyword].open(tokens, line, found.length) });
    } else if (found.length === 0) {
      fail(line, `found a line before any ${Object.keys(kinds).join(' or ')}`);
    } else {
      const { keyword, owner } = found[found.length - 1];
      kinds[keyword].add(owner, tokens, line);
    }
  });
  return found;
}

/** The same for a file of one kind. */
function readFile(name, keyword, open, add) {
  return readKinds(name, { [keyword]: { open, add } }).map(({ owner }) => owner);
}

/** "Ids "Those with the given ids leave."". */
export function addValue(owner, tokens, line) {
  const name = word(tokens, line, 'a value');
  owner.values.push({ name, sentence: tokens.shift()?.text ?? fail(line, `found no sentence for ${name}`) });
}

export const enumerations = readFile('enumerations.txt', 'enum', readEnumeration, addValue);

export const commands = readFile('commands.txt', 'command', readCommand, (owner, tokens, line) => {
  if (tokens[0].text !== undefined) owner.sentence = tokens[0].text;
  else owner.fields.push(readField(tokens, line));
});
for (const { name, sentence, fields } of commands)
  if (sentence === '' || fields.length === 0) throw new Error(`schema/commands.txt: ${name} needs a sentence and a field`);
