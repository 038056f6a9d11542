// Changes of a group's orders that several commands make.
#pragma once

#include <span>

#include "engine/state/world_state.h"

namespace muster {

/// After a group was divided: each part goes on with the orders of the whole, and keeps its position relative
/// to the other parts. `parts` are the whole, whose middle was at `middle` [m], and the new groups.
void shareOrders(WorldState& state, std::span<Group* const> parts, Vec2 middle);
/// Drops all orders; the mesh stays where it is.
void dropOrders(Group& group);
/// Puts the mesh where its places are now, so that members that are walking stop.
void standWhereItIs(Group& group);

}  // namespace muster
