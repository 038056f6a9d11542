// The stage of commands: what each command changes.
#pragma once

#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "muster/command.h"
#include "muster/event.h"

namespace muster {

/// Applies all queued commands of this step in their order and moves the clock of the environment. Empties
/// `events` and `rejections`, and appends the commands that could not be applied to the latter.
void applyCommands(WorldState& state, ThreadPool& pool, std::vector<Event>& events,
                   std::vector<Rejection>& rejections);

}  // namespace muster
