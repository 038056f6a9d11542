// Lines before exits: who stands in which place of the line, spaced by their bodies, in the order in which
// they came (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/world_state.h"
#include "engine/systems/goals/goal_fields.h"

namespace muster {

/// Finds for all who go to exits with a line where they stand in it.
class ExitLines {
public:
    /// Drops those from the lines who have gone, and lets those join who have come to the ends.
    void run(WorldState& state, GoalFields& fields, std::span<const std::int32_t> groundClasses);
    /// What somebody who goes to an exit with a line has to do.
    enum class Duty : std::uint8_t {
        Free,   ///< There is no line, or it is the first in it: it goes to the exit.
        Join,   ///< It goes to the end of the line.
        Stand,  ///< It stands in the line.
    };
    /// True where an exit has a line.
    bool any() const { return !duty_.empty(); }
    Duty dutyOf(std::size_t i) const { return duty_.empty() ? Duty::Free : duty_[i]; }
    /// Where somebody stands in the line, or its end [m].
    Vec2 spotOf(std::size_t i) const { return spot_[i]; }

private:
    bool keep(WorldState& state, Area& area);
    void layOut(const WorldState& state, const Area& area);
    void join(WorldState& state, Area& area, GoalFields& fields, std::span<const std::int32_t> groundClasses);

    std::vector<Duty> duty_;  // Of all characters; empty where no exit has a line.
    std::vector<Vec2> spot_;
    Vec2 end_;  // Of the line at hand.
};

}  // namespace muster
