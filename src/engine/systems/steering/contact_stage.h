// The stage of contacts: no character enters another or an obstacle (SPEC A6).
#pragma once

#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "engine/steering/contacts.h"
#include "engine/systems/steering/steering_stage.h"

namespace muster {

/// The number of moves into which a step is divided: none is longer than a thirtieth of a second.
std::int32_t movesOf(double stepTime);

/// Corrects the next motion and makes it the present one.
class ContactStage {
public:
    /// Writes positions, velocities and headings of characters after a move of `dt` [s] by steering; returns
    /// the remaining contacts.
    ContactReport run(WorldState& state, SteeringStage& steering, double dt, ThreadPool& pool);

private:
    Contacts contacts_;
    std::vector<double> reach_;  // Greatest movement of each character in a step [m].
};

}  // namespace muster
