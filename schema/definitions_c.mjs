// The structs of definitions in C, and both directions between C and C++.
import { definitions, isDefinition, isEnumeration } from './read.mjs';
import { aligned, docComment, hasOf, singular, upperWords, withUnit } from './text.mjs';
import { kDefinitionsBanner } from './definitions_cpp.mjs';
import { isId, plain } from './types.mjs';

export const definitionsInC = definitions.filter(({ flags }) => !flags.has('no-c'));
const isFlat = (type) => !isDefinition(type) || definitions.some(({ name, flags }) => name === type && flags.has('flat'));
const maker = ({ name }) => `muster_default_${upperWords(name).toLowerCase()}`;
/** Maps have a form of their own in C. */
const kOwnNames = { MapGround: 'MusterMapDef' };

function cName(type) {
  if (type === 'text') return 'const char*';
  return kOwnNames[type] ?? plain(type)?.c ?? `Muster${type}`;
}

/** A sentence without what is only said in C++. */
const asInC = (sentence) =>
  sentence
    .replace(/(\w)::(\w)/g, '$1.$2')
    .replace(/ \(SPEC [^)]*\)/, '')
    .replace(/\b(?=(World|Group)Def\b)/g, 'Muster');

/** The comment in C: ids, lists and pointers are none in another way than in C++. */
function about(field) {
  const sentence = asInC(withUnit(field));
  if (field.type === 'text') return `${sentence.replace(/(?<!\.)\.$/, '').replace(/; (may be empty|empty for none)/, '')}; null for none.`;
  if (field.isList) return sentence.replace(/; empty for none\b/, '').replace(/\bempty\b/, 'none');
  if (isId(field.type)) return sentence.replace(/\bnone\b/, '0');
  return isDefinition(field.type) && field.isOptional ? sentence.replace(/\bnone\b/, 'null') : sentence;
}

/** The members that stand for a field: [declaration, comment]. */
function membersOf(field) {
  const { name, type, isList, isOptional } = field;
  const item = cName(type);
  const text = about(field);
  if (isList) return [[`const ${item}* ${name}`, text], [`int32_t ${singular(name)}Count`, 'Their number.']];
  if (type === 'PolygonWithHoles')
    return [
      [`${item} ${name}`, text],
      [`const ${item}* holes`, 'Its holes, clockwise, apart from each other [m].'],
      ['int32_t holeCount', 'Their number.'],
    ];
  if (type === 'Parameters')
    return [
      ['const char* preset', 'Preset of parameters, "units", "people" or "paper"; null for "units".'],
      [`const MusterParameterValue* ${name}`, 'Parameters that differ from the preset, set in this order.'],
      [`int32_t ${singular(name)}Count`, 'Their number.'],
    ];
  if (!isOptional) return [[`${item} ${name}`, text]];
  if (isDefinition(type)) return [[`const ${item}* ${name}`, text]];
  const [is, none] = text.replace(/\.$/, '').split('; none for ');
  return [[`bool ${hasOf(name)}`, `False: ${none}.`], [`${item} ${name}`, `${is}.`]];
}

/** The fields in the order of the C struct. */
export function inCOrder(fields) {
  const ordered = [];
  for (const field of fields.filter(({ cAfter }) => cAfter === '')) ordered.push(field);
  for (const field of fields.filter(({ cAfter }) => cAfter !== ''))
    ordered.splice(ordered.findIndex(({ name }) => name === field.cAfter) + 1, 0, field);
  return ordered;
}

/** The struct of C: its name, members with their comments, and the function that makes it. */
export function definitionStruct(definition) {
  const { name, sentences, version, made, fields } = definition;
  const members = inCOrder(fields).flatMap((field) => {
    const own = membersOf(field).map(([code, text]) => ({ code, about: text }));
    own.forEach((member, at) => {
      const next = own[at + 1]?.code;
      if (member.code.includes('*') && next?.endsWith('Count')) member.count = next.split(' ').at(-1);
    });
    return own;
  });
  if (version !== null) members.unshift({ code: 'uint32_t structVersion', about: `Set by ${maker(definition)}().` });
  return { name: `Muster${name}`, doc: asInC(sentences[0]), made, maker: maker(definition), members };
}

function struct(definition) {
  const { name, doc, made, maker: function_, members } = definitionStruct(definition);
  const rows = members.map(({ code, about: text }) => ({ code: `${code};`, about: text }));
  const lines = [...docComment(doc), `typedef struct ${name} {`, ...aligned(rows), `} ${name};`];
  if (made !== '') lines.push(...docComment(made), `MUSTER_API ${name} ${function_}(void);`);
  return lines.join('\n');
}

/** All of them in C. */
export const definitionLines = () => definitionsInC.map(struct).join('\n\n');

/** The line that reads or writes one field. */
function marshal({ name, type, isList, isOptional }) {
  const both = `c.${name}, p.${name}`;
  const has = `c.${hasOf(name)}`;
  if (isList) return `m.${isFlat(type) ? 'list' : 'items'}(c.${name}, c.${singular(name)}Count, p.${name}, "${name}");`;
  if (type === 'PolygonWithHoles')
    return `m.part(c.${name}, p.${name}.outline, "${name}");\n    m.items(c.holes, c.holeCount, p.${name}.holes, "holes");`;
  if (type === 'Parameters') return `parameterFields(m, c, p.${name});`;
  if (isId(type)) return `m.id(${both});`;
  if (type === 'text') return `m.text(${both});`;
  if (type === 'Polygon') return `m.part(${both}, "${name}");`;
  if (isEnumeration(type))
    return isOptional ? `m.optionalChoice(${has}, ${both}, kLastOf<${type}>, "${name}");` : `m.choice(${both}, kLastOf<${type}>, "${name}");`;
  if (isDefinition(type)) return `m.${isOptional ? 'optionalPart' : 'part'}(${both}, "${name}");`;
  return isOptional ? `m.optional(${has}, ${both});` : `m.plain(${both});`;
}

function pair({ name, cpp, version, fields, flags }) {
  const lines = flags.has('flat') ? ['m.plain(c, p);'] : inCOrder(fields).map(marshal);
  if (version !== null) lines.unshift(`m.template version<Muster${name}>(c.structVersion);`);
  return `template <class M>
void fields(M& m, C<M, Muster${name}>& c, P<M, ${cpp}>& p) {
${lines.map((line) => `    ${line}`).join('\n')}
}`;
}

/** Members of both sides stand at the same places. */
function layout({ name, cpp, fields }) {
  const same = fields.slice(1).map((field) => `offsetof(Muster${name}, ${field.name}) == offsetof(${cpp}, ${field.name})`);
  return [`static_assert(sizeof(Muster${name}) == sizeof(${cpp}));`, ...same.map((one) => `static_assert(${one});`)].join('\n');
}

const marshalling = () => `${kDefinitionsBanner}// The fields of definitions, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/marshal.h"
#include "muster/generated/world_definitions.h"
#include "muster/muster.h"

namespace muster::c_api {

${definitionsInC.filter(({ version }) => version !== null).map((one) => `MUSTER_STRUCT_VERSION(Muster${one.name}, ${one.version.kind}, ${one.version.version}, "${maker(one)}");`).join('\n')}

${definitionsInC.filter(({ flags }) => flags.has('flat')).map(layout).join('\n')}

/// Reads the preset, and what differs from it.
void parameterFields(FromC& m, const MusterWorldDef& c, Parameters& p);
/// Writes what differs from the preset "muster".
void parameterFields(ToC& m, MusterWorldDef& c, const Parameters& p);

${definitionsInC.map(pair).join('\n')}

}  // namespace muster::c_api
`;

const defaults = () => `${kDefinitionsBanner}// Definitions as they are made at first: those of the engine, so that none stands twice.
#include "bindings/c/c_world/default_of.h"

using namespace muster;
using namespace muster::c_api;

${definitionsInC.filter(({ made }) => made !== '').map((one) => `Muster${one.name} ${maker(one)}(void) {
    return defaultOf<Muster${one.name}, ${one.cpp}>();
}`).join('\n')}
`;

export const definitionCFiles = () => ({
  'bindings/c/c_world/generated/definition_fields.h': marshalling(),
  'bindings/c/c_world/generated/definition_defaults.cpp': defaults(),
});
