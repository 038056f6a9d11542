// The description of the C API for generators of bindings: docs/api/muster_api.json.
import { apiHeaders, cType, functionParameters, makerOf, returnType, structMembers } from './api.mjs';
import { commandKinds, commandMembers, membersOf } from './c.mjs';
import { valuesOf } from './c_headers.mjs';
import { definitionsInC, definitionStruct } from './definitions_c.mjs';
import { commands, enumerations } from './read.mjs';

/** The headers, each after those that it includes. */
const kOrder = ['base', 'generated/enumerations', 'values', 'generated/definition_structs', 'definitions', 'generated/command_bodies', 'command', 'views', 'world',
  'clips', 'bvh', 'motion', 'scenario', 'take'];

const described = ({ type, name, about, length, count, parameters, returns }) => ({
  ...(type === 'function' ? { name, returns, parameters: parameters.map((one) => ({ name: one.name, type: one.type })), type } : { name, type }),
  ...(length ? { length } : {}),
  doc: about,
  ...(count ? { count } : {}),
});

const kHandleFields = [
  { name: 'index1', type: 'uint32_t', doc: 'Slot, counted from 1; 0 for none.' },
  { name: 'generation', type: 'uint32_t', doc: 'Which of those that had the slot.' },
];

const functionOf = (name, returns, parameters, doc) => ({ list: 'functions', entry: { name, returns, parameters, doc } });

/** What a declaration of api/*.txt stands for: {list, entry}. */
function entriesOf(declaration) {
  const { kind, name, sentence: doc } = declaration;
  if (kind === 'enum') {
    const values = valuesOf(declaration).map((one) => ({ name: one.name, value: one.value, doc: one.about }));
    return [{ list: 'integers', entry: { name: `Muster${name}`, type: cType(declaration.type), doc }, values }];
  }
  if (kind === 'number') return [{ list: 'integers', entry: { name: `Muster${name}`, type: cType(declaration.type), doc } }];
  if (kind === 'handle') return [{ list: 'structs', entry: { name: `Muster${name}`, kind: 'struct', doc, fields: kHandleFields } }];
  if (kind === 'callback')
    return [{ list: 'callbacks', entry: { name: `Muster${name}`, returns: returnType(declaration), parameters: functionParameters(declaration), doc } }];
  if (kind === 'function') return [functionOf(`muster_${name}`, returnType(declaration), functionParameters(declaration), doc)];
  const struct = { list: 'structs', entry: { name: `Muster${name}`, kind: 'struct', doc, fields: structMembers(declaration).map(described) } };
  return declaration.made ? [struct, functionOf(makerOf(declaration), `Muster${name}`, [], declaration.made)] : [struct];
}

/** Enumerations of definitions, orders, commands and events. */
const enumerationEntries = () => enumerations.flatMap((one) => entriesOf({ ...one, kind: 'enum', type: 'u8' }));

/** The bodies of commands, their kinds, and the union of all bodies. */
function commandEntries() {
  const bodies = commands.map(({ name, sentence, fields }) => ({
    list: 'structs',
    entry: { name: `Muster${name}`, kind: 'struct', doc: sentence, fields: fields.flatMap(fieldsOfBody) },
  }));
  const values = commandKinds().map(({ name, value, about }) => ({ name, value, doc: about }));
  const kind = { list: 'integers', entry: { name: 'MusterCommandKind', type: 'int32_t', doc: 'Kinds of commands.' }, values };
  const doc = "What a command of each kind says. Only the member of the command's kind is read.";
  const members = commandMembers().map(({ name, type, about }) => ({ name, type, doc: about }));
  return [...bodies, kind, { list: 'structs', entry: { name: 'MusterCommandBody', kind: 'union', doc, fields: members } }];
}

function fieldsOfBody(field) {
  const members = membersOf(field).map(([code, doc]) => ({ name: code.split(' ').at(-1), type: code.slice(0, code.lastIndexOf(' ')), doc }));
  if (field.isList) members.at(-2).count = members.at(-1).name;
  return members;
}

/** The structs of definitions, and who makes them. */
const definitionEntries = () =>
  definitionsInC.flatMap((definition) => {
    const { name, doc, made, maker, members } = definitionStruct(definition);
    const fields = members.map(({ code, about, count }) => ({ name: code.split(' ').at(-1), type: code.slice(0, code.lastIndexOf(' ')), doc: about, ...(count ? { count } : {}) }));
    const struct = { list: 'structs', entry: { name, kind: 'struct', doc, fields } };
    return made === '' ? [struct] : [struct, functionOf(maker, name, [], made)];
  });

function entriesOfHeader(header) {
  if (header === 'generated/enumerations') return enumerationEntries();
  if (header === 'generated/command_bodies') return commandEntries();
  if (header === 'generated/definition_structs') return definitionEntries();
  return apiHeaders.find(({ name }) => name === header).declarations.flatMap(entriesOf);
}

/** Handles, and who makes structs that have a version. */
function addRoles(api) {
  for (const struct of api.structs) {
    const names = struct.fields.map((field) => field.name).join();
    if (names === 'index1,generation') struct.handle = true;
    if (struct.fields[0]?.name !== 'structVersion') continue;
    const maker = api.functions.find((one) => one.returns === struct.name && one.name.startsWith('muster_default_'));
    if (!maker) throw new Error(`struct ${struct.name}: found no muster_default_ function, expected one`);
    struct.madeBy = maker.name;
  }
}

function describe() {
  const api = { header: 'muster/muster.h', integers: [], structs: [], callbacks: [], functions: [] };
  for (const header of kOrder) {
    const component = apiHeaders.find(({ name }) => name === header)?.component ?? 'core';
    for (const { list, entry, values } of entriesOfHeader(header))
      api[list].push({ ...entry, header: `muster/c/${header}.h`, component, ...(values ? { values } : {}) });
  }
  addRoles(api);
  return api;
}

/** The whole API: integers, structs, callbacks and functions, as bindings see them. */
export const description = describe();

export const descriptionFiles = () => ({ 'docs/api/muster_api.json': `${JSON.stringify(description, null, 1)}\n` });
