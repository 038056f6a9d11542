#include "engine/systems/mesh/mesh_stages.h"

#include <algorithm>

#include "engine/state/bare_groups.h"
#include "engine/state/held_ground.h"

namespace muster {

void advanceControls(WorldState& state) {
    const Parameters& parameters = state.parameters;
    for (Group& group : state.groups) {
        const double pace = parameters.opposing.enabled
                                ? std::max(0.0, 1.0 - parameters.opposing.gain * group.meanLag)
                                : 1.0;
        group.controls.advance(parameters.input, parameters.control, parameters.stepTime, state.time(), pace);
    }
}

void deformUserMeshes(WorldState& state) {
    const Parameters& parameters = state.parameters;
    for (Group& group : state.groups) {
        if (isBare(group) && group.controls.controls().empty()) continue;
        const Status status = group.mesh.deform(parameters.mesh, parameters.control, group.controls,
                                                parameters.stepTime);
        MUSTER_ASSERT(status.ok());
        (void)status;
    }
}

void deformFinalMeshes(WorldState& state) {
    const Parameters& parameters = state.parameters;
    for (Group& group : state.groups) {
        if (isBare(group) && group.controls.controls().empty()) continue;
        // The mesh of a group that holds its ground keeps its displacement.
        if (holdsGround(group) && group.controls.controls().empty())
            group.mesh.keepDisplacement();
        else
            group.mesh.applyEnvironment(parameters.field, state.environment, parameters.stepTime);
    }
}

}  // namespace muster
