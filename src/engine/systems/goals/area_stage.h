// The stage of areas: exits take people out of the world, sources let them in, and groups without members end
// (docs/method/goals.md).
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

    std::vector<std::uint8_t> leaves_;  // By character: 1 if it leaves now.
    std::vector<std::int32_t> inside_;  // Characters in an exit that lets people through in order.
    CellList cells_;                    // All characters; built where a person comes in.
    bool sorted_ = false;
    double largest_ = 0.0;            // Largest radius of a character [m].
    std::vector<std::int32_t> come_;  // Characters that have come in during this step.
};

}  // namespace muster
