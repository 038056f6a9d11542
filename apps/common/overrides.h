// Parameter changes from the command line.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "muster/world_def.h"

namespace muster {

/// The options --plan, --preset and --set.
struct Overrides {
    std::string plan;
    std::string preset;
    std::vector<std::string> settings;  ///< In the form "name=value".

    /// Adds the options to a command.
    void addTo(Subcommand& command);
    /// Applies preset, then plan, then settings. A preset sets only what usePreset() does.
    /// Fails naming the option; it also fails where the final parameters contradict each other.
    Status apply(WorldDef& def) const;
};

}  // namespace muster
