// Lists of commands that a C program reads.
#pragma once

#include <vector>

#include "bindings/c/c_world/command_fields.h"
#include "bindings/c/c_world/handle_table.h"

namespace muster::c_api {

/// Commands of the engine, and the same for C.
struct CommandList {
    explicit CommandList(std::vector<Command> list) : commands(std::move(list)) {
        written = writeAll<MusterCommand>(commands, arena, count);
    }

    std::vector<Command> commands;
    Arena arena;
    const MusterCommand* written = nullptr;
    std::int32_t count = 0;
};

/// Takes a list and gives its handle.
MusterCommandListId addCommandList(std::vector<Command> commands);

}  // namespace muster::c_api
