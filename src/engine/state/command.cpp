#include "muster/command.h"

#include <algorithm>
#include <array>

#include "base/emplace_index.h"
#include "engine/state/command_archive.h"
#include "engine/state/generated/command_numbers.h"

namespace muster {
namespace {

/// Index of the kind that takes call by that number; none where it is not among them.
template <std::size_t N>
std::optional<std::size_t> indexOfNumber(const std::array<std::uint8_t, N>& numbers, std::uint8_t number) {
    const auto at = std::find(numbers.begin(), numbers.end(), number);
    if (at == numbers.end()) return std::nullopt;
    return static_cast<std::size_t>(at - numbers.begin());
}

/// Reads the body of that number; false where no command has it.
bool readBody(Reader& reader, std::uint8_t number, CommandBody& body) {
    const auto read = [&](auto& kind) { reader(kind); };
    if (const auto index = indexOfNumber(kCommandNumbers, number)) {
        emplaceIndex<CommandKinds>(body, *index);
        std::visit(read, body);
        return true;
    }
    const auto index = indexOfNumber(kFormerNumbers, number);
    if (!index) return false;
    FormerKinds kind;
    emplaceIndex(kind, *index);
    std::visit(read, kind);
    body = std::visit([](const auto& old) { return converted(old); }, kind);
    return true;
}

}  // namespace

void encodeBody(Writer& writer, const CommandBody& body) {
    std::uint8_t number = kCommandNumbers[body.index()];
    writer(number);
    std::visit([&](const auto& fields) { writer(fields); }, body);
}

Result<CommandBody> decodeBody(Reader& reader) {
    Command command;
    std::uint8_t number = 0;
    reader(number);
    if (!reader.ok()) return Status(StatusCode::ParseError, "command is cut short");
    if (!readBody(reader, number, command.body))
        return Status(StatusCode::ParseError, "command kind " + std::to_string(number) + " is not known");
    if (!reader.ok())
        return Status(StatusCode::ParseError, std::string(commandName(command)) + " command is cut short");
    return std::move(command.body);
}

void encodeCommand(Writer& writer, const Command& command) {
    writer(command.step, command.client, command.sequence);
    encodeBody(writer, command.body);
}

void encodeForHash(Writer& writer, const Command& command) {
    const std::optional<FormerKinds> former = formerOf(command.body);
    if (!former) return encodeCommand(writer, command);
    std::uint8_t number = kFormerNumbers[former->index()];
    writer(command.step, command.client, command.sequence, number);
    std::visit([&](const auto& fields) { writer(fields); }, *former);
}

Result<Command> decodeCommand(Reader& reader) {
    Command command;
    reader(command.step, command.client, command.sequence);
    Result<CommandBody> body = decodeBody(reader);
    if (!body.ok()) return body.status();
    command.body = std::move(body).value();
    const Status valid = validateCommand(command);
    if (!valid.ok()) return Status(StatusCode::ParseError, valid.message());
    return command;
}

CommandBody::CommandBody(const CommandBody& other) = default;
CommandBody::CommandBody(CommandBody&& other) noexcept = default;
CommandBody& CommandBody::operator=(const CommandBody& other) = default;
CommandBody& CommandBody::operator=(CommandBody&& other) noexcept = default;
CommandBody::~CommandBody() = default;

const Touch* touchOf(const CommandBody& body, TouchPhase phase) {
    const auto* touch = std::get_if<Touch>(&body);
    return touch != nullptr && touch->phase == phase ? touch : nullptr;
}

Touch* touchOf(CommandBody& body, TouchPhase phase) {
    auto* touch = std::get_if<Touch>(&body);
    return touch != nullptr && touch->phase == phase ? touch : nullptr;
}

std::vector<std::uint8_t> encodeCommand(const Command& command) {
    Writer writer;
    encodeCommand(writer, command);
    return writer.take();
}

Result<Command> decodeCommand(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    Result<Command> command = decodeCommand(reader);
    if (command.ok() && reader.remaining() > 0)
        return Status(StatusCode::ParseError, "command is followed by other bytes");
    return command;
}

}  // namespace muster
