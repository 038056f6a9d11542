// Changes of a group's orders that several commands make.
#pragma once

#include <span>

#include "engine/state/world_state.h"

namespace muster {

/// After a group was divided: each part goes on with the orders of the whole, beside the others as they are.
/// `parts` are the whole, whose middle was at `middle` [m], and those that have left it.
void shareOrders(WorldState& state, std::span<Group* const> parts, Vec2 middle);
/// Drops all orders; the mesh stays where it is.
void dropOrders(Group& group);
/// Puts the mesh where its places are now: those who are on their way stop.
void standWhereItIs(Group& group);

}  // namespace muster
