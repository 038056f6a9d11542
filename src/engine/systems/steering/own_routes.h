// Own routes of agents that the guidance of their plan does not get to their places.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_search.h"
#include "engine/orders/held_spot.h"
#include "engine/state/world_state.h"

namespace muster {

/// The own route that leads a character to its place; null where there is none.
const OwnRoute* followedRoute(const WorldState& state, std::size_t i);

/// Writes the cost of its place for each member of a group by the exact ground [m]: along its own route
/// (slightly less, so that it keeps the place), or along the straight line where a member near its place is
/// known to have a clear one. Negative where it is not known.
void gatherExactCosts(const WorldState& state, const Group& group, std::vector<double>& costs);

/// An agent that has been about the same spot for a while although its place is elsewhere, or that is barred
/// by agents that hold their ground, follows a route by the exact ground, the quickest it knows. It keeps the
/// route until it has arrived, so that no two sources of directions alternate.
class OwnRoutes {
public:
    /// Writes the directions and costs of agents with a route, after the plans and passages. `barred` marks
    /// characters whose route is closed by agents that hold their ground; empty where there are none.
    void run(WorldState& state, std::span<const std::uint8_t> barred);

private:
    static bool mayHave(const WorldState& state, std::int32_t i);
    static bool camps(const WorldState& state, std::int32_t i);
    void dropEnded(WorldState& state);
    void begin(WorldState& state, std::span<const std::uint8_t> barred);
    RouteStatus find(WorldState& state, std::int32_t i, std::span<const ClosedLine> closed,
                     std::int64_t most);
    bool close(std::span<const Vec2> outline, Vec2 from, Vec2 to);
    bool closeSlow(const Environment& environment);
    void avoidSlow(WorldState& state, std::int32_t i, std::vector<Vec2>& path);
    bool search(WorldState& state, std::int32_t i, OwnRoute& route);
    void follow(WorldState& state, std::int32_t i, OwnRoute& route);
    static void goStraight(WorldState& state);

    void closeHeld(const WorldState& state, std::int32_t i, double margin);

    RouteSearch search_;
    std::vector<HeldSpot> held_;
    std::vector<ClosedLine> closed_;
    Polygon outline_;                       // Outline of a patch.
    std::int64_t budget_ = 0;               // Operations left in this step.
    std::vector<std::int32_t> index_;       // Index of the character of each route.
    std::vector<std::vector<Vec2>> spare_;  // Memory of ended routes.
};

}  // namespace muster
