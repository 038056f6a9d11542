// What the commands of orders change.
#pragma once

#include <vector>

#include "muster/event.h"
#include "muster/order_commands.h"
#include "world/state/world_state.h"

namespace muster {

/// Puts an order into a group's queue. Fails with NotFound or InvalidArgument, changing nothing.
Status giveOrder(WorldState& state, const GiveOrder& command, std::vector<Event>& events);
/// Changes a group's queue. Fails with NotFound, changing nothing.
Status editQueue(WorldState& state, const EditQueue& command, std::vector<Event>& events);
/// Tells a group how to behave. Fails with NotFound, changing nothing.
Status setConduct(WorldState& state, const SetConduct& command);

}  // namespace muster
