// The C++ side of the protocol.
import { banner, client, numbers, schema, server, structs } from './schema.mjs';

const cppBanner = `${banner}// clang-format off\n`;

function cppType(field) {
  const item = field.kind === 'number' ? numbers[field.item][0] : field.kind === 'string' ? 'std::string' : field.item;
  return field.array ? `std::vector<${item}>` : item;
}

function cppDefault(field) {
  if (field.array || field.kind === 'string' || field.kind === 'struct') return '';
  if (field.kind === 'bool') return ' = false';
  if (field.kind === 'enum') return ` = ${field.item}::${schema.enums[field.item][0]}`;
  return field.item === 'f32' ? ' = 0.0f' : field.item === 'f64' ? ' = 0.0' : ' = 0';
}

function cppStruct(entry, number) {
  const lines = [`/// ${entry.note}`, `struct ${entry.name} {`];
  if (number) lines.push(`    static constexpr std::uint8_t kNumber = ${entry.number};  ///< First byte of the message.`);
  for (const field of entry.fields) {
    const declaration = `    ${cppType(field)} ${field.name}${cppDefault(field)};`;
    lines.push(field.note ? `${declaration}  ///< ${field.note}` : declaration);
  }
  lines.push('', '    /// Lets an archive read or write the fields.', '    template <class Archive>');
  lines.push('    void visit(Archive& archive) {');
  let call = '        archive(';
  let column = call.length;
  entry.fields.forEach((field, i) => {
    const word = field.name + (i + 1 < entry.fields.length ? ',' : ');');
    if (column + word.length + 1 > 108) {
      call += '\n                ';
      column = 16;
    } else if (i > 0) {
      call += ' ';
      column += 1;
    }
    call += word;
    column += word.length;
  });
  lines.push(call);
  for (const field of entry.fields) {
    if (field.kind === 'enum') lines.push(`        checkEnum(archive, ${field.name}, ${schema.enums[field.item].length});`);
  }
  lines.push('    }', '};', '');
  return lines.join('\n');
}

/** Joins words by commas, on lines of at most 100 characters. */
function wrapped(words, indent) {
  let text = indent;
  let column = indent.length;
  words.forEach((word, i) => {
    const piece = i + 1 < words.length ? `${word}, ` : word;
    if (column + piece.length > 104 && column > indent.length) {
      text = `${text.trimEnd()}\n${indent}`;
      column = indent.length;
    }
    text += piece;
    column += piece.length;
  });
  return text;
}

const begin = `${cppBanner}#pragma once

`;
const end = '}  // namespace muster::protocol\n';

/** Enumerations and the parts that messages consist of. */
function cppParts() {
  let text = `${begin}#include <cstdint>
#include <string>
#include <vector>

namespace muster::protocol {

inline constexpr std::uint32_t kVersion = ${schema.version};                 ///< Raised by any change of a message.
inline constexpr const char* kSubprotocol = "muster.v${schema.version}";  ///< Of the WebSocket.

/// Marks the input as bad where an enumeration read from it has no such value.
template <class Archive, class Enum>
void checkEnum(Archive& archive, Enum value, std::uint8_t count) {
    if constexpr (Archive::kReading) {
        if (static_cast<std::uint8_t>(value) >= count) archive.fail();
    }
}

`;
  for (const [name, values] of Object.entries(schema.enums)) {
    text += `/// Values of a field, as one byte.\nenum class ${name} : std::uint8_t { ${values.join(', ')} };\n`;
  }
  text += '\n';
  for (const entry of structs) text += cppStruct(entry, false) + '\n';
  return text + end;
}

/** The messages of one side. */
function cppMessages(side, entries) {
  let text = `${begin}#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "studio/session/inbox/protocol_parts.h"

namespace muster::protocol {

`;
  for (const entry of entries) text += cppStruct(entry, true) + '\n';
  return `${text}/// Any message of the ${side === 'Client' ? 'page' : 'server'}; the index is its number.
using ${side}Message = std::variant<
${wrapped(entries.map((entry) => entry.name), '    ')}>;

${end}`;
}

/** What encodes and decodes messages. */
function cppHeader() {
  return `${begin}#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.h"
#include "muster/status.h"
#include "studio/session/inbox/protocol_client.h"
#include "studio/session/inbox/protocol_server.h"

namespace muster::protocol {

/// "Touches"... for reports.
const char* messageName(const ClientMessage& message);
/// "Frame"... for reports.
const char* messageName(const ServerMessage& message);

/// Reads a message. Fails with ParseError where the number is unknown, the bytes are short or too many, or a
/// flag or enumeration has no such value.
Result<ClientMessage> decodeClient(std::span<const std::uint8_t> bytes);
/// As decodeClient.
Result<ServerMessage> decodeServer(std::span<const std::uint8_t> bytes);

/// Appends a message's bytes.
template <class Message>
void encode(Writer& writer, const Message& message) {
    const std::uint8_t number = Message::kNumber;
    writer(number, message);
}
/// A message's bytes.
template <class Message>
std::vector<std::uint8_t> encode(const Message& message) {
    Writer writer;
    encode(writer, message);
    return writer.take();
}

${end}`;
}

function cppSource() {
  const names = (all) => wrapped(all.map((entry) => `"${entry.name}"`), '    ');
  const cases = (all) => all.map((entry) => `        case ${entry.number}: return decodeAs<Any, ${entry.name}>(bytes);\n`).join('');
  return `${cppBanner}#include "studio/session/inbox/protocol.h"

#include <iterator>

namespace muster::protocol {
namespace {

constexpr const char* kClientNames[] = {
${names(client)}};
constexpr const char* kServerNames[] = {
${names(server)}};

template <class Any, class Message>
Result<Any> decodeAs(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes.subspan(1));
    Message message;
    reader(message);
    const char* name = messageName(Any(Message{}));
    if (!reader.ok()) return Status(StatusCode::ParseError, std::string(name) + ": short or invalid bytes");
    if (reader.remaining() > 0) {
        return Status(StatusCode::ParseError,
                      std::string(name) + ": " + std::to_string(reader.remaining()) + " bytes too many");
    }
    return Any(std::move(message));
}

Status unknown(std::span<const std::uint8_t> bytes, std::size_t count) {
    if (bytes.empty()) return {StatusCode::ParseError, "An empty message"};
    return {StatusCode::ParseError,
            "Message number " + std::to_string(bytes[0]) + " is unknown, expected 0 to " +
                std::to_string(count - 1)};
}

}  // namespace

const char* messageName(const ClientMessage& message) { return kClientNames[message.index()]; }

const char* messageName(const ServerMessage& message) { return kServerNames[message.index()]; }

Result<ClientMessage> decodeClient(std::span<const std::uint8_t> bytes) {
    using Any = ClientMessage;
    switch (bytes.empty() ? 255 : bytes[0]) {
${cases(client)}        default: return unknown(bytes, std::size(kClientNames));
    }
}

Result<ServerMessage> decodeServer(std::span<const std::uint8_t> bytes) {
    using Any = ServerMessage;
    switch (bytes.empty() ? 255 : bytes[0]) {
${cases(server)}        default: return unknown(bytes, std::size(kServerNames));
    }
}

}  // namespace muster::protocol
`;
}

/** Files by path. */
export function cppFiles() {
  return {
    'src/studio/session/inbox/protocol_parts.h': cppParts(),
    'src/studio/session/inbox/protocol_client.h': cppMessages('Client', client),
    'src/studio/session/inbox/protocol_server.h': cppMessages('Server', server),
    'src/studio/session/inbox/protocol.h': cppHeader(),
    'src/studio/session/inbox/protocol.cpp': cppSource(),
  };
}
