// The stage of places: they travel towards their points on the final meshes (SPEC M5).
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "engine/systems/places/body_room.h"
#include "engine/systems/places/group_spacing.h"

namespace muster {

/// Moves the places of all groups.
class PlaceStage {
public:
    /// Writes places, and the region of each group.
    void run(WorldState& state, ThreadPool& pool);

private:
    BodyRoom room_;
    GroupSpacing spacing_;
    std::vector<Vec2> targets_;               // Points of one group's final mesh [m].
    std::vector<std::int32_t> regionCounts_;  // Members of one group by region.
};

}  // namespace muster
