// What plans know of passages before which many wait: who goes through which one, and what that costs.
#pragma once

#include <cstdint>
#include <span>

#include "base/infinite_cost.h"

namespace muster {

/// Ways of one group's characters. A way leads through one passage from one side. Nobody has one where nobody
/// has to wait.
struct PlannedWays {
    std::span<const std::int32_t> way;  ///< Of each character, -1 for none; empty where nobody has one.
    std::span<const float> reach;  ///< Of each character: cost until it is let through [m], waits counted.
    /// Cost from a passage to each place [m], places of way 0 first; infinite for places on the side from
    /// which the way comes.
    std::span<const float> onward;

    /// Cost of a character's way to a place; infinite where it needs none.
    double cost(std::size_t character, std::size_t place, std::size_t places) const {
        if (way.empty() || way[character] < 0) return kInfiniteCost;
        return static_cast<double>(reach[character] +
                                   onward[static_cast<std::size_t>(way[character]) * places + place]);
    }
};

}  // namespace muster
