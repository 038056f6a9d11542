// Where people stand in waiting areas: free spots a body apart, the farthest from where each comes in first
// (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/state/world_state.h"

namespace muster {

/// Gives those who come to a waiting area spots in it. All who wait there share them, whatever their groups.
class WaitingSpots {
public:
    /// Drops the spots of those who have gone, and gives spots to members who have come. Where there is none
    /// left, who comes near or gets on no more has arrived too.
    void run(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
             const StaticGround& ground);

private:
    /// All who are to wait in one area.
    struct Crowd {
        std::size_t people = 0;   // How many.
        std::size_t without = 0;  // How many of them have no spot yet.
        double radius = 0.0;      // Of the largest [m].
    };
    static Crowd crowdOf(const WorldState& state, AreaId area);
    bool takeSpots(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
                   const StaticGround& ground);
    void listFree(const WorldState& state, const Area& area, const Crowd& crowd);
    void lay(const WorldState& state, const Polygon& polygon, double radius, double step);

    std::vector<Vec2> free_;  // Spots of the area at hand that nobody has.
    std::vector<Vec2> taken_;
    std::vector<std::uint8_t> nearOthers_;  // By node of a grid over the area: 1 too near a spot.
};

}  // namespace muster
