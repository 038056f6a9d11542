// What the commands of bodies change: what characters are, and who moves them.
#pragma once

#include "engine/state/world_state.h"
#include "muster/command_kinds.h"

namespace muster {

// Each fails, changing nothing, with NotFound where somebody does not exist, else with InvalidArgument.

/// Gives characters other bodies.
Status setBodies(WorldState& state, const SetBodies& command);
/// Says who moves characters.
Status setDriver(WorldState& state, const SetDriver& command);
/// Takes over where characters are that are moved from outside.
Status writeMotion(WorldState& state, const WriteMotion& command);
/// Stops all that are moved from outside: who is not written in a step stands.
void restOutside(WorldState& state);

}  // namespace muster
