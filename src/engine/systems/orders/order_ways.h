// Facts of the ground and of groups that orders need.
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

/// Size of a formation from the middle of its places.
struct FormationExtent {
    double depth = 0.0;  ///< Size along its heading [m].
    double width = 0.0;  ///< Size across its heading [m].
    double reach = 0.0;  ///< Distance to the farthest place [m].
};

/// The end of an order on the ground.
struct OrderGoal {
    Vec2 ground;  ///< End of the route, where characters can walk [m].
    Vec2 target;  ///< Point to which the formation goes: the target, or the nearest ground to it [m].
    bool reachable = true;  ///< False where `target` is not the target of the order.
};

/// The pose at a point, facing along a unit vector.
inline Pose facingPose(Vec2 position, Vec2 front) {
    return {position, {front.x, front.y}};
}
/// The extent of a group's formation.
FormationExtent extentOf(const Group& group);
/// Mean velocity of the places of a group; zero where it has none [m/s].
Vec2 meanVelocity(const Group& group);
/// Mean position of the members of a group; zero where it has none [m].
Vec2 middleOf(const WorldState& state, const Group& group);
/// The end of an order to go to `target` [m], for a group in a region.
OrderGoal goalOf(RouteGraph& routes, std::int32_t region, double width, Vec2 target);
/// The room that a group needs on its route by an order. Where the order asks for a manner of turning, for
/// width or for keeping clear of others, narrow stretches cost what they would cost a formation that stays
/// whole.
WayNeeds needsOf(const WorldState& state, const Group& group, const Order& order);
/// The bounds of a group's march: at the speed of its slowest member, or without cohesion at a speed that few
/// members do not reach. `speeds` is working memory.
MarchDef marchDefOf(const WorldState& state, const Group& group, const Order& order,
                    const FormationExtent& extent, std::vector<double>& speeds);
/// The length [m of good ground] that slow ground adds to a route for a formation that reaches `depth` [m]
/// before and behind its middle.
double slowGround(const Environment& environment, std::span<const Vec2> way, double depth);
/// The points through which an order leads after the group's position: the points of a drawn route on which
/// the group can stand, then the goal [m].
void listLegs(const RouteGraph& routes, std::int32_t region, const Order& order, const OrderGoal& goal,
              std::vector<Vec2>& legs);

/// Searches the routes of marches, leg by leg.
class WayFinder {
public:
    /// Takes over the present ground.
    void update(const WorldState& state) { ground_.update(state.environment); }
    const WayGround& ground() const { return ground_; }  ///< The ground at the last update().
    /// Goes on with the search for the legs of a march for about `budget` cells, and subtracts the cells that
    /// it used. True once the whole route is known. If `busy` with the search of another march, begins none.
    bool advance(WorldState& state, RouteGraph& routes, std::int32_t region, bool drawn,
                 const WayNeeds& needs, bool busy, March& march, std::int32_t& budget);

private:
    bool straight(const WorldState& state, bool drawn, const WayNeeds& needs, Vec2 from, Vec2 to) const;

    WayGround ground_;
    WaySearches searches_;
};

}  // namespace muster
