// Reads the declarations in enumerations.txt, definitions.txt, commands.txt and former.txt (README.md tells their form).
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { isType } from './types.mjs';

let file = '';  // That is read now.

export const folder = dirname(fileURLToPath(import.meta.url));
export const root = join(folder, '..');

const kCommandFlags = ['relations', 'by-hand', 'undoable', 'directs', 'edits', 'slides', 'queues'];
const kDefinitionFlags = ['equal', 'flat', 'relations', 'no-c', 'no-files', 'unsaved'];
/** What may be true of single fields of a command, and only where they are given. */
export const kGivenFlags = ['directs', 'edits', 'slides'];
const kFieldFlags = ['required', 'omit', 'unchecked', 'internal', 'xy', 'within', 'unhashed', 'inline', 'c-only', 'cpp-only', ...kGivenFlags];
/** What a field may say with a word or a text behind it, and what it is called in the field that was read. */
const kFieldWords = { key: 'key', since: 'since', 'files-after': 'filesAfter', 'c-after': 'cAfter', count: 'countName', as: 'as' };
const kFieldTexts = { files: 'inFiles', unless: 'unless', needed: 'needed', called: 'called', apart: 'apart', label: 'label' };
/** The parts into which definitions are divided, each a header. */
export const kSubjects = ['ground', 'people', 'orders', 'world'];

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

/** "0.05..1.5"; "0|0.05..1.5" also takes 0, "-|0..1e4" all that is negative. */
export function readRange(text) {
  const [, other, low, high] = text.match(/^(?:([0-])\|)?(-?[\d.e/-]+?)\.\.(-?[\d.e/-]+)$/) ?? [];
  return low === undefined ? null : { low, high, orZero: other === '0', orNegative: other === '-' };
}

/** A struct of which only the name is known. `isGiven`: callers make it, so that texts and ids of it may be none. */
const newStruct = (name) => ({
  name, header: '', cpp: '', version: null, flags: new Set(), isGiven: false,
  sentences: [], made: '', context: [], fields: [], functions: [],
});

/** "command TouchDown 0 file down label "..." flags". */
function readCommand(tokens, line, index) {
  const command = { ...newStruct(word(tokens, line, 'a name')), isGiven: true, index, number: 0, file: '', label: '' };
  command.cpp = command.name;
  command.number = Number(word(tokens, line, 'a number'));
  if (!(command.number >= 0 && command.number < 256)) fail(line, `found no number for ${command.name}, expected 0 to 255`);
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

/** "(context address, size size) address": a pointer to a function. */
function readFunctionType(spelled, tokens, line) {
  while (!spelled.endsWith(')')) spelled += ` ${word(tokens, line, 'a parameter')}`;
  const parameters = spelled.slice(1, -1).split(', ').map((text) => text.split(' ')).map(([name, type]) => ({ name, type }));
  return { type: 'function', parameters, returns: tokens[0]?.word === undefined ? 'void' : word(tokens, line, 'what it returns') };
}

/** "Vec2[0..10000]", "f64[3]", "GroupId?"; "Order&" is a pointer to one that is read, "Buffer*" to one that is changed. */
export function readType(tokens, line, name) {
  const spelled = word(tokens, line, `the type of ${name}`);
  if (spelled.startsWith('(')) return readFunctionType(spelled, tokens, line);
  const [, type, brackets, ending] = spelled.match(/^(\w+)(\[[^\]]*\])?([?&*])?$/) ?? fail(line, `found type ${spelled}`);
  const within = brackets?.slice(1, -1);
  const length = /^\d+$/.test(within ?? '') ? Number(within) : undefined;
  return {
    type, length, isList: brackets !== undefined && length === undefined, count: brackets === undefined ? null : readRange(within),
    isOptional: ending === '?', isPointer: ending === '&', isChanged: ending === '*',
  };
}

/** "points Vec2[0..10000] [m] "For Line: ..."". */
export function readField(tokens, line, isKnown = isDeclared) {
  const name = word(tokens, line, 'the name of a field');
  const type = readType(tokens, line, name);
  if (!isKnown(type.type))
    fail(line, `the type ${type.type} of ${name} is not known, expected one of schema/types.mjs, an enumeration or a definition above`);
  const field = {
    name, ...type, unit: '', range: null, initial: '', sentence: '', flags: new Set(), key: '', since: '', filesAfter: '', cAfter: '',
    inFiles: '', unless: '', needed: '', called: '', apart: null, label: '', countName: '', as: '',
  };
  while (tokens.length > 0) {
    const { word: next, unit, text } = tokens.shift();
    if (text !== undefined) field.sentence = text;
    else if (unit !== undefined) field.unit = unit;
    else if (next === '=') field.initial = tokens[0]?.text !== undefined ? `"${tokens.shift().text}"` : word(tokens, line, 'a default');
    else if (next in kFieldWords) field[kFieldWords[next]] = word(tokens, line, `a word behind ${next}`);
    else if (next in kFieldTexts) field[kFieldTexts[next]] = tokens.shift()?.text ?? fail(line, `found no text behind ${next}`);
    else if (kFieldFlags.includes(next)) field.flags.add(next);
    else field.range = readRange(next) ?? fail(line, `found ${next}, expected a range, a default or one of ${kFieldFlags.join(', ')}`);
  }
  return field;
}

/** Fails unless the field is described. */
export function described(field, line) {
  if (!field.sentence.endsWith('.')) fail(line, `${field.name} needs a sentence that ends with a full stop`);
  return field;
}

/** "ObstacleDef in ground version 3.1 equal relations", with a sentence or without. */
export function readStruct(tokens, line, flags) {
  const struct = newStruct(word(tokens, line, 'a name'));
  while (tokens.length > 0) {
    const { word: next, text } = tokens.shift();
    if (text !== undefined) struct.sentences.push(text);
    else if (next === 'in') struct.header = word(tokens, line, 'a header');
    else if (next === 'cpp') struct.cpp = word(tokens, line, 'its name in C++');
    else if (next === 'version') struct.version = readVersion(word(tokens, line, 'the version of its struct in C'), line);
    else if (flags.includes(next)) struct.flags.add(next);
    else fail(line, `found ${next}, expected in, cpp, version or one of ${flags.join(', ')}`);
  }
  return struct;
}

function readDefinition(tokens, line) {
  const definition = readStruct(tokens, line, kDefinitionFlags);
  if (!kSubjects.includes(definition.header)) fail(line, `${definition.name} is in no header, expected one of ${kSubjects.join(', ')}`);
  const inCommands = { check: 'validate(#)', describe: 'describe(inner, #)', key: 'definition', visit: 'object' };
  return { ...definition, isGiven: true, cpp: definition.cpp || definition.name, inCommands };
}

function readVersion(text, line) {
  const [, kind, version] = text.match(/^(\d+)\.(\d+)$/) ?? fail(line, `found version ${text}, expected KIND.VERSION`);
  return { kind, version };
}

/** What definitions are in commands: how one, or a list, is checked, and how files have them. */
const kInCommandsWords = ['key', 'visit'];
const kInCommandsTexts = ['check', 'check-list', 'describe', 'among'];

function readInCommands(definition, tokens, line) {
  while (tokens.length > 0) {
    const next = word(tokens, line, 'a property');
    if (kInCommandsWords.includes(next)) definition.inCommands[next] = word(tokens, line, `a word behind ${next}`);
    else if (kInCommandsTexts.includes(next)) definition.inCommands[next] = tokens.shift()?.text ?? fail(line, `found no text behind ${next}`);
    else fail(line, `found ${next}, expected one of ${[...kInCommandsWords, ...kInCommandsTexts].join(', ')}`);
  }
}

/** A line below a struct: a sentence, how C makes one, what describing it needs, a function, or a field. */
export function addToStruct(owner, tokens, line, read = readField) {
  const text = (what) => tokens.shift()?.text ?? fail(line, `found no text, expected ${what}`);
  if (tokens[0].text !== undefined) return owner.sentences.push(tokens[0].text);
  if (tokens[0].word === 'default') {
    tokens.shift();
    owner.made = text('what the default is');
  } else if (tokens[0].word === 'with') {
    tokens.shift();
    owner.context.push({ name: word(tokens, line, 'a name'), type: text('its type in C++') });
  } else if (tokens[0].word === 'in-commands' && owner.inCommands) {
    tokens.shift();
    readInCommands(owner, tokens, line);
  } else if (tokens[0].word === 'function') {
    tokens.shift();
    owner.functions.push({ sentence: text('a sentence'), code: text('its declaration in C++') });
  } else {
    owner.fields.push(read(tokens, line));
  }
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

/** The same for a file whose declarations begin with the keyword, or one of several: fills a list that is there already. */
export function readFile(name, keyword, found, open, add) {
  const keep = (owner) => found[found.push(owner) - 1];
  const kinds = [keyword].flat().map((one) => [one, { open: (tokens, line) => keep(open(tokens, line, found.length, one)), add }]);
  readKinds(name, Object.fromEntries(kinds));
  return found;
}

export const enumerations = [];
export const definitions = [];
export const isEnumeration = (type) => enumerations.some(({ name }) => name === type);
export const definitionOf = (type) => definitions.find(({ name }) => name === type);
export const isDefinition = (type) => definitionOf(type) !== undefined;
const isDeclared = (type) => isType(type) || isEnumeration(type) || isDefinition(type);

/** "Ids "Those with the given ids leave."". */
export function addValue(owner, tokens, line) {
  const name = word(tokens, line, 'a value');
  const sentence = tokens.shift()?.text ?? fail(line, `found no sentence for ${name}`);
  const label = tokens.shift()?.word === 'label' ? (tokens.shift()?.text ?? fail(line, `found no text for the label of ${name}`)) : '';
  owner.values.push({ name, sentence, label });
}

readFile('enumerations.txt', 'enum', enumerations, readEnumeration, addValue);

readFile('definitions.txt', 'definition', definitions, readDefinition, (owner, tokens, line) => addToStruct(owner, tokens, line));
for (const { name, sentences, fields, flags, made, version } of definitions) {
  if (sentences.length === 0 || fields.length === 0) throw new Error(`schema/definitions.txt: ${name} needs a sentence and a field`);
  if (version !== null && made === '') throw new Error(`schema/definitions.txt: ${name} needs a sentence for its default in C`);
  if (flags.has('flat') && version !== null) throw new Error(`schema/definitions.txt: ${name} has a version in C, so it is not flat`);
}

const readCommands = (name) =>
  readFile(name, 'command', [], readCommand, (owner, tokens, line) => {
    addToStruct(owner, tokens, line, (...field) => described(readField(...field), line));
  });

export const commands = readCommands('commands.txt');
export const formerCommands = readCommands('former.txt');

const numbered = new Map();
for (const { name, number, sentences, fields } of [...commands, ...formerCommands]) {
  if (sentences.length !== 1 || fields.length === 0) throw new Error(`schema: ${name} needs a sentence and a field`);
  if (numbered.has(number)) throw new Error(`schema: ${name} has the number ${number} of ${numbered.get(number)}, expected one of its own`);
  numbered.set(number, name);
}
