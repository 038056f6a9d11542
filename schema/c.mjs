// Commands in C, and both directions between C and C++.
import { commands } from './read.mjs';
import { kBanner } from './cpp.mjs';
import { marshalled, membersLines, structLines } from './c_struct.mjs';
import { aligned, listed, lowerFirst, upperWords } from './text.mjs';

/** The kinds of commands: {name, value, about}. */
export const commandKinds = () => [
  ...commands.map(({ name, index }) => ({ name: `MUSTER_COMMAND_${upperWords(name)}`, value: index, about: `Its body is \`${lowerFirst(name)}\`.` })),
  { name: 'MUSTER_COMMAND_COUNT', value: commands.length, about: 'Number of kinds.' },
];

/** What the union of all bodies is. */
export const kBodySentence = "What a command of each kind says. Only the member of the command's kind is read.";
/** The members of the union of all bodies: {name, type, about}. */
export const commandMembers = () =>
  commands.map(({ name }) => ({ name: lowerFirst(name), type: `Muster${name}`, about: `For MUSTER_COMMAND_${upperWords(name)}.` }));

/** The bodies of commands, their kinds, and the union of all bodies, in C. */
export function commandLines() {
  const kinds = commandKinds().map(({ name, value, about: text }, at, all) => ({ code: `${name} = ${value}${at + 1 < all.length ? ',' : ''}`, about: text }));
  return `${commands.map((command) => structLines(command).join('\n')).join('\n\n')}

/// Kinds of commands.
typedef int32_t MusterCommandKind;
/// Values of MusterCommandKind.
enum MusterCommandKindValue {
${aligned(kinds).join('\n')}
};

${membersLines('CommandBody', kBodySentence, commandMembers(), 'union').join('\n')}`;
}

function marshalling() {
  const members = commands.map(({ name }) => `&MusterCommandBody::${lowerFirst(name)}`);
  return `${kBanner}// The fields of each kind of command, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <tuple>
#include <variant>

#include "bindings/c/c_world/world_fields.h"
#include "muster/command.h"
#include "muster/muster.h"

namespace muster::c_api {

${commands.map(marshalled).join('\n')}

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
  'bindings/c/c_world/generated/command_kind_fields.h': marshalling(),
});
