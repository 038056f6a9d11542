// Finds the members of a group that have no route to where it is ordered (SPEC B16).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/world_state.h"
#include "muster/event.h"

namespace muster {

/// True at a point from which no way leads to a region; never where `region` is -1, nor off the free ground.
bool isCutOff(const RouteGraph& routes, std::int32_t region, Vec2 point);

/// Judges whether a group can get to the target of its order once that is drawn, and again where the ground
/// has changed; appends NoPath, Partial, Blocked or Free.
void raiseWayEvents(WorldState& state, Group& group, std::vector<Event>& events);

}  // namespace muster
