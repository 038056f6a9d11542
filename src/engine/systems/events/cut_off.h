// Who has no way to where their group is ordered (SPEC B16).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/world_state.h"
#include "muster/event.h"

namespace muster {

/// Judges the ways of a group once its order is drawn, and again where the ground has changed; appends
/// NoPath, Partial, Blocked or Free.
void raiseWayEvents(WorldState& state, Group& group, std::vector<Event>& events);

}  // namespace muster
