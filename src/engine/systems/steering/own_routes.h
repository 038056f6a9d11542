// Routes of their own for those whom the guidance of their plan does not get to their places.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_search.h"
#include "engine/orders/held_spot.h"
#include "engine/state/world_state.h"

namespace muster {

/// The route of its own that leads a character to its place; null where there is none.
const OwnRoute* followedRoute(const WorldState& state, std::size_t i);

/// What the place of each member of a group costs it by the exact ground [m]: where it follows a route of its
/// own (then somewhat less, so that it keeps the place), or stands so near its place that the straight line
/// is known to be clear. Negative where that is not known.
void gatherExactCosts(const WorldState& state, const Group& group, std::vector<double>& costs);

/// Who has been about the same spot for a while although its place is elsewhere, or is barred by others who
/// hold their ground, follows a route by the exact ground, the quickest it knows, and keeps it until it has
/// arrived: so no two sources of directions alternate.
class OwnRoutes {
public:
    /// Writes the directions and costs of those with a route, after the plans and passages. `barred` marks
    /// characters whose way others who hold their ground close; empty where there are none.
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
    Polygon outline_;                       // Of a patch.
    std::int64_t budget_ = 0;               // Operations left in this step.
    std::vector<std::int32_t> index_;       // Of the character of each route.
    std::vector<std::vector<Vec2>> spare_;  // Memory of routes that ended.
};

}  // namespace muster
