// The stage of contacts: nobody enters another or an obstacle (SPEC A6).
#pragma once

#include <vector>

#include "base/parallel.h"
#include "crowd/contacts.h"
#include "world/stages/steering_stage.h"
#include "world/state/world_state.h"

namespace muster {

/// Corrects the next motion and makes it the present one.
class ContactStage {
public:
    /// Writes positions, velocities and headings of characters; returns the contacts that are left.
    ContactReport run(WorldState& state, SteeringStage& steering, ThreadPool& pool);

private:
    Contacts contacts_;
    std::vector<double> reach_;  // Of each character in a step [m].
};

}  // namespace muster
