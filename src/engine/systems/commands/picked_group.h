// The group that a finger picks where it comes down.
#pragma once

#include <optional>

#include "engine/state/world_state.h"

namespace muster {

/// Index of the group whose final mesh lies nearest to the point [m] within `input.reach`, ties to the lower
/// id; none where no mesh is that near.
std::optional<std::size_t> pickedGroup(const WorldState& state, Vec2 p);

}  // namespace muster
