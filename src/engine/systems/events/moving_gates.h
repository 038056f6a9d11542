// Whose way moving obstacles cut off, as a gate that closes does (SPEC B16).
#pragma once

#include <vector>

#include "engine/ground/routes/moving_regions.h"
#include "engine/state/world_state.h"
#include "muster/event.h"

namespace muster {

/// Raises Blocked where moving obstacles leave some of a group no way, and Free once all have one again. What
/// only passes is not reported: both are raised once they have been true for a while.
class MovingGates {
public:
    /// Looks at all groups that follow an order; from time to time, and only where somebody has to wait.
    void raise(WorldState& state, std::vector<Event>& events);

private:
    void judge(WorldState& state, Group& group, std::vector<Event>& events);

    MovingRegions regions_;
    bool updated_ = false;  // The regions are those of this step.
};

}  // namespace muster
