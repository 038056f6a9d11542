// Obstacles whose paths are over: an obstacle that will never move again is ground like any other.
#pragma once

#include "base/parallel.h"
#include "engine/state/world_state.h"

namespace muster {

/// Puts the obstacles whose paths are over on the ground where they stand, as edits of the ground: routes
/// lead round them from now on, and groups that have no other route hear of it.
void settleEndedPaths(WorldState& state, ThreadPool& pool);

}  // namespace muster
