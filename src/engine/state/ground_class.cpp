#include "engine/state/ground_class.h"

#include <algorithm>
#include <cmath>

#include "engine/state/group_edits.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

constexpr double kRoom = 1.2;      // Least distance of places where their formation allows it, in diameters.
constexpr double kClosest = 0.75;  // Least distance of the places of a formation, in its spacings.
constexpr double kFactor = 1.18920711500272106672;  // From class to class, the fourth root of 2.
constexpr double kRounding = 1e-9;                  // Radii that differ by this share are one.
constexpr std::uint32_t kLookEvery = 30;            // Steps between looks at who gets where.

std::int32_t classOf(const WorldState& state, std::int32_t i) {
    const Parameters::Character& usual = state.parameters.character;
    return groundClassFor(usual.radius, radiusOf(usual, state.characters.body[i]));
}

/// Where a group is to go, or is.
Vec2 destinationOf(const Group& group) {
    const bool moves = !group.orders.orders.empty() &&
                       group.orders.orders.front().order.kind == OrderKind::Move;
    return moves ? group.orders.orders.front().order.target : group.mesh.pose().position;
}

/// The region of a point; for one that only the middle of a smaller body can come to, that beside it.
std::int32_t regionWithin(const RouteGraph& routes, Vec2 p, double reach) {
    const std::int32_t region = routes.region(p);
    if (region >= 0) return region;
    const Vec2 near = routes.nearestReachable(p, -1);
    return distance(near, p) <= reach ? routes.region(near) : -1;
}

/// How many of a group get to a point on the ground of a class, and whether some of them need such ground.
struct Comers {
    std::int32_t count = 0;
    bool own = false;
};

Comers comersOn(WorldState& state, const Group& group, std::int32_t groundClass, Vec2 to) {
    const RouteGraph& routes = state.refreshRoutes(groundClass);
    const Parameters::Character& usual = state.parameters.character;
    const double radius = groundRadius(usual.radius, groundClass), cell = state.environment.grid().cell;
    Comers found;
    const std::int32_t region = regionWithin(routes, to, radius + cell);
    if (region < 0) return found;
    for (const std::int32_t i : group.members) {
        const std::int32_t own = classOf(state, i);
        if (own > groundClass) continue;
        // Beside a wall a smaller body stands nearer to it than that ground.
        const double beside = radius - radiusOf(usual, state.characters.body[i]) + 0.5 * cell;
        if (regionWithin(routes, state.characters.position[i], beside) != region) continue;
        ++found.count;
        found.own = found.own || own == groundClass;
    }
    return found;
}

/// The class on whose ground most get there; that of the largest where nobody does.
std::int32_t bestClass(WorldState& state, const Group& group) {
    const std::int32_t largest = groundClassFor(state, group);
    const auto isLargest = [&](std::int32_t i) { return classOf(state, i) == largest; };
    if (std::all_of(group.members.begin(), group.members.end(), isLargest)) return largest;
    const Vec2 to = destinationOf(group);
    std::int32_t best = largest, most = 0;
    for (std::int32_t at = largest;;) {
        const Comers comers = comersOn(state, group, at, to);
        const bool kept = comers.count == most && at == group.groundClass;
        if (comers.own && (comers.count > most || kept)) {
            best = at;
            most = comers.count;
        }
        if (std::cmp_equal(most, group.members.size())) return best;
        std::int32_t next = at;
        for (const std::int32_t i : group.members)
            if (const std::int32_t own = classOf(state, i); own < at && (next == at || own > next))
                next = own;
        if (next == at) return best;
        at = next;
    }
}

}  // namespace

std::int32_t groundClassFor(double usual, double radius) {
    std::int32_t groundClass = 0;
    for (double r = usual; r < radius * (1.0 - kRounding); r *= kFactor) ++groundClass;
    for (double r = usual / kFactor; r > radius * (1.0 + kRounding); r /= kFactor) --groundClass;
    return groundClass;
}

double groundRadius(double usual, std::int32_t groundClass) {
    double radius = usual;
    for (std::int32_t k = 0; k < groundClass; ++k) radius *= kFactor;
    for (std::int32_t k = 0; k > groundClass; --k) radius /= kFactor;
    return radius;
}

std::int32_t groundClassFor(const WorldState& state, const Group& group) {
    const Parameters::Character& usual = state.parameters.character;
    double largest = 0.0;
    for (const std::int32_t i : group.members)
        largest = std::max(largest, radiusOf(usual, state.characters.body[i]));
    return largest > 0.0 ? groundClassFor(usual.radius, largest) : 0;
}

bool fitsGround(const WorldState& state, const Group& group, std::int32_t character) {
    return state.characters.body[character].radius == 0.0 ? group.groundClass >= 0
                                                          : classOf(state, character) <= group.groundClass;
}

std::int32_t tooLargeFor(const WorldState& state, const Group& group) {
    return static_cast<std::int32_t>(
        std::count_if(group.members.begin(), group.members.end(),
                      [&](std::int32_t i) { return !fitsGround(state, group, i); }));
}

double meanRadius(const WorldState& state, const Group& group) {
    const Parameters::Character& usual = state.parameters.character;
    double sum = 0.0;
    bool alike = true;
    std::int32_t count = 0;
    for (const std::int32_t i : group.members) {
        if (!fitsGround(state, group, i)) continue;
        const double own = radiusOf(usual, state.characters.body[i]);
        alike = alike && own == usual.radius;
        sum += own;
        ++count;
    }
    return alike ? usual.radius : sum / static_cast<double>(count);
}

PlaceDef placeDefOf(const WorldState& state, const Group& group) {
    const Parameters& parameters = state.parameters;
    // Bodies that touch all round never come to rest on points that touch.
    const double touching = 2.0 * meanRadius(state, group);
    const double apart = std::max(touching,
                                  std::min(kRoom * touching, kClosest * group.def.formation.spacing));
    double fastest = parameters.place.speed;
    for (const std::int32_t i : group.members) fastest = std::max(fastest, state.characters.body[i].maxSpeed);
    return {groundRadius(parameters.character.radius, group.groundClass), parameters.place.clearance, fastest,
            apart};
}

void updateGroundClass(WorldState& state, Group& group, ThreadPool& pool) {
    const std::int32_t now = bestClass(state, group);
    if (now == group.groundClass) return;
    pool.wait();
    group.groundClass = now;
    group.plan = makePlan(state.parameters);
    group.planNow = true;
    for (const std::int32_t i : group.members) state.characters.chosen[i] = {};
}

void updateGroundClasses(WorldState& state, ThreadPool& pool) {
    const bool looks = state.lastCommandStep == state.stepCount || state.stepCount % kLookEvery == 0;
    for (Group& group : state.groups) {
        if (state.continuum.isBare(group.id)) continue;  // Each has a class of its own.
        // On another ground an order is judged again, which tells who cannot come any more.
        const bool judged = group.orders.begun && group.orders.ground != state.groundEdits;
        if ((looks || group.planNow) && !judged) updateGroundClass(state, group, pool);
    }
}

}  // namespace muster
