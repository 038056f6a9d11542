// Groups that are led to one spot settle side by side: places of one are not places of another.
#pragma once

#include <vector>

#include "engine/formation/places/target_shift.h"
#include "engine/state/world_state.h"

namespace muster {

/// Shifts the targets of groups that rest on the spot of others.
class GroupSpacing {
public:
    /// Updates how group `index` settles and shifts its `targets` [m], which are those of its mesh. Groups
    /// come in ascending order in each step; the first at a spot stays, the others settle beside it.
    void settle(WorldState& state, std::size_t index, std::vector<Vec2>& targets);

private:
    Vec2 findShift(const WorldState& state, std::size_t index, const std::vector<Vec2>& targets);

    TargetShift shift_;
    std::vector<std::vector<Vec2>> settled_;  // Targets of the groups of this step [m].
};

}  // namespace muster
