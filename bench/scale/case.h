// One case of the table: what is run, and what came of it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "muster/status.h"
#include "muster/world.h"
#include "scale/scenes.h"

namespace muster::scale {

/// What is run.
struct CaseDef {
    SceneDef scene;
    std::string plan = "exact";  ///< "exact" or "fast".
    std::int32_t threads = 1;    ///< Of the world.
    double seconds = 0.0;        ///< World time at most [s]; 0 for what the scene is worth.
};

/// Of a quality pass.
struct Quality {
    std::string judge = "none";  ///< "exact", "bound" or "none".
    std::int32_t looks = 0;      ///< Times it was judged, less the first.
    /// Of the first plan, looked at after the second step [%]; -1 where it was not.
    double gapCold = -1.0;
    double gapMean = 0.0;        ///< [%]
    double gapMax = 0.0;         ///< [%]
    double objectiveMean = 0.0;  ///< Of the committed plans, per character [cost^p].
};

/// One row of the table.
struct Row {
    CaseDef def;
    std::int32_t steps = 0;  ///< After the first.
    double p50 = 0.0;        ///< Of a step [ms]: CPU time of the thread where there is one, else wall time.
    double p95 = 0.0;        ///< [ms]
    double max = 0.0;        ///< [ms]
    double cold = 0.0;       ///< The first step, which makes the first plan [ms].
    double wallP95 = 0.0;    ///< By the wall clock [ms].
    std::array<double, static_cast<std::size_t>(Stage::Count)> stages{};  ///< Mean, by the wall clock [ms].
    double swaps = 0.0;                                                   ///< Per character and second.
    double lagMean = 0.0;           ///< Distance of characters to their places, mean of all steps [m].
    double arrived = 1.0;           ///< Share within 0.5 m of its place at the end.
    std::int64_t allocations = -1;  ///< In steps after warm-up; -1 where they are not counted.
    double memory = 0.0;            ///< Peak of the process [MB].
    std::uint64_t hash = 0;         ///< Of the state at the end.
    Quality quality;
    double exactRatio = 0.0;  ///< Of the exact plan's p50 to this p50; 0 where it was not run.
};

/// Called after every step, outside the time taken.
using Observer = std::function<void(const World&)>;

/// Makes the case's world. Fails with one sentence where the scene, plan or limits do not allow it.
Result<World> makeWorld(const CaseDef& def, const Scene& scene);

/// Runs the case and times its steps; `observer` may be empty. Fails where the world cannot be made.
Result<Row> runCase(const CaseDef& def, const Observer& observer = {});

}  // namespace muster::scale
