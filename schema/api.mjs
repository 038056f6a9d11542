// Reads the declarations of the C API in api/*.txt (README.md tells their form).
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { addToStruct, addValue, definitions, described, fail, folder, readField, readKinds, readStruct, readType, word } from './read.mjs';

/** The sections of the header of C, each after those that it uses. */
const kFiles = ['base', 'values', 'definitions', 'commands', 'views', 'world', 'scenario', 'clips', 'motion', 'bvh', 'take', 'figures'];

const textOf = (tokens, line, what) => tokens.shift()?.text ?? fail(line, `found no sentence for ${what}`);

/** True where the word stands next, which is taken; nothing else than a sentence may stand there. */
function takes(tokens, line, name) {
  if (tokens.length === 0 || tokens[0].text !== undefined) return false;
  const found = word(tokens, line, name);
  return found === name || fail(line, `found ${found}, expected ${name}`);
}

const kStructFlags = ['cpp-only', 'columns', 'spans', 'archived', 'equal'];
const readApiField = (tokens, line) => described(readField(tokens, line, () => true), line);

function readApiStruct(tokens, line) {
  const struct = readStruct(tokens, line, kStructFlags);
  return struct.sentences.length === 1 ? struct : fail(line, `found no sentence for ${struct.name}`);
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
  owner.parameters.push({ name, ...readType(tokens, line, name), isOut: takes(tokens, line, 'out') });
}

function readEnumeration(tokens, line) {
  const name = word(tokens, line, 'a name');
  const prefix = tokens[0]?.word === 'c' ? tokens.splice(0, 2)[1].word : '';
  const type = word(tokens, line, 'a type');
  const isCounted = takes(tokens, line, 'counted');
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
    struct: { open: readApiStruct, add: (owner, tokens, line) => addToStruct(owner, tokens, line, readApiField) },
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
  .map((section) => ({ ...section, declarations: section.declarations.filter(({ flags }) => !flags?.has('cpp-only')) }));

const owners = new Map();
for (const { name, version } of [...definitions, ...apiStructs]) {
  if (version === null) continue;
  if (owners.has(version.kind)) throw new Error(`schema: the struct ${name} has the kind ${version.kind} of ${owners.get(version.kind)}, expected one of its own`);
  owners.set(version.kind, name);
}
