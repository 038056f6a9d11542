// The passages before which many wait, as plans know them: the way of each character, and its cost.
#pragma once

#include <cstdint>
#include <span>

#include "base/infinite_cost.h"

namespace muster {

/// Ways of one group's characters. A way leads through one passage from one side. No character has a way
/// where nobody has to wait.
struct PlannedWays {
    /// Way of each character, -1 for none; empty where no character has one.
    std::span<const std::int32_t> way;
    std::span<const float> reach;  ///< Cost of each character until it is let through [m], with waits.
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
