// What a snapshot must satisfy before a world goes on from it.
#pragma once

#include "engine/state/world_state.h"
#include "muster/status.h"

namespace muster {

/// Fails with InvalidArgument where state that was read contradicts itself or holds a number out of its
/// range. Brings the lists of members up to date.
Status checkState(WorldState& state);

}  // namespace muster
