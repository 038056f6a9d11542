// Who holds its ground is ground to others: the ways of orders and of single characters lead round.
#pragma once

#include <vector>

#include "engine/orders/held_spot.h"
#include "engine/state/world_state.h"

namespace muster {

/// True for a group that holds its ground: not while an order leads it elsewhere.
inline bool holdsGround(const Group& group) {
    return group.def.conduct.stance == Stance::Hold && (group.orders.orders.empty() || group.orders.held);
}
/// Lists those of other groups who hold their ground, the first 64 of them: where they stand, or where the
/// places of those are who have no order and still come to them.
void listHeld(const WorldState& state, const Group& group, std::vector<HeldSpot>& held);

}  // namespace muster
