// Lets single characters join a group.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Lets one character join a group at a free point [m]; its index. No background work may be running.
std::int32_t joinOne(WorldState& state, Group& group, Vec2 position, const Body& body);

}  // namespace muster
