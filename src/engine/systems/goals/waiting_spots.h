// Spots of people in waiting areas: free spots a body apart; a person takes the one farthest from where it
// comes in (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/state/world_state.h"

namespace muster {

/// Gives people who come to a waiting area spots in it. All groups that wait there share them.
class WaitingSpots {
public:
    /// Drops the spots of people who have gone, and gives spots to members who have come. Where no spot is
    /// left, a member that is near or gets on no more has arrived too.
    void run(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
             const StaticGround& ground);

private:
    /// All people who are to wait in one area.
    struct Crowd {
        std::size_t people = 0;   // Number of people.
        std::size_t without = 0;  // Number of them without a spot.
        double radius = 0.0;      // Largest radius [m].
    };
    static Crowd crowdOf(const WorldState& state, AreaId area);
    bool takeSpots(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
                   const StaticGround& ground);
    void listFree(const WorldState& state, const Area& area, const Crowd& crowd);
    void lay(const WorldState& state, const Polygon& polygon, double radius, double step);

    std::vector<Vec2> free_;  // Spots of the area at hand that are free.
    std::vector<Vec2> taken_;
    std::vector<std::uint8_t> nearOthers_;  // By node of a grid over the area: 1 if it is too near a spot.
};

}  // namespace muster
