// Premovement: the time from an order until a person sets out.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Whoever has its first order now, since its group was given one, or since it has joined a group that has
/// one, sets out in the first step whose time is that of this step and its premovement time, or later.
void hearOrders(WorldState& state);

}  // namespace muster
