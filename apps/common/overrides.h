// Parameter changes from the command line.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "muster/world.h"

namespace muster {

/// The options --plan, --preset, --set and --seed.
struct Overrides {
    std::string plan;
    std::string preset;
    std::vector<std::string> settings;  ///< In the form "name=value".
    double seed = -1.0;                 ///< Of all random numbers; below 0 for that of the definition.

    /// Adds the options to a command.
    void addTo(Subcommand& command);
    /// Applies seed, preset, then plan, then settings. A preset sets only what usePreset() does.
    /// Fails naming the option; it also fails where the final parameters contradict each other.
    Status apply(WorldDef& def) const;
};

}  // namespace muster
