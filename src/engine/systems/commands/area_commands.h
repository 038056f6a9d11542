// Commands that change exits, sources and waiting areas.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Fails where there is no area or group of that id, or there are 1,000 areas.
Status putArea(WorldState& state, const PutArea& put);
Status removeArea(WorldState& state, const RemoveArea& remove);  ///< Fails where there is none.

}  // namespace muster
