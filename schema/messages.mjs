// Reads messages.txt: the version, enumerations and parts of messages, and the messages of both sides.
import { definitions, enumerations, fail, readField, readFile, word } from './read.mjs';

/** Numbers of messages. Lists of them are arrays of numbers in TypeScript too. */
export const kNumbers = ['u8', 'i8', 'u16', 'i16', 'u32', 'f32', 'f64'];

/** A list of it is the bytes of commands, one after the other; their length comes before them. */
export const kCommand = 'Command';

/** Names that fields may have as their types; parts and enumerations are known once they have been declared. */
const types = new Set([...kNumbers, 'bool', 'text', 'Vec2', kCommand, ...[...enumerations, ...definitions].map(({ name }) => name)]);

/** "values TouchPhase Down Move Up Cancel "What a finger does."". */
function readValues(tokens, line) {
  const found = { name: word(tokens, line, 'a name'), values: [], sentence: '' };
  while (tokens[0]?.word !== undefined) found.values.push(tokens.shift().word);
  found.sentence = tokens.shift()?.text ?? fail(line, `found no sentence for ${found.name}`);
  return found;
}

/** "page Hello 0": the number of a message is its first byte. A part has none. */
function readEntry(keyword, tokens, line) {
  const found = { name: word(tokens, line, 'a name'), number: null, flags: new Set(), sentence: '', fields: [] };
  if (keyword === 'part') return found;
  found.number = Number(word(tokens, line, 'a number'));
  const expected = declared.filter((other) => other.keyword === keyword).length;
  if (found.number !== expected) fail(line, `found number ${found.number} for ${found.name}, expected ${expected}`);
  return found;
}

const declared = [];

readFile(
  'messages.txt',
  ['version', 'values', 'part', 'page', 'server'],
  declared,
  (tokens, line, _, keyword) => {
    const found =
      keyword === 'version' ? { number: Number(word(tokens, line, 'a number')) }
      : keyword === 'values' ? readValues(tokens, line)
      : readEntry(keyword, tokens, line);
    if (keyword === 'values' || keyword === 'part') types.add(found.name);
    return { ...found, keyword };
  },
  (owner, tokens, line) => {
    if (tokens[0].text !== undefined) owner.sentence = tokens[0].text;
    else owner.fields.push(readField(tokens, line, (type) => types.has(type)));
  },
);

const of = (keyword) => declared.filter((entry) => entry.keyword === keyword);

export const version = of('version')[0].number;
export const values = of('values');
export const parts = of('part');
export const page = of('page');
export const server = of('server');
/** Definitions that fields of messages have. */
export const messageDefinitions = [
  ...new Set([...parts, ...page, ...server].flatMap(({ fields }) => fields.map(({ type }) => type))),
].filter((type) => definitions.some(({ name }) => name === type));
/** Enumerations of enumerations.txt that fields of messages have. */
export const shared = enumerations.filter(({ name }) =>
  [...parts, ...page, ...server].some(({ fields }) => fields.some(({ type }) => type === name)),
);

for (const { name, sentence } of [...parts, ...page, ...server])
  if (sentence === '') throw new Error(`schema/messages.txt: ${name} needs a sentence`);
