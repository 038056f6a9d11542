#include "muster/command.h"

#include "engine/state/command_archive.h"

namespace muster {
namespace {

/// Makes the alternative with that index; false where there is none.
template <std::size_t Index = 0>
bool emplaceBody(CommandBody& body, std::size_t index) {
    if constexpr (Index < std::variant_size_v<CommandKinds>) {
        if (index != Index) return emplaceBody<Index + 1>(body, index);
        body.emplace<Index>();
        return true;
    } else {
        return false;
    }
}

}  // namespace

void encodeBody(Writer& writer, const CommandBody& body) {
    const auto kind = static_cast<std::uint8_t>(body.index());
    writer(kind);
    std::visit([&](const auto& fields) { writer(fields); }, body);
}

Result<CommandBody> decodeBody(Reader& reader) {
    Command command;
    std::uint8_t kind = 0;
    reader(kind);
    if (!reader.ok()) return Status(StatusCode::ParseError, "command is cut short");
    if (!emplaceBody(command.body, kind))
        return Status(StatusCode::ParseError, "command kind " + std::to_string(kind) + " is not known");
    std::visit([&](auto& fields) { reader(fields); }, command.body);
    if (!reader.ok())
        return Status(StatusCode::ParseError, std::string(commandName(command)) + " command is cut short");
    return std::move(command.body);
}

void encodeCommand(Writer& writer, const Command& command) {
    writer(command.step, command.client, command.sequence);
    encodeBody(writer, command.body);
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
