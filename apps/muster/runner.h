// Runs a world to its end, with what is to be watched and recorded.
#pragma once

#include <string>
#include <vector>

#include "muster/status.h"
#include "world/metrics.h"

namespace muster {

/// How a run goes.
struct RunDef {
    /// Simulated [s]; negative: until all have arrived and stand, at most `longest`.
    double seconds = -1.0;
    double longest = 120.0;      ///< After the last command [s].
    std::int32_t threads = 1;    ///< As for World::create.
    std::string takePath;        ///< Where the take goes; empty for none.
    std::string trajectoryPath;  ///< Where the CSV goes; empty for none.
    bool pathRatio = true;       ///< Report it: a cost field per character.
    std::string label;           ///< Shown with the progress.
};

/// Simulates a new world of that definition and reports. Commands are submitted before the first step.
Result<RunFigures> runWorld(World world, const WorldDef& def, const std::vector<Command>& commands,
                            const RunDef& run);

}  // namespace muster
