// The structs of commands in C++, what checks their fields, and what people are shown of them.
import { structLines } from './cpp_struct.mjs';
import { commands, definitionOf, enumerations, formerCommands, isEnumeration, kGivenFlags } from './read.mjs';
import { call, kWidth, limit, listed } from './text.mjs';
import { isId, mayBeNone } from './types.mjs';

export const kBanner = '// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.\n';

const struct = (command) => structLines(command, { archived: 'the command' }).join('\n');

function header() {
  return `${kBanner}// The kinds of commands: every change of a world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/generated/world_definitions.h"
#include "muster/id.h"
#include "muster/order.h"
#include "muster/people.h"

namespace muster {

${commands.map(struct).join('\n')}

/// Every kind of change.
// clang-format off
using CommandKinds = std::variant<
${call('', commands.map(({ name }) => name), '>;', '    ').join('\n')}
// clang-format on

}  // namespace muster
`;
}

/** The numbers of kinds in takes, in the order of a variant. */
const numbers = (name, kinds) => `// clang-format off
inline constexpr std::array<std::uint8_t, ${kinds.length}> ${name}{
${call('', kinds.map(({ number }) => String(number)), '};', '    ').join('\n')}
// clang-format on`;

const kFormerBanner = kBanner.replace('commands.txt', 'former.txt');

function formerHeader() {
  return `${kFormerBanner}// Commands by the names that they had: CommandBody makes each into the command that says the same.
#pragma once

#include <variant>

#include "muster/generated/command_kinds.h"

namespace muster {

class CommandBody;

${formerCommands.map(struct).join('\n')}

${formerCommands.map(({ name }) => `CommandBody converted(const ${name}& c);`.padEnd(51) + `///< The command that says the same.`).join('\n')}

/// Any of them.
// clang-format off
using FormerKinds = std::variant<
${call('', formerCommands.map(({ name }) => name), '>;', '    ').join('\n')}
// clang-format on

}  // namespace muster
`;
}

function numbersHeader() {
  return `${kBanner}// What takes call each kind of command.
#pragma once

#include <array>
#include <cstdint>

namespace muster {

/// The numbers of kinds, in the order of CommandKinds.
${numbers('kCommandNumbers', commands)}

/// The same of FormerKinds.
${numbers('kFormerNumbers', formerCommands)}

}  // namespace muster
`;
}

/** The check of one field, as an expression of type Status; null where every value of its type will do. */
function checkOf(field) {
  const value = `c.${field.name}`;
  const { type, flags } = field;
  if (!mayBeNone(field) || isEnumeration(type) || type === 'Colour') return checkOfValue(field, value);
  if (!field.isList && definitionOf(type)?.inCommands.check === 'validate(#)' && !flags.has('unchecked')) return `validateIfAny(${value})`;
  const check = checkOfValue(field, 'value');
  return check === null ? null : `checkIfAny(${value}, [](const auto& value) { return ${check}; })`;
}

function checkOfValue(field, value) {
  const { type, range } = field;
  if (field.flags.has('unchecked') || isId(type) || type === 'bool') return null;
  if (type === 'text') return `isText("${field.name}", ${value})`;
  if (type === 'Colour') return `validateColour(${value})`;
  const { check, 'check-list': checkList } = definitionOf(type)?.inCommands ?? {};
  if (check && field.isList) return checkList?.replace('#', value) ?? null;
  if (check) return check.replace('#', value);
  if (field.isList) {
    if (type === 'CharacterId') return `eachOnce(${value})`;
    return type === 'Vec2' && field.count ? `places("${field.name}", ${value}, ${limit(field.count.low)}, ${limit(field.count.high)})` : null;
  }
  if (isEnumeration(type)) return `isKnown(${value}, kLastOf<${type}>, "${field.called || field.name}")`;
  if (type === 'Vec2') return `place("${field.name}", ${value})`;
  if (range === null) return null;
  const bounds = `${type === 'i32' ? 'countIn' : 'numberIn'}("${field.name}", ${value}, ${limit(range.low)}, ${limit(range.high)}`;
  if (type === 'i32') return `${bounds})`;
  return `${bounds}, "[${range.low}, ${range.high}]${field.unit === '' ? '' : ` ${field.unit}`}")`;
}

function validator(command) {
  const checks = command.fields.map(checkOf).filter((check) => check !== null);
  if (command.flags.has('relations')) checks.push('relations(c)');
  if (checks.length === 0) return `    Status operator()(const ${command.name}&) const { return {}; }`;
  const head = `    Status operator()(const ${command.name}& c) const {`;
  const line = `${head} return ${checks[0]}; }`;
  if (checks.length === 1 && line.length <= kWidth) return line;
  if (checks.length === 1) return [head, `        return ${checks[0]};`, '    }'].join('\n');
  const [first, ...others] = checks;
  return [head, `        Status status = ${wrapCall(first)};`, ...others.map(nextCheck), '        return status;', '    }'].join('\n');
}

/** A call that is too long for its line goes on below; a lambda stands on a line of its own. */
function wrapCall(text) {
  if (text.length + '        if (status.ok()) status = ;'.length <= kWidth) return text;
  if (text.includes('[](')) return text.length + 22 <= kWidth ? text : text.replace(', [](', `,\n${' '.repeat(22 + text.indexOf('('))}[](`);
  const at = text.lastIndexOf(', ', kWidth - 32);
  return `${text.slice(0, at + 1)}\n${' '.repeat(30 + text.indexOf('(') + 1)}${text.slice(at + 2)}`;
}

/** "if (status.ok()) status = ...;", on two lines where it is too long. */
function nextCheck(check) {
  const isLong = check.includes('[](') && check.length + '        if (status.ok()) status = ;'.length > kWidth;
  return `        if (status.ok())${isLong ? '\n            ' : ' '}status = ${wrapCall(check)};`;
}

function checks() {
  return `${kBanner}// Names of commands, and what each of their fields has to be.
#include "engine/state/command_checks.h"

#include <array>

#include "engine/state/generated/command_relations.h"
#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

// clang-format off
constexpr auto kNames = std::to_array<const char*>({
${listed(commands.map(({ name }) => `"${name}"`), '});')}
// clang-format on
static_assert(kNames.size() == std::variant_size_v<CommandKinds>);

/// One check per kind of command.
struct Validator {
${commands.map(validator).join('\n')}
};

}  // namespace

const char* commandName(const Command& command) {
    return kNames[command.body.index()];
}

Status validateCommand(const Command& command) {
    return std::visit(Validator(), command.body).within(commandName(command));
}

}  // namespace muster
`;
}

const traitsIn = (label, flags) => `{"${label}", ${['undoable', 'directs', 'edits', 'slides', 'queues'].map((name) => String(flags.has(name))).join(', ')}}`;

/** The fields that say what is true of a command that gives them: those with flags, and all others that may be none. */
function givenFields({ fields }) {
  const says = (field) => kGivenFlags.some((flag) => field.flags.has(flag));
  return fields.some(says) ? fields.filter((field) => says(field) || mayBeNone(field)) : [];
}

function givenTraits(command) {
  const undoable = [...command.flags].filter((flag) => flag === 'undoable');
  const rows = givenFields(command).map(({ name, type, label, flags, isOptional }) =>
    `        give(c->${name}${isOptional ? '.has_value()' : ''}, ${traitsIn(label, new Set([...undoable, ...flags]))});`);
  return rows.length === 0 ? [] : [`    if (const auto* c = std::get_if<${command.name}>(&body)) {`, ...rows, '    }'];
}

/** What people are told of commands, and which of them do what. */
function traits() {
  const rows = commands.map(({ label, flags, name }) => ({ code: `${traitsIn(label, flags)},`, about: name }));
  const column = Math.max(...rows.map(({ code }) => code.length)) + 2;
  return `${kBanner}// What the studio has to know of each kind of command.
#pragma once

#include <array>

#include "muster/command.h"

namespace muster {

/// What is true of a command.
struct CommandTraits {
    const char* label;  ///< What undo and redo call it; empty where that depends on more.
    bool undoable;      ///< It can be taken back.
    bool directs;       ///< It directs a group: a director may send it.
    bool edits;         ///< It edits the place.
    bool slides;        ///< A slider sends many of them, which count as one.
    bool queues;        ///< It changes the queue of its group in a way that only the world knows.
};

/// Those of each kind.
inline constexpr std::array<CommandTraits, std::variant_size_v<CommandKinds>> kCommandTraits{{
${rows.map(({ code, about }) => `    ${code.padEnd(column)}// ${about}`).join('\n')}
}};

// What undo and redo call commands that hold such a value.
${enumerations.filter(({ values }) => values[0].label).map(({ name, values }) => `inline constexpr std::array k${name}Labels{${values.map(({ label }) => `"${label}"`).join(', ')}};`).join('\n')}

/// The traits of a command: those of its kind or, where it gives fields that have their own, those that all
/// of these have.
inline CommandTraits traitsOf(const CommandBody& body) {
    CommandTraits traits = kCommandTraits[body.index()];
    auto give = [&, first = true](bool given, const CommandTraits& of) mutable {
        if (!given) return;
        if (first && *of.label != '\\0') traits.label = of.label;
        traits.directs = of.directs && (first || traits.directs);
        traits.edits = of.edits && (first || traits.edits);
        traits.slides = of.slides && (first || traits.slides);
        first = false;
    };
${commands.flatMap(givenTraits).join('\n')}
    return traits;
}

}  // namespace muster
`;
}

/** What is written by hand for each command: how it is applied, and what its fields have to be together. */
function functions() {
  return `${kBanner}// How each kind of command is applied: the one function that is written for it.
#pragma once

#include "engine/systems/commands/command_context.h"

namespace muster {

${commands.map(({ name }) => `Status apply(CommandContext& context, const ${name}& c);`).join('\n')}

}  // namespace muster
`;
}

function relations() {
  const some = commands.filter(({ flags }) => flags.has('relations'));
  return `${kBanner}// What the fields of a command have to be together: InvalidArgument where they are not.
#pragma once

#include "muster/command.h"

namespace muster {

${some.map(({ name }) => `Status relations(const ${name}& c);`).join('\n')}

}  // namespace muster
`;
}

export const cppFiles = () => ({
  'include/muster/generated/command_kinds.h': header(),
  'src/engine/state/generated/command_checks.cpp': checks(),
  'src/engine/state/generated/command_relations.h': relations(),
  'src/engine/state/generated/command_numbers.h': numbersHeader(),
  'include/muster/generated/former_commands.h': formerHeader(),
  'src/engine/systems/commands/generated/command_functions.h': functions(),
  'src/studio/session/inbox/generated/command_traits.h': traits(),
});
