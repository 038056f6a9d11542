// What the commands of roles and weights change.
#pragma once

#include "engine/state/world_state.h"
#include "muster/command_kinds.h"

namespace muster {

// Each fails, changing nothing, with NotFound where there is no such group, else with InvalidArgument.

/// Says which class stands where in a formation.
Status setRoles(WorldState& state, const SetRoles& command);
/// Says how many units each place demands.
Status setDemands(WorldState& state, const SetDemands& command);

}  // namespace muster
