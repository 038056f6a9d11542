// The stage of contacts: nobody enters another or an obstacle (SPEC A6).
#pragma once

#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "engine/steering/contacts.h"
#include "engine/systems/steering/steering_stage.h"

namespace muster {

/// Into how many parts a step is divided in which characters move: none is longer than a thirtieth of a
/// second.
std::int32_t movesOf(double stepTime);

/// Corrects the next motion and makes it the present one.
class ContactStage {
public:
    /// Writes positions, velocities and headings of characters after a move of `dt` [s] that steering has
    /// made; returns the contacts that are left.
    ContactReport run(WorldState& state, SteeringStage& steering, double dt, ThreadPool& pool);

private:
    Contacts contacts_;
    std::vector<double> reach_;  // Of each character in a step [m].
};

}  // namespace muster
