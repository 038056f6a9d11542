// A battle: two sides of many groups with all that a strategy game asks of them, and how everybody fared.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster::scale {

/// How a battle is measured.
struct BattleDef {
    std::int32_t groups = 20;     ///< Of both sides together, 30 to 60 characters each; 2 to 200.
    std::int32_t obstacles = 60;  ///< Blocks and discs of 3 to 12 m on the ground, 0 to 5,000.
    double side = 200.0;          ///< Of the ground [m], 100 to 4,000.
    double seconds = 60.0;        ///< World time, before all are ordered to stop [s], 1 to 3,600.
    std::uint64_t seed = 1;       ///< Of everything.
};

/// What came of it. Times are CPU times of the thread, of all steps but the first.
struct BattleRow {
    std::int32_t characters = 0;  ///< At the beginning.
    std::int32_t orders = 0;      ///< Commands that direct a group, and edits of groups.
    double first = 0.0;           ///< The first step [ms].
    double p50 = 0.0;             ///< Median [ms].
    double p95 = 0.0;             ///< 95th percentile [ms].
    double worst = 0.0;           ///< The slowest step [ms].
    std::string worstStages;      ///< Stages of that step that took 0.5 ms and more.
    std::string meanStages;  ///< Stages of all steps but the first that took 0.03 ms and more in the mean.
    std::vector<double> minutes;  ///< Median of each minute [ms].
    double growth = 0.0;          ///< Memory in use at the end over that after the first minute [MB].
    double changes = 0.0;         ///< Changes of place of a character per order to its group, in the mean.
    std::int32_t stuck = 0;       ///< Who stood 10 s away from its place and no event said so.
    double overlap = 0.0;         ///< Deepest share of a radius sum, but for 2 s after a building was put up.
    double speed = 0.0;           ///< Highest speed over one's own top speed.
    double restP50 = 0.0;         ///< Median of the steps after the stop [ms].
    std::int32_t outOfPlace = 0;  ///< Who is more than 0.5 m from its place 20 s after the stop.
    double farthest = 0.0;        ///< The farthest of them [m].
    std::uint64_t hash = 0;       ///< Of the last state.
};

/// Plays the battle with one thread. Fails where the world is refused.
Result<BattleRow> measureBattle(const BattleDef& def);
/// The row in words.
std::string battleText(const BattleDef& def, const BattleRow& row);

}  // namespace muster::scale
