// Premovement: the time from an order until a person sets out.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Sets the time at which characters set out that have their first order now, because their group was given
/// one or they have joined a group that has one: the first step after their premovement time.
void hearOrders(WorldState& state);

}  // namespace muster
