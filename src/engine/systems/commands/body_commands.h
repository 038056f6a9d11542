// Characters that are moved from outside.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Stops all characters that are moved from outside: such a character stands unless a step writes its motion.
void restOutside(WorldState& state);

}  // namespace muster
