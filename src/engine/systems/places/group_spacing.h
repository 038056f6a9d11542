// Groups that are led to one spot settle side by side: places of one are not places of another.
#pragma once

#include <vector>

#include "engine/formation/places/target_shift.h"
#include "engine/state/world_state.h"

namespace muster {

/// Shifts the targets of groups that rest on the spot of others.
class GroupSpacing {
public:
    /// Updates how all groups settle and shifts their `targets` [m], which are those of their meshes. At one
    /// spot a group that holds its ground stays before all others, else the first; the others settle beside.
    void run(WorldState& state, std::vector<std::vector<Vec2>>& targets);

private:
    void settle(WorldState& state, std::size_t index, std::vector<Vec2>& targets);
    Vec2 findShift(const WorldState& state, std::size_t index, const std::vector<Vec2>& targets);

    TargetShift shift_;
    std::vector<std::size_t> order_;          // Groups, those first that others make room for.
    std::vector<std::vector<Vec2>> settled_;  // Targets of the groups of this step [m].
};

}  // namespace muster
