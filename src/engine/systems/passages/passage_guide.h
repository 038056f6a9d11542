// Leads characters through their passages.
#pragma once

#include <vector>

#include "engine/state/world_state.h"
#include "engine/systems/passages/way_fields.h"

namespace muster {

/// Finds the direction of characters with a way.
class PassageGuide {
public:
    /// The unit vector of the desired direction of a character, whose chosen way is not -1.
    Vec2 direction(const WorldState& state, const WayFields& fields, std::size_t character);

private:
    std::vector<Vec2> path_;
};

}  // namespace muster
