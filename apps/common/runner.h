// Runs a world to its end with outputs.
#pragma once

#include <string>
#include <vector>

#include "engine/world/metrics.h"
#include "engine/world/standings.h"
#include "muster/status.h"

namespace muster {

/// Options of a run.
struct RunDef {
    /// Simulated time [s]; negative ends when all characters have arrived and stand or have left, after at
    /// most `longest`.
    double seconds = -1.0;
    double longest = 120.0;      ///< Time limit after the last command [s].
    std::int32_t threads = 1;    ///< As in World::create.
    std::string takePath;        ///< Output path of the take; empty for none.
    std::string trajectoryPath;  ///< Output path of the CSV; empty for none.
    std::int32_t every = 1;      ///< Steps from one row of a character in the CSV to the next.
    /// Whether the path ratio is reported; it needs a cost field per character.
    bool pathRatio = true;
    std::string label;  ///< Shown with the progress.
};

/// How a run went.
struct RunOutcome {
    /// How the people of one group stand at the end.
    struct GroupStandings {
        std::string name;
        StandingCounts counts{};
    };

    RunFigures figures;                     ///< Its results.
    bool cutOff = false;                    ///< It ended after `longest`, with something left to do.
    std::vector<GroupStandings> standings;  ///< Of each group.
};

/// Simulates a new world of that definition and reports the results. Commands are submitted before the first
/// step.
Result<RunOutcome> runWorld(World world, const WorldDef& def, const std::vector<Command>& commands,
                            const RunDef& run);

}  // namespace muster
