// Messages in C++: their structs, and what encodes and decodes them.
import { memberOf } from './cpp_struct.mjs';
import { kCommand, messageDefinitions, page, parts, server, shared, values, version } from './messages.mjs';
import { definitions, kSubjects } from './read.mjs';
import { call, docComment, kWidth, wrap } from './text.mjs';

const kFolder = 'studio/session/inbox/generated';
const kBegin = `// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.
// clang-format off
`;
const kHeader = `${kBegin}#pragma once

`;
const kEnd = '}  // namespace muster::protocol\n';

const isChoice = (type) => [...values, ...shared].some(({ name }) => name === type);

/** "std::uint32_t id = 0;": commands are bytes, and an enumeration is its first value. */
function declared(entry, field) {
  if (field.type === kCommand) return `std::vector<std::uint8_t> ${field.name};`;
  const choice = field.isList || field.isOptional ? undefined : [...values, ...shared].find(({ name }) => name === field.type);
  const [first] = choice?.values ?? [];
  const { type, name, initial } = memberOf(entry, field);
  const value = choice ? `${type}::${first.name ?? first}` : initial;
  return `${type} ${name}${value === '' ? '' : ` = ${value}`};`;
}

/** The comment behind a field: its sentence with the unit, or the unit alone. */
function about({ sentence, unit }) {
  const text = unit === '' ? sentence : sentence === '' ? `[${unit}].` : sentence.replace(/[.;]/, (stop) => ` [${unit}]${stop}`);
  return text === '' ? '' : `  ///< ${text}`;
}

function struct(entry) {
  const choices = entry.fields.filter(({ type, isList }) => isChoice(type) && !isList);
  return [
    ...docComment(entry.sentence),
    `struct ${entry.name} {`,
    ...(entry.number === null ? [] : [`    static constexpr std::uint8_t kNumber = ${entry.number};  ///< First byte of the message.`]),
    ...entry.fields.map((field) => `    ${declared(entry, field)}${about(field)}`),
    '',
    '    /// Lets an archive read or write the fields.',
    '    template <class Archive>',
    '    void visit(Archive& archive) {',
    ...call('archive(', entry.fields.map(({ name }) => name), ');', '        '),
    ...choices.map(({ name }) => `        checkChoice(archive, ${name});`),
    '    }',
    '};',
    '',
  ].join('\n');
}

const wrapped = (words) => wrap(words.join(', '), kWidth - 4).map((line) => `    ${line}`).join('\n');

/** Headers of the definitions that messages have. */
const definitionHeaders = () =>
  kSubjects
    .filter((subject) => definitions.some((one) => one.header === subject && messageDefinitions.includes(one.name)))
    .sort()
    .map((subject) => `#include "muster/generated/${subject}_definitions.h"`)
    .join('\n');

const partHeader = () => `${kHeader}#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
${definitionHeaders()}

namespace muster::protocol {

inline constexpr std::uint32_t kVersion = ${version};                 ///< Raised by any change of a message.
inline constexpr const char* kSubprotocol = "muster.v${version}";  ///< Of the WebSocket.

${shared.map(({ name }) => `using muster::${name};`).join('\n')}
${values.map(({ name, sentence, values: words }) => `/// ${sentence}\nenum class ${name} : std::uint8_t { ${words.join(', ')} };`).join('\n')}

/// How many values an enumeration has.
template <class Choice>
inline constexpr std::size_t kChoices = kCountOf<Choice>;
${values.map(({ name, values: words }) => `template <>\ninline constexpr std::size_t kChoices<${name}> = ${words.length};`).join('\n')}

/// Marks the input as bad where an enumeration read from it has no such value.
template <class Archive, class Choice>
void checkChoice(Archive& archive, Choice value) {
    if constexpr (Archive::kReading) {
        if (static_cast<std::size_t>(value) >= kChoices<Choice>) archive.fail();
    }
}

${parts.map(struct).join('\n')}
${kEnd}`;

/** The messages of one side. */
const sideHeader = (side, entries) => `${kHeader}#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "${kFolder}/protocol_parts.h"

namespace muster::protocol {

${entries.map(struct).join('\n')}
/// Any message of the ${side === 'Client' ? 'page' : 'server'}; the index is its number.
using ${side}Message = std::variant<
${wrapped(entries.map(({ name }) => name))}>;

${kEnd}`;

const nameSource = () => {
  const names = (entries) => wrapped(entries.map(({ name }) => `"${name}"`));
  return `${kBegin}#include <array>

#include "studio/session/inbox/protocol.h"

namespace muster::protocol {
namespace {

constexpr std::array kClientNames{
${names(page)}};
constexpr std::array kServerNames{
${names(server)}};
static_assert(kClientNames.size() == std::variant_size_v<ClientMessage>);
static_assert(kServerNames.size() == std::variant_size_v<ServerMessage>);

}  // namespace

const char* messageName(const ClientMessage& message) { return kClientNames[message.index()]; }

const char* messageName(const ServerMessage& message) { return kServerNames[message.index()]; }

${kEnd}`;
};

export const messageCppFiles = () => ({
  [`src/${kFolder}/protocol_parts.h`]: partHeader(),
  [`src/${kFolder}/protocol_client.h`]: sideHeader('Client', page),
  [`src/${kFolder}/protocol_server.h`]: sideHeader('Server', server),
  [`src/${kFolder}/message_names.cpp`]: nameSource(),
});
