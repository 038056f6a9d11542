// Changes of parameters from the command line.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "muster/world_def.h"

namespace muster {

/// --plan, --preset and --set.
struct Overrides {
    std::string plan;
    std::string preset;
    std::vector<std::string> settings;  ///< "name=value".

    /// Adds the options to a command.
    void addTo(Subcommand& command);
    /// Applies preset, then plan, then settings. Only what the presets differ in is set by one. Fails naming
    /// the culprit, also where the parameters contradict each other at the end.
    Status apply(WorldDef& def) const;
};

}  // namespace muster
