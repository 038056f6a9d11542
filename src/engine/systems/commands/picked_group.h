// The group that a finger picks where it comes down.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// The group whose final mesh lies nearest to the point [m] within `input.reach`, ties to the lower id; null
/// for none.
const Group* pickedGroup(const WorldState& state, Vec2 p);
inline Group* pickedGroup(WorldState& state, Vec2 p) {
    return const_cast<Group*>(pickedGroup(std::as_const(state), p));
}

}  // namespace muster
