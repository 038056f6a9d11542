#include "engine/systems/orders/order_ways.h"

#include <algorithm>
#include <cmath>

#include "base/bounds.h"
#include "base/maths.h"
#include "engine/ground/routes/route_search.h"
#include "engine/state/ground_class.h"
#include "engine/state/held_ground.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

// Share of the top speed of the slowest at which a formation marches, so that others can catch up.
constexpr double kMarchSpeedShare = 0.97;
constexpr double kMostAcceleration = 4.0;  // Greatest acceleration of a formation [m/s^2].
// Least distance at which a target in an obstacle counts as reached [m].
constexpr double kTargetReach = 1.0;
constexpr std::int32_t kStraightLegCells = 5;  // Cells for which a straight leg counts in the budget.

}  // namespace

FormationExtent extentOf(const Group& group) {
    const Formation& formation = group.mesh.formation();
    FormationExtent extent;
    for (const MeshPoint& place : formation.places) {
        const Vec2 p = place.position(formation.mesh.triangles, formation.mesh.vertices);
        extent.depth = std::max(extent.depth, std::fabs(p.x));
        extent.width = std::max(extent.width, std::fabs(p.y));
        extent.reach = std::max(extent.reach, length(p));
    }
    return extent;
}

Vec2 meanVelocity(const Group& group) {
    return meanOf(group.places.velocities());
}

Vec2 middleOf(const WorldState& state, const Group& group) {
    Vec2 sum;
    for (const std::int32_t i : group.members) sum += state.characters.position[i];
    return sum / std::max(1.0, static_cast<double>(group.members.size()));
}

OrderGoal goalOf(RouteGraph& routes, std::int32_t region, double width, Vec2 target) {
    if (region < 0) return {target, target, true};
    const std::int32_t at = routes.region(target);
    if (at == region) return {target, target, true};
    const Vec2 nearest = routes.nearestReachable(target, region);
    // A formation stands round a tree, for example; the ground is known by the centres of its cells.
    const double cell = routes.environment().grid().cell;
    if (at < 0 && distance(nearest, target) <= std::max(kTargetReach, width + cell) &&
        routes.region(routes.nearestReachable(target, -1)) == region)
        return {nearest, target, true};
    return {nearest, nearest, false};
}

WayNeeds needsOf(const WorldState& state, const Group& group, const Order& order) {
    WayNeeds needs;
    needs.radius = groundRadius(state.parameters.character.radius, group.groundClass);
    needs.margin = state.parameters.field.enabled ? std::min(1.5, state.parameters.field.range) : 0.5;
    const Conduct& conduct = group.def.conduct;
    needs.least = 1.0 - conduct.squeeze;
    needs.flows = order.turn == Turn::Flow && !conduct.avoids && conduct.squeeze >= 1.0;
    needs.half = extentOf(group).width + needs.radius;
    listHeld(state, group, needs.held);
    return needs;
}

MarchDef marchDefOf(const WorldState& state, const Group& group, const Order& order,
                    const FormationExtent& extent, std::vector<double>& speeds) {
    const Parameters::Character& character = state.parameters.character;
    const double usual = std::min(state.parameters.place.speed, character.maxSpeed);
    double least = character.acceleration;
    speeds.clear();
    for (const std::int32_t i : group.members) {
        if (!fitsGround(state, group, i)) continue;
        const Body& body = state.characters.body[i];
        speeds.push_back(body.maxSpeed > 0.0 ? body.maxSpeed : usual);
        least = std::min(least, body.acceleration > 0.0 ? body.acceleration : character.acceleration);
    }
    // A few slow members are left behind, unless the group keeps together.
    const std::size_t left = group.def.conduct.cohesion > 0.0 ? 0 : speeds.size() / kStragglers;
    const auto at = speeds.begin() + static_cast<std::ptrdiff_t>(left);
    double slowest = usual;
    if (at != speeds.end()) {
        std::nth_element(speeds.begin(), at, speeds.end());
        slowest = *at;
    }
    MarchDef def;
    def.turn = order.manner == Manner::Free ? Turn::Keep : order.turn;
    def.speed = kMarchSpeedShare * slowest;
    if (order.pace > 0.0) def.speed = std::min(def.speed, order.pace);
    def.acceleration = std::min(kMostAcceleration, least);
    def.brakes = std::min(kMostAcceleration, kBrakingShare * least);
    def.reach = std::max(extent.reach, 0.5);
    return def;
}

double slowGround(const Environment& environment, std::span<const Vec2> way, double depth) {
    constexpr double kSample = 0.5;  // Distance between samples [m].
    const Grid& grid = environment.grid();
    const RasterView speeds = environment.travelSpeed();
    std::vector<double> slowness;  // By sample.
    for (std::size_t k = 1; k < way.size(); ++k) {
        const double part = distance(way[k - 1], way[k]);
        for (double s = 0.0; s < part; s += kSample) {
            const Vec2 p = lerp(way[k - 1], way[k], s / part);
            slowness.push_back(1.0 / speeds[grid.index(grid.nearestCell(p))] - 1.0);
        }
    }
    const auto reach = static_cast<std::ptrdiff_t>(depth / kSample);
    const auto count = static_cast<std::ptrdiff_t>(slowness.size());
    double sum = 0.0;
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        double slowest = 0.0;
        for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, k - reach); j <= std::min(count - 1, k + reach);
             ++j)
            slowest = std::max(slowest, slowness[j]);
        sum += slowest * kSample;
    }
    return sum;
}

void listLegs(const RouteGraph& routes, std::int32_t region, const Order& order, const OrderGoal& goal,
              std::vector<Vec2>& legs) {
    legs.clear();
    for (const Vec2 p : order.route)
        if (region < 0 || routes.region(p) == region) legs.push_back(p);
    legs.push_back(goal.ground);
}

// True where a straight line will do as a leg: on a drawn route if bodies can walk it, else if it costs no
// more than any other route.
bool WayFinder::straight(const WorldState& state, bool drawn, const WayNeeds& needs, Vec2 from,
                         Vec2 to) const {
    if (drawn) return state.environment.clearStaticLine(from, to, needs.radius);
    return stretchCost(ground_, needs, from, to) <= 1.001 * ground_.leastSlowness() * distance(from, to);
}

bool WayFinder::advance(WorldState& state, RouteGraph& routes, std::int32_t region, bool drawn,
                        const WayNeeds& needs, bool busy, March& march, std::int32_t& budget) {
    while (!march.legs.empty() && budget > 0) {
        const Vec2 to = march.legs.front();
        Vec2 from = march.way.back();
        if (region >= 0 && routes.region(from) != region) from = routes.nearestReachable(from, region);
        if (march.searched == 0) {
            if (straight(state, drawn, needs, from, to)) {
                budget -= kStraightLegCells;
                if (!(from == march.way.back())) march.way.push_back(from);
                march.way.push_back(to);
                march.legs.erase(march.legs.begin());
                continue;
            }
            // The search that was begun first ends first.
            if (busy) return false;
            march.query = {from, to, needs};
        }
        // A search on changed ground begins again.
        const std::int32_t before = march.ground == state.groundEdits ? march.searched : 0;
        const WayStatus status = searches_.advance(ground_, march.query, before, budget);
        march.ground = state.groundEdits;
        march.searched = searches_.searched();
        budget -= std::max(1, march.searched - before);
        if (status == WayStatus::Searching) return false;
        if (status == WayStatus::Found) {
            march.way.insert(march.way.end(), searches_.path().begin() + 1, searches_.path().end());
        } else {
            const std::vector<Vec2> route = findRoute(routes, from, to);
            if (route.size() > 1)
                march.way.insert(march.way.end(), route.begin() + 1, route.end());
            else
                march.way.push_back(to);
        }
        march.searched = 0;
        march.legs.erase(march.legs.begin());
    }
    return march.legs.empty();
}

}  // namespace muster
