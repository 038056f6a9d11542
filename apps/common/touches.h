// The touches of a run: those of a file, or those that its scenario carries.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "muster/command.h"
#include "muster/status.h"
#include "muster/world.h"

namespace muster {

/// The options --gestures and --demo.
struct Touches {
    std::string gestures;  ///< Path of a gestures file; empty for none.
    bool demo = false;     ///< Uses the touches that the scenario carries.

    /// Adds the options to a command.
    void addTo(Subcommand& command);
    /// The path of the gestures file; empty for none. Fails where --demo is set and the scenario carries
    /// none.
    Result<std::string> file(const std::string& scenarioPath, const WorldDef& def) const;
    /// The touches, for a world of that definition. Fails like file() and loadGestures().
    Result<std::vector<Command>> load(const std::string& scenarioPath, const WorldDef& def) const;
};

}  // namespace muster
