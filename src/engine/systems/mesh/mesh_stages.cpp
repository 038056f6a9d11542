#include "engine/systems/mesh/mesh_stages.h"

#include <algorithm>

#include "engine/state/layer_defs.h"

namespace muster {

void advanceControls(WorldState& state) {
    const Parameters& parameters = state.parameters;
    const ControlDef def = controlDef(parameters);
    for (Group& group : state.groups) {
        const double pace = parameters.opposing.enabled
                                ? std::max(0.0, 1.0 - parameters.opposing.gain * group.meanLag)
                                : 1.0;
        group.controls.advance(def, parameters.stepTime, state.time(), pace);
    }
}

void deformUserMeshes(WorldState& state) {
    const FormationMeshDef def = meshDef(state.parameters);
    const ControlDef controls = controlDef(state.parameters);
    for (Group& group : state.groups) {
        const Status status = group.mesh.deform(def, controls, group.controls, state.parameters.stepTime);
        MUSTER_ASSERT(status.ok());
        (void)status;
    }
}

void deformFinalMeshes(WorldState& state) {
    const FormationMeshDef def = meshDef(state.parameters);
    for (Group& group : state.groups)
        group.mesh.applyEnvironment(def, state.environment, state.parameters.stepTime);
}

}  // namespace muster
