#include "world/stages/place_stage.h"

#include <algorithm>

#include "world/state/layer_defs.h"

namespace muster {

void PlaceStage::run(WorldState& state, ThreadPool& pool) {
    const PlaceDef def = placeDef(state.parameters);
    for (Group& group : state.groups) {
        group.mesh.placePositions(targets_);
        group.region = mainRegion(state, group, regionCounts_);
        const auto isUsed = [](std::int32_t count) { return count > 0; };
        group.split = std::count_if(regionCounts_.begin(), regionCounts_.end(), isUsed) > 1;
        group.places.advance(def, targets_, state.environment, group.region, state.parameters.stepTime,
                             &pool);
    }
}

}  // namespace muster
