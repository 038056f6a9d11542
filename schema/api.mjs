// Reads the declarations of the C API in api/*.txt (README.md tells their form), and says which members of C stand for a field.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { membersOf } from './c.mjs';
import { addValue, enumerations, fail, folder, readKinds, word } from './read.mjs';
import { isId, plain } from './types.mjs';
import { singular, withUnit } from './text.mjs';

/** The sections of the header of C, each after those that it uses. */
const kFiles = ['base', 'values', 'definitions', 'commands', 'views', 'world', 'scenario', 'clips', 'motion', 'bvh', 'take', 'figures'];

/** Types of C that are not named after Muster. */
const kC = {
  ...{ u8: 'uint8_t', u16: 'uint16_t', u32: 'uint32_t', u64: 'uint64_t', i32: 'int32_t', size: 'size_t' },
  ...{ f32: 'float', f64: 'double', bool: 'bool', text: 'const char*', address: 'void*', void: 'void', Colour: 'uint32_t' },
};
export const cType = (type) => kC[type] ?? `Muster${type}`;

const textOf = (tokens, line, what) => tokens.shift()?.text ?? fail(line, `found no sentence for ${what}`);

/** Words up to the sentence: `known` says how many words follow each property. */
function properties(tokens, line, known) {
  const found = {};
  while (tokens.length > 0 && tokens[0].text === undefined) {
    const name = word(tokens, line, 'a property');
    if (!(name in known)) fail(line, `found ${name}, expected one of ${Object.keys(known).join(', ')}`);
    found[name] = known[name] === 0 ? true : word(tokens, line, `what follows ${name}`);
  }
  return found;
}

/** "Vec2[] [m] count vertexCount "Vertices."", behind the name. */
function readType(tokens, line, name) {
  let spelled = word(tokens, line, `the type of ${name}`);
  while (spelled.startsWith('(') && !spelled.endsWith(')')) spelled += ` ${word(tokens, line, 'a parameter')}`;
  if (spelled.startsWith('(')) {
    const parameters = spelled.slice(1, -1).split(', ').map((text) => text.split(' ')).map(([own, type]) => ({ name: own, type: cType(type) }));
    const returns = tokens[0]?.word === undefined ? 'void' : word(tokens, line, 'what it returns');
    return { type: 'function', parameters, returns: cType(returns) };
  }
  const [, type, ending, length] = spelled.match(/^(\w+)(\[\]|\?|&|\*|\[(\d+)\])?$/) ?? fail(line, `found the type ${spelled}`);
  return { type, isList: ending === '[]', isOptional: ending === '?', isPointer: ending === '&', isChanged: ending === '*', length: length && Number(length) };
}

function readField(struct, tokens, line) {
  const name = word(tokens, line, 'a field');
  if (name === 'default') {
    struct.made = textOf(tokens, line, 'the default');
    return;
  }
  if (name === 'function') {
    struct.functions.push({ sentence: textOf(tokens, line, 'a function'), code: textOf(tokens, line, 'a function') });
    return;
  }
  const field = { name, ...readType(tokens, line, name), unit: '', sentence: '', flags: new Set() };
  if (tokens[0]?.unit !== undefined) field.unit = tokens.shift().unit;
  Object.assign(field, properties(tokens, line, { count: 1, as: 1, '=': 1, 'c-only': 0, 'cpp-only': 0 }));
  field.sentence = textOf(tokens, line, name);
  struct.fields.push(field);
}

function readStruct(tokens, line) {
  const name = word(tokens, line, 'a name');
  const flags = properties(tokens, line, { version: 1, cpp: 1, in: 1, 'cpp-only': 0, columns: 0, spans: 0, archived: 0, equal: 0 });
  return { name, ...flags, sentence: textOf(tokens, line, name), fields: [], functions: [] };
}

function readFunction(tokens, line) {
  const name = word(tokens, line, 'a name');
  let returns = '';
  if (tokens[0]?.word === 'returns') {
    tokens.shift();
    returns = word(tokens, line, 'a type');
  }
  return { name, returns, sentence: textOf(tokens, line, name), parameters: [] };
}

function readParameter(owner, tokens, line) {
  const name = word(tokens, line, 'a parameter');
  owner.parameters.push({ name, ...readType(tokens, line, name), isOut: properties(tokens, line, { out: 0 }).out === true });
}

function readEnumeration(tokens, line) {
  const name = word(tokens, line, 'a name');
  const prefix = tokens[0]?.word === 'c' ? tokens.splice(0, 2)[1].word : '';
  const type = word(tokens, line, 'a type');
  const isCounted = properties(tokens, line, { counted: 0 }).counted === true;
  return { name, prefix, type, isCounted, sentence: textOf(tokens, line, name), values: [] };
}

const refuse = (owner, tokens, line) => fail(line, 'found a line of its own, expected none');

function readSection(name) {
  const path = `api/${name}.txt`;
  const lines = readFileSync(join(folder, path), 'utf8').split('\n');
  const found = readKinds(path, {
    section: {
      open: (tokens, line) => ({ name: word(tokens, line, 'a name'), component: word(tokens, line, 'a component'), sentence: textOf(tokens, line, 'it') }),
      add: refuse,
    },
    struct: { open: readStruct, add: readField },
    handle: { open: (tokens, line) => ({ name: `${word(tokens, line, 'a name')}Id`, sentence: textOf(tokens, line, 'it') }), add: refuse },
    enum: { open: readEnumeration, add: addValue },
    number: {
      open: (tokens, line) => ({ name: word(tokens, line, 'a name'), type: word(tokens, line, 'a type'), sentence: textOf(tokens, line, 'it') }),
      add: refuse,
    },
    callback: { open: readFunction, add: readParameter },
    function: { open: readFunction, add: readParameter },
  });
  const [{ owner: section }, ...others] = found;
  return {
    ...section,
    declarations: others.map(({ keyword, line, owner }) => ({ ...owner, kind: keyword, isApart: lines[line - 2].trim() === '' })),
  };
}

const files = kFiles.map(readSection);
/** All structs, also those of C++ alone. */
export const apiStructs = files.flatMap(({ name: file, declarations }) => declarations.filter(({ kind }) => kind === 'struct').map((one) => ({ ...one, file })));

/** The sections of the C API: {name, component, sentence, declarations}. */
export const apiSections = files
  .filter(({ component }) => component !== 'none')
  .map((section) => ({ ...section, declarations: section.declarations.filter((one) => !one['cpp-only']) }));

/** The name of the number of a list. */
const countOf = (struct, { name, count }) => count ?? (struct.columns ? 'count' : `${singular(name)}Count`);

/** The members of a struct of C: {type, name, about, length, count, parameters, returns}. */
export function structMembers(struct) {
  const version = { type: 'uint32_t', name: 'structVersion', about: `Set by ${makerOf(struct)}().` };
  const members = struct.fields.filter((field) => !field['cpp-only']).flatMap((field) => {
    const { name, type, isList, isPointer, isChanged, isOptional, length, parameters, returns } = field;
    if (type === 'function') return [{ type, name, about: field.sentence, parameters, returns }];
    if (isList) {
      const count = countOf(struct, field);
      const list = { type: `const ${cType(type)}*`, name, about: withUnit(field).replace(/\bempty\b/, 'none'), count };
      return struct.columns || field.count ? [list] : [list, { type: 'int32_t', name: count, about: 'Their number.' }];
    }
    if (isOptional && !isId(type)) return membersOf(field, cType(type)).map(([code, text]) => ({ type: code.split(' ')[0], name: code.split(' ')[1], about: text }));
    const pointer = isPointer ? `const ${cType(type)}*` : isChanged ? `${cType(type)}*` : cType(type);
    return [{ type: pointer, name, about: withUnit(field), length }];
  });
  return struct.version ? [version, ...members] : members;
}

/** The function that makes a struct with a version. */
export const makerOf = ({ name }) => `muster_default_${name.replace(/(?<!^)([A-Z])/g, '_$1').toLowerCase()}`;

/** The parameters of a function of C: {name, type, out, count}. */
export function functionParameters({ parameters }) {
  return parameters.flatMap((parameter, at) => {
    const { name, type, isOut, isList, isPointer, isChanged } = parameter;
    const item = cType(type);
    if (isOut) {
      const own = `out${name[0].toUpperCase()}${name.slice(1)}`;
      if (!isList) return [{ name: own, type: isPointer ? `const ${item}**` : `${item}*`, out: true }];
      const list = { name: own, type: type === 'text' ? 'const char* const**' : `const ${item}**`, out: true, count: 'outCount' };
      const isLast = !(parameters[at + 1]?.isOut && parameters[at + 1].isList);
      return isLast ? [list, { name: 'outCount', type: 'int32_t*', out: true }] : [list];
    }
    if (type === 'bytes' || type === 'chars')
      return [{ name, type: type === 'bytes' ? 'const uint8_t*' : 'const char*', count: 'size' }, { name: 'size', type: 'size_t' }];
    if (isList) return [{ name, type: `const ${item}*`, count: `${singular(name)}Count` }, { name: `${singular(name)}Count`, type: 'int32_t' }];
    return [{ name, type: isPointer ? `const ${item}*` : isChanged ? `${item}*` : item }];
  });
}

/** What a function or a callback returns: a callback nothing, a function a status where it says nothing else. */
export function returnType({ kind, returns }) {
  if (returns === '') return kind === 'callback' ? 'void' : 'MusterStatus';
  return returns.endsWith('&') ? `const ${cType(returns.slice(0, -1))}*` : cType(returns);
}

/** True for types whose C struct holds the same bytes as that of C++. */
export function isFlat(type) {
  if (plain(type) || isId(type) || ['MotionIndex', 'Pose', 'MeshPoint', 'Triangle', 'Box', 'Body'].includes(type) || enumerations.some(({ name }) => name === type)) return true;
  const struct = apiStructs.find(({ name }) => name === type);
  return struct !== undefined && struct.fields.every((field) => !field.isList && !field.isOptional && field.type !== 'text' && isFlat(field.type));
}
