// What orders need to know of the ground and of their groups.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/march.h"
#include "engine/orders/way_ground.h"
#include "engine/orders/way_searches.h"
#include "engine/state/world_state.h"
#include "muster/order.h"

namespace muster {

/// How far a formation extends from the middle of its places.
struct FormationExtent {
    double depth = 0.0;  ///< Along its heading [m].
    double width = 0.0;  ///< Across [m].
    double reach = 0.0;  ///< To the farthest place [m].
};

/// Where an order leads.
struct OrderGoal {
    Vec2 ground;            ///< The end of the way that characters can walk [m].
    Vec2 target;            ///< Where the formation goes: the target, or the nearest ground to it [m].
    bool reachable = true;  ///< False where that is not the target.
};

/// At a point, facing along a unit vector.
inline Pose facingPose(Vec2 position, Vec2 front) {
    return {position, {front.x, front.y}};
}
/// The extent of a group's formation.
FormationExtent extentOf(const Group& group);
/// Mean velocity of the places of a group; zero where it has none [m/s].
Vec2 meanVelocity(const Group& group);
/// Mean position of the members of a group; zero where it has none [m].
Vec2 middleOf(const WorldState& state, const Group& group);
/// Where a group in a region comes by an order to go to `target` [m].
OrderGoal goalOf(RouteGraph& routes, std::int32_t region, double width, Vec2 target);
/// The room that a group needs on its way by an order. Where it asks for a manner of turning, for its width
/// or for keeping clear of others, narrow ways cost what they would cost a formation that stays whole.
WayNeeds needsOf(const WorldState& state, const Group& group, const Order& order);
/// The bounds of a group's march: at the speed of the slowest, or without cohesion at one that few do not
/// reach. `speeds` is working memory.
MarchDef marchDefOf(const WorldState& state, const Group& group, const Order& order,
                    const FormationExtent& extent, std::vector<double>& speeds);
/// How much longer a way [m] is for a formation that reaches `depth` [m] before and behind its middle,
/// because some of it is on slow ground: in metres of good ground.
double slowGround(const Environment& environment, std::span<const Vec2> way, double depth);
/// The points through which an order leads, from the first after the group's position to the end: those of a
/// drawn way on which the group can stand, then the goal [m].
void listLegs(const RouteGraph& routes, std::int32_t region, const Order& order, const OrderGoal& goal,
              std::vector<Vec2>& legs);

/// Searches the ways of marches, leg by leg.
class WayFinder {
public:
    /// Follows the ground.
    void update(const WorldState& state) { ground_.update(state.environment); }
    const WayGround& ground() const { return ground_; }  ///< As of the last update().
    /// Goes on with the search for the legs of a march for `budget` cells, about, and takes what it used off
    /// it. True once the whole way is known. Begins no search where it is `busy` with that of another march.
    bool advance(WorldState& state, RouteGraph& routes, std::int32_t region, bool drawn,
                 const WayNeeds& needs, bool busy, March& march, std::int32_t& budget);

private:
    bool straight(const WorldState& state, bool drawn, const WayNeeds& needs, Vec2 from, Vec2 to) const;

    WayGround ground_;
    WaySearches searches_;
};

}  // namespace muster
