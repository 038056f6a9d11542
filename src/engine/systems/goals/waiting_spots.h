// Where people stand in waiting areas: free spots a body apart, the farthest from where each comes in first
// (docs/method/goals.md).
#pragma once

#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/state/world_state.h"

namespace muster {

/// Gives those who come to a waiting area spots in it.
class WaitingSpots {
public:
    /// Drops the spots of those who have gone, and gives spots to members who have come. Where there is none
    /// left, who comes near or gets on no more has arrived too.
    void run(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
             const StaticGround& ground);

private:
    bool takeSpots(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
                   const StaticGround& ground);
    void listFree(const WorldState& state, const Group& group, const Area& area);

    std::vector<Vec2> free_;  // Spots of the area at hand that nobody has.
    std::vector<Vec2> taken_;
};

}  // namespace muster
