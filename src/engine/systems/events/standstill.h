// Stuck characters: not arrived, standing for 5 s, and not in a queue that moves on (SPEC section 8).
#pragma once

#include <cstdint>
#include <vector>

#include "base/cell_list.h"
#include "engine/state/world_state.h"
#include "muster/event.h"

namespace muster {

/// Finds stuck characters.
class Standstill {
public:
    /// Allocates memory for a crowd of this size.
    void reserve(const Characters& characters);
    /// Appends a Stuck event for each stuck character that was not reported since its last move.
    void raise(WorldState& state, std::vector<Event>& events);

private:
    bool movedLately(const WorldState& state, std::int32_t i) const;
    bool isAhead(const WorldState& state, std::int32_t j, std::int32_t i) const;
    void markMovingQueues(const WorldState& state);
    void markBehind(const WorldState& state, std::int32_t j);

    CellList cells_;
    double largest_ = 0.0;                 // Largest radius of a body [m].
    std::vector<std::uint8_t> movesOn_;    // Per character, 1 where it moves or queues behind one that moves.
    std::vector<std::int32_t> spreading_;  // Characters whose followers are still to be marked.
};

/// Number of steps in `seconds`, at least 1.
std::uint32_t stepsIn(const WorldState& state, double seconds);

}  // namespace muster
