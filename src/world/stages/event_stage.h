// The stage of events: motion changes, items, checkpoints, and the lag of every group. It needs no memory.
#pragma once

#include <span>
#include <vector>

#include "crowd/motion_state.h"
#include "muster/event.h"
#include "world/state/world_state.h"

namespace muster {

/// Collects items, changes formations at checkpoints, measures lags, and appends what happened to `events`.
void raiseEvents(WorldState& state, std::span<const MotionEvent> changes, std::vector<Event>& events);

}  // namespace muster
