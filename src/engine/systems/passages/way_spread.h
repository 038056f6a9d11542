// How those who share a passage use its width.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/state/world_state.h"

namespace muster {

/// They go side by side, in the order in which they stand, and about where the straight lines to their goals
/// cross the passage.
class WaySpread {
public:
    /// Writes ChosenWay::share of those among `crossers` who take a way.
    void spread(WorldState& state, std::span<const std::int32_t> crossers, std::int32_t way);

private:
    /// Where those who share a passage come from and go to, in the mean.
    struct Approach {
        Vec2 from, to;       // [m]
        double share = 0.0;  // Where the straight lines between them cross the passage.
    };

    Approach gather(const WorldState& state, std::span<const std::int32_t> crossers, std::int32_t way);
    double usedShare(const WorldState& state, const Passage& passage, const Approach& approach);

    std::vector<std::pair<double, std::int32_t>> order_;  // Where they stand, and who.
    std::vector<double> approaching_;                     // Times to the passage [s].
};

}  // namespace muster
