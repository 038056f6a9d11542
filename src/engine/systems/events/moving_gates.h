// Groups whose route moving obstacles cut off, as a gate that closes does (SPEC B16).
#pragma once

#include <vector>

#include "engine/ground/routes/moving_regions.h"
#include "engine/state/world_state.h"
#include "muster/event.h"

namespace muster {

/// Raises Blocked where moving obstacles leave members of a group no route, and Free once all members have
/// one again. Each is raised only after it has been true for a while, so that a passing obstacle is not
/// reported.
class MovingGates {
public:
    /// Looks at all groups that follow an order; from time to time, and only where a member has to wait.
    void raise(WorldState& state, std::vector<Event>& events);

private:
    void judge(WorldState& state, Group& group, std::vector<Event>& events);

    MovingRegions regions_;
    bool updated_ = false;  // True once the regions are those of this step.
};

}  // namespace muster
