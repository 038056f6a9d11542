// The stages of places: they travel towards their points on the final meshes (SPEC M5).
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "engine/systems/places/body_room.h"

namespace muster {

/// Brings the routes of all classes of ground in use up to date.
void refreshRoutes(WorldState& state);

/// Moves the places of all groups. Its functions are called once in each step, in this order.
class PlaceStage {
public:
    /// Reads the targets of places from the final meshes.
    void readTargets(const WorldState& state);
    /// Moves targets apart where large bodies need room.
    void makeRoom(WorldState& state);
    /// Counts for how many steps the targets of each group have rested.
    void watchRest(WorldState& state) const;
    /// Writes the region of each group, and whether it stands in several.
    void findRegions(WorldState& state);
    /// Moves places towards their targets, over ground that their group can reach.
    void advance(WorldState& state, ThreadPool& pool);

private:
    BodyRoom room_;
    std::vector<std::vector<Vec2>> targets_;  // Targets of each group's places [m].
    std::vector<std::int32_t> regionCounts_;  // Members of one group by region.
};

}  // namespace muster
