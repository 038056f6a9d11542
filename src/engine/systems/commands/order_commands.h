// What the commands of orders change.
#pragma once

#include <span>
#include <vector>

#include "engine/state/world_state.h"
#include "muster/event.h"
#include "muster/command_kinds.h"

namespace muster {

/// Puts an order into a group's queue. Fails with NotFound or InvalidArgument, changing nothing.
Status giveOrder(WorldState& state, const GiveOrder& command, std::vector<Event>& events);
/// Changes a group's queue. Fails with NotFound, changing nothing.
Status editQueue(WorldState& state, const EditQueue& command, std::vector<Event>& events);
/// Tells a group how to behave. Fails with NotFound, changing nothing.
Status setConduct(WorldState& state, const SetConduct& command);

/// After a group was divided: each part goes on with the orders of the whole, beside the others as they are.
/// `parts` are the whole, whose middle was at `middle` [m], and those that have left it.
void shareOrders(WorldState& state, std::span<Group* const> parts, Vec2 middle);
/// Drops all orders; the mesh stays where it is.
void dropOrders(Group& group);
/// Puts the mesh where its places are now: those who are on their way stop.
void standWhereItIs(Group& group);

}  // namespace muster
