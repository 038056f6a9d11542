// The stage of events: motion changes, items, checkpoints, how orders get on, and the lag of every group.
#pragma once

#include <span>
#include <vector>

#include "crowd/motion_state.h"
#include "muster/event.h"
#include "world/stages/moving_gates.h"
#include "world/stages/standstill.h"
#include "world/state/shared_places.h"
#include "world/state/world_state.h"

namespace muster {

/// Raises the events of a step.
class EventStage {
public:
    /// Collects items, changes formations at checkpoints, measures lags, watches orders, and appends what
    /// happened to `events`.
    void run(WorldState& state, std::span<const MotionEvent> changes, std::vector<Event>& events);

private:
    SharedPlaces shared_;
    Standstill standstill_;
    MovingGates movingGates_;
};

}  // namespace muster
