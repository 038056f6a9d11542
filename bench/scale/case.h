// One case of the benchmark: its definition and its results.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "muster/status.h"
#include "muster/world.h"
#include "scale/crowd_scenes.h"

namespace muster::scale {

/// Definition of a case.
struct CaseDef {
    SceneDef scene;              ///< Scene and size.
    std::string plan = "exact";  ///< Solver of plans: "exact" or "fast".
    std::int32_t threads = 1;    ///< Threads of the world.
    double seconds = 0.0;        ///< Largest world time [s]; 0 for that of the scene.
};

/// Results of a quality pass.
struct Quality {
    std::string judge = "none";  ///< Method: "exact", "bound" or "none".
    std::int32_t looks = 0;      ///< Number of judgements without that of the first plan.
    /// Gap of the first plan, judged after the second step [%]; -1 where it was not judged.
    double gapCold = -1.0;
    double gapMean = 0.0;        ///< Mean gap [%].
    double gapMax = 0.0;         ///< Largest gap [%].
    double objectiveMean = 0.0;  ///< Mean objective of the committed plans, per character [cost^p].
};

/// One row of the table.
struct Row {
    CaseDef def;             ///< The case.
    std::int32_t steps = 0;  ///< Number of timed steps, without the first.
    double p50 = 0.0;        ///< Median step [ms]: CPU time with one thread, else wall time.
    double p95 = 0.0;        ///< 95th percentile [ms].
    double max = 0.0;        ///< Longest step [ms].
    double cold = 0.0;       ///< The first step, which makes the first plan [ms].
    double wallP95 = 0.0;    ///< 95th percentile of wall time [ms].
    std::array<double, kStageCount> stages{};  ///< Mean wall time [ms].
    double swaps = 0.0;                        ///< Changes of place per character and second.
    double lagMean = 0.0;           ///< Distance of characters to their places, mean of all steps [m].
    double arrived = 1.0;           ///< Share within 0.5 m of its place at the end.
    std::int64_t allocations = -1;  ///< Allocations in steps after warm-up; -1 where not counted.
    double memory = 0.0;            ///< Peak resident memory of the process [MB].
    std::uint64_t hash = 0;         ///< Hash of the final state.
    Quality quality;                ///< Results of the quality pass.
    double exactRatio = 0.0;        ///< p50 with the exact plan over this p50; 0 where it was not run.
};

/// Called after every step; its time is not measured.
using Observer = std::function<void(const World&)>;

/// Makes the case's world. Fails with one sentence where the scene, plan or limits do not allow it.
Result<World> makeWorld(const CaseDef& def, const Scene& scene);

/// Runs the case and times its steps; `observer` may be empty. Fails where the world cannot be made.
Result<Row> runCase(const CaseDef& def, const Observer& observer = {});

}  // namespace muster::scale
