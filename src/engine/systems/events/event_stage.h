// The stages of events: motion changes, items, checkpoints, how orders get on, and the lag of every group.
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

/// Appends the changes of motion of a step to `events`, and makes room for the events that follow.
void raiseMotionEvents(const WorldState& state, std::span<const MotionEvent> changes,
                       std::vector<Event>& events);
/// Collects the items that characters have reached.
void collectItems(WorldState& state, std::vector<Event>& events);
/// Changes the formations of groups that pass a checkpoint.
void meetCheckpoints(WorldState& state, std::vector<Event>& events);
/// Writes the mean lag of every group behind its places (SPEC U6).
void measureLags(WorldState& state);

/// Watches the progress of characters and orders.
class EventStage {
public:
    // Called once in each step, in this order.

    /// Writes the progress of each character's walk.
    void watchWalks(WorldState& state);
    /// Raises arrivals, and groups without a route.
    void watchOrders(WorldState& state, std::vector<Event>& events);
    /// Raises stuck characters; from time to time.
    void watchStandstill(WorldState& state, std::vector<Event>& events);
    /// Raises groups that moving obstacles cut off, and when their route is free again.
    void watchGates(WorldState& state, std::vector<Event>& events) { movingGates_.raise(state, events); }

private:
    SharedPlaces shared_;
    Standstill standstill_;
    MovingGates movingGates_;
};

}  // namespace muster
