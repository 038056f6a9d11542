// Which touches a world is given: those of a file, or those that its scenario carries.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "muster/command.h"
#include "muster/status.h"
#include "muster/world_def.h"

namespace muster {

/// --gestures and --demo.
struct Touches {
    std::string gestures;  ///< File; empty for none.
    bool demo = false;     ///< The scenario's own.

    /// Adds the options to a command.
    void addTo(Subcommand& command);
    /// The file that they come from, empty for none. Fails where the scenario should carry some and carries
    /// none.
    Result<std::string> file(const std::string& scenarioPath, const WorldDef& def) const;
    /// The touches, for a world of that definition. Fails as file() and loadGestures() do.
    Result<std::vector<Command>> load(const std::string& scenarioPath, const WorldDef& def) const;
};

}  // namespace muster
