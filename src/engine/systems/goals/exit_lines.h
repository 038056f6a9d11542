// Lines before exits: people stand in the order in which they came, spaced by their bodies
// (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/world_state.h"
#include "engine/systems/goals/goal_fields.h"

namespace muster {

/// Finds where each person stands who goes to an exit with a line.
class ExitLines {
public:
    /// Drops people who have gone from the lines, and adds those who have come to their ends.
    void run(WorldState& state, GoalFields& fields, std::span<const std::int32_t> groundClasses);
    /// The next act of a person who goes to an exit with a line.
    enum class Duty : std::uint8_t {
        Free,   ///< There is no line, or the person is the first in it: it goes to the exit.
        Join,   ///< It goes to the end of the line.
        Stand,  ///< It stands in the line.
    };
    /// True where an exit has a line.
    bool any() const { return !duty_.empty(); }
    Duty dutyOf(std::size_t i) const { return duty_.empty() ? Duty::Free : duty_[i]; }
    /// The spot of a person in the line, or the end of the line [m].
    Vec2 spotOf(std::size_t i) const { return spot_[i]; }

private:
    bool keep(WorldState& state, Area& area);
    void layOut(const WorldState& state, const Area& area);
    void join(WorldState& state, Area& area, GoalFields& fields, std::span<const std::int32_t> groundClasses);

    std::vector<Duty> duty_;  // By character; empty where no exit has a line.
    std::vector<Vec2> spot_;
    Vec2 end_;  // End of the line at hand.
};

}  // namespace muster
