// Commands that change exits, sources and waiting areas.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Adds an area; a source sends people to a group.
void addArea(WorldState& state, const AreaDef& def, GroupId group);
/// Fails where there is no area or group of that id, or there are 1,000 areas.
Status putArea(WorldState& state, const PutArea& put);
Status removeArea(WorldState& state, const RemoveArea& remove);  ///< Fails where there is none.

}  // namespace muster
