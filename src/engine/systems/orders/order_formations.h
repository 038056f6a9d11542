// The formations that groups take up for their orders.
#pragma once

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "engine/systems/orders/order_ways.h"
#include "muster/order.h"

namespace muster {

/// Takes up the formation that an order asks for, or the group's own one again. The group goes on from where
/// it is. Waits for background work if the formation changes.
void takeUpFormation(WorldState& state, Group& group, const Order& order, ThreadPool& pool);
/// Takes up the group's own formation again, if it has another one for an order.
void restoreOwn(WorldState& state, Group& group, ThreadPool& pool);

}  // namespace muster
