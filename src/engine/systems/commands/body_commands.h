// Characters that are moved from outside.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Stops all that are moved from outside: who is not written in a step stands.
void restOutside(WorldState& state);

}  // namespace muster
