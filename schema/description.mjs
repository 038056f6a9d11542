// The description of the C API for generators of bindings: docs/api/muster_api.json.
import { apiSections } from './api.mjs';
import { commandKinds, commandMembers, kBodySentence } from './c.mjs';
import { cEnumerations, functionParameters, kHandle, returnType, valuesOf } from './c_header.mjs';
import { makerOf, structMembers, structSentence } from './c_struct.mjs';
import { definitionsInC } from './definitions_c.mjs';
import { commands } from './read.mjs';
import { cType } from './types.mjs';

const described = ({ type, name, about, length, count, parameters, returns }) => ({
  ...(type === 'function' ? { name, returns, parameters: parameters.map((one) => ({ name: one.name, type: one.type })), type } : { name, type }),
  ...(length ? { length } : {}),
  doc: about,
  ...(count ? { count } : {}),
});

const structOf = (name, doc, members, kind = 'struct') => ({ list: 'structs', entry: { name: `Muster${name}`, kind, doc, fields: members.map(described) } });
const functionOf = (name, returns, parameters, doc) => ({ list: 'functions', entry: { name, returns, parameters, doc } });

/** What a declaration of api/*.txt stands for: {list, entry}. */
function entriesOf(declaration) {
  const { kind, name, sentence: doc } = declaration;
  if (kind === 'enum') {
    const values = valuesOf(declaration).map((one) => ({ name: one.name, value: one.value, doc: one.about }));
    return [{ list: 'integers', entry: { name: `Muster${name}`, type: cType(declaration.type), doc }, values }];
  }
  if (kind === 'number') return [{ list: 'integers', entry: { name: `Muster${name}`, type: cType(declaration.type), doc } }];
  if (kind === 'handle') return [structOf(name, doc, kHandle)];
  if (kind === 'callback')
    return [{ list: 'callbacks', entry: { name: `Muster${name}`, returns: returnType(declaration), parameters: functionParameters(declaration), doc } }];
  if (kind === 'function') return [functionOf(`muster_${name}`, returnType(declaration), functionParameters(declaration), doc)];
  return structEntries(declaration);
}

/** A struct, and who makes it. */
function structEntries(struct) {
  const { name, made } = struct;
  const entry = structOf(name, structSentence(struct), structMembers(struct));
  return made === '' ? [entry] : [entry, functionOf(makerOf(struct), `Muster${name}`, [], made)];
}

const enumerationEntries = () => cEnumerations.flatMap(entriesOf);

/** The bodies of commands, their kinds, and the union of all bodies. */
function commandEntries() {
  const values = commandKinds().map(({ name, value, about }) => ({ name, value, doc: about }));
  const kind = { list: 'integers', entry: { name: 'MusterCommandKind', type: 'int32_t', doc: 'Kinds of commands.' }, values };
  return [...commands.flatMap(structEntries), kind, structOf('CommandBody', kBodySentence, commandMembers(), 'union')];
}

const definitionEntries = () => definitionsInC.flatMap(structEntries);

/** What another file than api/*.txt declares, before the rest of its section. */
const kBefore = { values: enumerationEntries, definitions: definitionEntries, commands: commandEntries };

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
  for (const { name: section, component, declarations } of apiSections)
    for (const { list, entry, values } of [...(kBefore[section]?.() ?? []), ...declarations.flatMap(entriesOf)])
      api[list].push({ ...entry, section, component, ...(values ? { values } : {}) });
  addRoles(api);
  return api;
}

/** The whole API: integers, structs, callbacks and functions, as bindings see them. */
export const description = describe();

export const descriptionFiles = () => ({ 'docs/api/muster_api.json': `${JSON.stringify(description, null, 1)}\n` });
