// The structs of commands in C, and their marshalling.
import { commands } from './read.mjs';
import { aligned, cHeader, docComment, hasOf, inC, listed, lowerFirst, singular, upperWords, withUnit } from './text.mjs';
import { kBanner } from './cpp.mjs';
import { cItem, definition, enumerated, isId } from './types.mjs';

/** The comment of a C header: ids and lists are none where they are 0. */
function about(field) {
  const sentence = withUnit(field);
  if (isId(field.type)) return sentence.replace(/\bnone\b/, '0');
  return field.isList ? sentence.replace(/\bempty\b/, 'none') : sentence;
}

/** The members that stand for a field: [type, name, comment]. */
export function membersOf(field, item = cItem(field.type)) {
  const { name } = field;
  if (field.isList) {
    const [sentence, none] = about(field).replace(/\.$/, '').split('; none for ');
    return [
      ...(field.isOptional ? [[`bool ${hasOf(name)}`, `False: ${none}.`]] : []),
      [`const ${item}* ${name}`, field.isOptional ? `${sentence}.` : about(field)],
      [`int32_t ${singular(name)}Count`, 'Their number.'],
    ];
  }
  if (field.isOptional && definition(field.type)) return [[`const ${item}* ${name}`, about(field).replace(/\bnone\b/, 'null')]];
  if (field.isOptional && !isId(field.type)) {
    const [is, none = ''] = field.sentence.replace(/\.$/, '').split('; none for ');
    return [
      [`bool ${hasOf(name)}`, `False: ${none}.`],
      [`${item} ${name}`, `${is}.`],
    ];
  }
  if (field.flags.has('internal')) return [[`${item} ${name}`, 'Not used; 0.']];
  return [[`${item} ${name}`, field.type === 'text' ? about(field).replace(/\.$/, '; null for none.') : about(field)]];
}

function struct(command) {
  const rows = command.fields.flatMap((field) => membersOf(field)).map(([code, text]) => ({ code: `${code};`, about: text }));
  return [
    ...docComment(command.sentence),
    `typedef struct Muster${command.name} {`,
    ...aligned(rows),
    `} Muster${command.name};`,
  ].join('\n');
}

/** The kinds of commands: {name, value, about}. */
export const commandKinds = () => [
  ...commands.map(({ name, index }) => ({ name: `MUSTER_COMMAND_${upperWords(name)}`, value: index, about: `Its body is \`${lowerFirst(name)}\`.` })),
  { name: 'MUSTER_COMMAND_COUNT', value: commands.length, about: 'Number of kinds.' },
];

/** The members of the union of all bodies: {name, type, about}. */
export const commandMembers = () =>
  commands.map(({ name }) => ({ name: lowerFirst(name), type: `Muster${name}`, about: `For MUSTER_COMMAND_${upperWords(name)}.` }));

function bodies() {
  const kinds = commandKinds().map(({ name, value, about: text }, at, all) => ({ code: `${name} = ${value}${at + 1 < all.length ? ',' : ''}`, about: text }));
  const members = commandMembers().map(({ name, type, about: text }) => ({ code: `${type} ${name};`, about: text }));
  return cHeader(inC(kBanner), 'COMMAND_BODIES', '#include "muster/c/definitions.h"', `
${commands.map(struct).join('\n\n')}

/// Kinds of commands.
typedef int32_t MusterCommandKind;
/// Values of MusterCommandKind.
enum MusterCommandKindValue {
${aligned(kinds).join('\n')}
};

/// What a command of each kind says. Only the member of the command's kind is read.
typedef union MusterCommandBody {
${aligned(members).join('\n')}
} MusterCommandBody;
`);
}

/** The line that reads or writes one field. */
function marshal(field) {
  const { name, type } = field;
  const both = `c.${name}, p.${name}`;
  const named = definition(type);
  const has = `c.${hasOf(name)}`;
  if (field.isList) {
    const visit = named === undefined || named.isPlainInC ? 'list' : 'items';
    const words = `c.${name}, c.${singular(name)}Count, p.${name}, "${name}"`;
    if (field.isOptional) return `if (m.given(${has}, p.${name})) m.${visit}(${words.replace(`p.${name}`, `*p.${name}`)});`;
    return `m.${visit}(${words});`;
  }
  if (isId(type)) return `m.id(${both});`;
  if (type === 'text' && field.isOptional) return `if (m.given(${has}, p.${name})) m.text(c.${name}, *p.${name});`;
  if (type === 'text') return `m.text(${both});`;
  if (enumerated(type)) {
    if (field.isOptional) return `m.optionalChoice(${has}, ${both}, kLastOf<${type}>, "${name}");`;
    return `m.choice(${both}, kLastOf<${type}>, "${name}");`;
  }
  if (field.isOptional && named) return `m.optionalPart(${both}, "${name}");`;
  if (field.isOptional) return `m.optional(${has}, ${both});`;
  return named === undefined || named.isPlainInC ? `m.plain(${both});` : `m.part(${both}, "${name}");`;
}

function marshalling() {
  const pair = (command) => `template <class M>
void fields(M& m, C<M, Muster${command.name}>& c, P<M, ${command.name}>& p) {
${command.fields.map((field) => `    ${marshal(field)}`).join('\n')}
}`;
  const members = commands.map(({ name }) => `&MusterCommandBody::${lowerFirst(name)}`);
  return `${kBanner}// The fields of each kind of command, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <tuple>
#include <variant>

#include "bindings/c/c_world/world_fields.h"
#include "muster/c/command.h"
#include "muster/command.h"

namespace muster::c_api {

${commands.map(pair).join('\n')}

/// The members of the C union, in the order of the engine's alternatives.
// clang-format off
inline constexpr std::tuple kCommandMembers{
${listed(members, '};')}
// clang-format on
static_assert(std::tuple_size_v<decltype(kCommandMembers)> == std::variant_size_v<CommandKinds> &&
              std::variant_size_v<CommandKinds> == MUSTER_COMMAND_COUNT);

}  // namespace muster::c_api
`;
}

export const cFiles = () => ({
  'include/muster/c/generated/command_bodies.h': bodies(),
  'bindings/c/c_world/generated/command_kind_fields.h': marshalling(),
});
