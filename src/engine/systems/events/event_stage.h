// The stage of events: motion changes, items, checkpoints, how orders get on, and the lag of every group.
#pragma once

#include <span>
#include <vector>

#include "engine/state/shared_places.h"
#include "engine/state/world_state.h"
#include "engine/steering/motion_state.h"
#include "engine/systems/events/moving_gates.h"
#include "engine/systems/events/standstill.h"
#include "muster/event.h"

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
