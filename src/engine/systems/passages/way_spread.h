// Use of a passage's width by its crossers.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/state/world_state.h"

namespace muster {

/// Spreads crossers side by side, in the order in which they stand, about the point where the straight lines
/// to their goals cross the passage.
class WaySpread {
public:
    /// Writes ChosenWay::share of the `crossers` that take a way.
    void spread(WorldState& state, std::span<const std::int32_t> crossers, std::int32_t way);

private:
    /// Mean begin and end of the crossers of a passage.
    struct Approach {
        Vec2 from, to;  // [m]
        // Point at which the straight lines between them cross the passage, as a share of its width.
        double share = 0.0;
    };

    Approach gather(const WorldState& state, std::span<const std::int32_t> crossers, std::int32_t way);
    double usedShare(const WorldState& state, const Passage& passage, const Approach& approach);

    // Direction in which each crosser stands, and its index.
    std::vector<std::pair<double, std::int32_t>> order_;
    std::vector<double> approaching_;  // Times of the crossers to the passage [s].
};

}  // namespace muster
