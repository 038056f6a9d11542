#include "engine/systems/places/place_stage.h"

#include <algorithm>

#include "engine/state/ground_class.h"
#include "engine/state/layer_defs.h"

namespace muster {

void PlaceStage::run(WorldState& state, ThreadPool& pool) {
    const PlaceDef usual = placeDef(state.parameters);
    state.refreshRoutes();
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        Group& group = state.groups[g];
        RouteGraph& routes = state.refreshRoutes(group.groundClass);
        const PlaceDef def = placeDefOf(state, group, usual);
        group.mesh.placePositions(targets_);
        room_.run(state, group, targets_);
        spacing_.settle(state, g, targets_);
        group.region = mainRegion(state, group, regionCounts_);
        const auto isUsed = [](std::int32_t count) { return count > 0; };
        group.split = std::count_if(regionCounts_.begin(), regionCounts_.end(), isUsed) > 1;
        group.places.advance(def, targets_, routes, group.region, state.parameters.stepTime, &pool);
    }
}

}  // namespace muster
