// The caches that outlive a rewind.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Takes over from `later` what is still true of `earlier`, which was just read: the rasters of the ground,
/// the factorised systems of meshes, and the solved fields of plans. No background work may be running;
/// `later` becomes useless.
void keepCaches(WorldState& earlier, WorldState& later);

}  // namespace muster
