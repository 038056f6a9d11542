// The stage of areas: exits take people out of the world, sources let them in, and groups end that nobody is
// left of (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <vector>

#include "base/cell_list.h"
#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "muster/event.h"

namespace muster {

/// Owns the memory of the stage.
class AreaStage {
public:
    /// One step; appends what happened to `events`.
    void run(WorldState& state, ThreadPool& pool, std::vector<Event>& events);

private:
    void findLeaving(WorldState& state);
    void passInOrder(WorldState& state, Area& area);
    void takeOut(WorldState& state, ThreadPool& pool, std::vector<Event>& events);
    void admit(WorldState& state, Area& area, ThreadPool& pool, std::vector<Event>& events);
    bool findRoom(WorldState& state, Area& area, double radius, Vec2& spot);
    void endGroups(WorldState& state, ThreadPool& pool, std::vector<Event>& events);

    std::vector<std::uint8_t> leaves_;  // Of all characters: 1 for who leaves now.
    std::vector<std::int32_t> inside_;  // Who is in an exit that lets through in order.
    CellList cells_;                    // Of all characters, where somebody comes.
    bool sorted_ = false;
    double largest_ = 0.0;            // Radius of all [m].
    std::vector<std::int32_t> come_;  // Who have come in this step.
};

}  // namespace muster
