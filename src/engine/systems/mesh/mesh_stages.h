// The stages of controls and meshes (paper sections 4 and 5). They need no memory of their own.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Moves control points along their trajectories; the opposing force slows them where the crowd falls behind
/// (SPEC U6).
void advanceControls(WorldState& state);
/// Computes Vu of every group from its controls.
void deformUserMeshes(WorldState& state);
/// Computes Vf of every group from Vu and the environment.
void deformFinalMeshes(WorldState& state);

}  // namespace muster
