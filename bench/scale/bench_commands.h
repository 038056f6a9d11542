// What single commands of orders and units cost above a plain step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster::scale {

/// How the commands are measured: a crowd that is under way among discs gets one after the other.
struct CommandsDef {
    std::int32_t count = 360;      ///< Characters, 16 to 20,000.
    std::int32_t obstacles = 100;  ///< Discs strewn over the ground, 0 or more.
    double side = 200.0;           ///< Of the ground [m].
    std::int32_t rounds = 6;       ///< How often each kind of command is given, 1 to 100.
    std::int32_t runs = 5;         ///< Equal runs; the time of a step is its least over them, 1 to 50.
    bool formations = false;       ///< True: further orders ask for narrow and wide formations by turns.
    bool free = false;             ///< True: each walks by the shortest way; false: the formation marches.
};

/// What one kind of command costs: the largest of the steps from the command on, for a quarter of a second,
/// above the median of the steps before it.
struct CommandRow {
    std::string name;     ///< "move", "split", "merge", "death", "join"...
    double median = 0.0;  ///< Over the rounds [ms].
    double worst = 0.0;   ///< Over the rounds [ms].
    double first = 0.0;   ///< The worst of the steps with the command alone [ms].
    std::string stages;   ///< Stages of one such step that took 0.2 ms and more.
};

/// Runs the case. Fails where the world is refused, a command is rejected, or runs differ.
Result<std::vector<CommandRow>> measureCommands(const CommandsDef& def);
/// The rows as text.
std::string commandsText(const CommandsDef& def, const std::vector<CommandRow>& rows);

}  // namespace muster::scale
