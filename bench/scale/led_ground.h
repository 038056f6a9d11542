// A large group that is led through a large map from one end to the other: whether it arrives, and what a
// step costs meanwhile.
#pragma once

#include <array>
#include <string>

#include "muster/world.h"
#include "scale/large_ground.h"

namespace muster::scale {

/// How the group is led.
struct LedGroundDef {
    LargeGroundDef ground;    ///< The map, and the size of the group.
    double stride = 10.0;     ///< Between two poses along the route [m]; 0 for one order to its end.
    double speed = 1.5;       ///< At which poses follow each other [m/s], above 0.
    double length = 1e9;      ///< Of the route, at most [m].
    double seconds = 3600.0;  ///< World time, at most [s].
};

/// What was measured: CPU times of the thread [ms].
struct LedGroundRow {
    double route = 0.0;       ///< Length of the way from end to end [m].
    double led = 0.0;         ///< Time of the last pose [s]; negative where it was not reached.
    double arrived = 0.0;     ///< Time when all stood at their places [s]; negative where they did not.
    std::size_t missing = 0;  ///< Characters that are not at their places at the end.
    double p50 = 0.0, p95 = 0.0, p99 = 0.0, most = 0.0;
    std::array<double, kStageCount> stages{};  ///< Mean wall time of each [ms].
    std::int64_t swaps = 0;                    ///< Changes of places.
    double memory = 0.0;                       ///< Peak [MB].
    std::uint64_t hash = 0;                    ///< Of the world at the end.
};

/// Leads the group along the shortest way between the two ends of the map's largest region. Fails where the
/// world cannot be made.
Result<LedGroundRow> runLedGround(const LedGroundDef& def);
/// The row in words.
std::string ledGroundText(const LedGroundRow& row);

}  // namespace muster::scale
