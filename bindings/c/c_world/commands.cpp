// Commands: names, checks, bytes, lists.
#include "bindings/c/c_world/command_list.h"

namespace muster::c_api {
namespace {

using CommandLists = HandleTable<MusterCommandListId, CommandList>;

CommandLists& commandLists() {
    static CommandLists& table = *new CommandLists("command list");
    return table;
}

template <std::size_t... I>
auto commandDefaults(std::index_sequence<I...>) {
    static const auto& values = *new std::array<Command, sizeof...(I)>{
        Command{0, 0, 0, CommandBody(std::in_place_index<I>)}...};
    return std::span(values);
}

/// The engine's default command of every kind.
std::span<const Command> everyCommand() {
    return commandDefaults(std::make_index_sequence<MUSTER_COMMAND_COUNT>());
}

bool isCommandKind(MusterCommandKind kind) {
    return kind >= 0 && kind < MUSTER_COMMAND_COUNT;
}

}  // namespace

MusterCommandListId addCommandList(std::vector<Command> commands) {
    return commandLists().add(std::make_unique<CommandList>(std::move(commands)));
}

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterCommand muster_default_command(MusterCommandKind kind) {
    static Arena& arena = *new Arena;
    static const MusterCommand* const made = [] {
        std::int32_t count = 0;
        return writeAll<MusterCommand>(everyCommand(), arena, count);
    }();
    return made[isCommandKind(kind) ? kind : 0];
}

const char* muster_command_name(MusterCommandKind kind) {
    return isCommandKind(kind) ? commandName(everyCommand()[static_cast<std::size_t>(kind)]) : nullptr;
}

MusterStatus muster_command_validate(const MusterCommand* command) {
    return call([&]() -> Status {
        Command read;
        const Status fits = readC(command, read, "command");
        return fits.ok() ? validateCommand(read) : fits;
    });
}

MusterStatus muster_command_encode(const MusterCommand* command, MusterBuffer* outBytes) {
    return call([&]() -> Status {
        if (outBytes == nullptr) return nullArgument("outBytes");
        Command read;
        if (const Status fits = readC(command, read, "command"); !fits.ok()) return fits;
        const std::vector<std::uint8_t> bytes = encodeCommand(read);
        *outBytes = makeBuffer(bytes.data(), bytes.size());
        return {};
    });
}

MusterStatus muster_command_decode(const uint8_t* bytes, size_t size, MusterCommandListId* outList) {
    return call([&]() -> Status {
        if (outList == nullptr) return nullArgument("outList");
        *outList = {0, 0};
        if (bytes == nullptr && size > 0) return nullArgument("bytes");
        Result<Command> command = decodeCommand({bytes, size});
        if (!command.ok()) return command.status();
        *outList = addCommandList({*std::move(command)});
        return {};
    });
}

MusterStatus muster_command_list_get(MusterCommandListId list, const MusterCommand** outCommands,
                                     int32_t* outCount) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"outCommands", "outCount"}, outCommands, outCount);
            !given.ok())
            return given;
        const Result<CommandList*> found = commandLists().find(list);
        if (!found.ok()) return found.status();
        *outCommands = (*found)->written;
        *outCount = (*found)->count;
        return {};
    });
}

MusterStatus muster_command_list_destroy(MusterCommandListId list) {
    return call([&] { return commandLists().destroy(list); });
}
