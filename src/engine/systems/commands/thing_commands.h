// What puts and removes things: obstacles, patches, items, checkpoints and areas.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Adds an area; a source sends people to a group.
void addArea(WorldState& state, const AreaDef& def, GroupId group);

}  // namespace muster
