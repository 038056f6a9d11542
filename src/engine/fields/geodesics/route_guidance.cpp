// Directions by routes, where no field leads: each character heads for the next corner of its route.
// Characters that go the same way share routes.
#include <algorithm>
#include <limits>
#include <utility>

#include "engine/fields/geodesics/geodesics_impl.h"

namespace muster {
namespace {

// Number of operations for routes in a step, of 10 to 100 ns each,
constexpr std::int64_t kRouteOperations = 12000;
// and the approximate number for all groups that share steps together.
constexpr std::int64_t kSharedRouteOperations = 24000;
constexpr double kCornerReached = 0.15;      // Distance at which a corner is reached [m].
constexpr std::int32_t kRouteSteps = 48;     // Number of steps for which the corner of a route serves,
constexpr std::uint32_t kFurtherSteps = 32;  // and upper bound of the random number of further steps.
constexpr std::int32_t kRetrySteps = 12;     // Number of steps until a missing route is searched again.
// Number of steps between two looks for the corner and the one after it.
constexpr std::int32_t kLookPeriod = 4;
constexpr double kPlaceMoved = 0.1;  // Share of its distance by which a place may move meanwhile.

}  // namespace

void Geodesics::findRoutes(RouteGraph& routes, std::span<const Vec2> from,
                           std::span<SteeringTarget> targets) {
    Impl& s = *impl_;
    s.ways.age();
    const std::size_t n = targets.size();
    if (n == 0 || from.size() != n) return;
    std::int64_t left = std::min(kRouteOperations, kSharedRouteOperations / s.sharePeriod);
    const std::size_t first = s.nextRoute % n;
    for (std::size_t k = 0; k < n && left > 0; ++k) {
        const std::size_t i = (first + k) % n;
        SteeringTarget& target = targets[i];
        if (target.route != RouteUse::Wanted || target.place < 0 ||
            std::cmp_greater_equal(target.place, s.places.size()))
            continue;
        left -= s.findRoute(routes, from[i], target);
        if (left <= 0) s.nextRoute = static_cast<std::uint32_t>((i + 1) % n);
    }
}

// Finds a route for a character; returns the operations used.
std::int64_t Geodesics::Impl::findRoute(RouteGraph& routes, Vec2 from, SteeringTarget& target) {
    std::int64_t work = 1;
    const Vec2 to = places[target.place];
    if (!ways.join(routes.ground(), from, to, path, work)) {
        routeSearch.start(routes, from, to);
        std::int64_t budget = std::numeric_limits<std::int64_t>::max();
        routeSearch.advance(routes, budget);
        work += routeSearch.work();
        path = routeSearch.path();
        if (path.size() > 1) ways.add(path);
    }
    target.route = RouteUse::None;
    const std::uint32_t spread = stagger(target.place);
    if (path.size() < 2) {
        target.steps = kRetrySteps + static_cast<std::int32_t>(spread) % kRetrySteps;
        return work;
    }
    target.steps = kRouteSteps + static_cast<std::int32_t>(spread % kFurtherSteps);
    std::size_t corner = 1;
    // A route begins in the cell where the graph is entered, which may lie behind; it is left out where the
    // next corner is in sight, or a character that searches again on its way would turn back each time.
    while (corner + 1 < path.size() && (distance(from, path[corner]) < kCornerReached ||
                                        routes.ground().lineClear(from, path[corner + 1])))
        ++corner;
    target.point = path[corner];
    target.after = path[std::min(corner + 1, path.size() - 1)];
    target.end = to;
    target.inSight = true;
    target.seen = ground->lineOfSight(from, target.point);
    target.landmark = -1;
    target.route = RouteUse::Known;
    return work;
}

// The corner of a route serves until it is reached or hidden, the one after it comes in sight, or the place
// has moved on.
bool Geodesics::Impl::routeServes(const CostQuery& q, SteeringTarget& target) const {
    if (target.route != RouteUse::Known || --target.steps <= 0 ||
        distance(q.from, target.point) <= kCornerReached || distance(target.end, q.to) > kPlaceMoved * q.line)
        return false;
    if (target.steps % kLookPeriod != 0) return true;
    const bool passed = !(target.after == target.point) && ground->lineOfSight(q.from, target.after);
    return !passed && (!target.seen || ground->lineOfSight(q.from, target.point));
}

// The direction to the corner; until there is one straight on, as far as walls allow.
Vec2 Geodesics::Impl::directionByRoute(const CostQuery& q, SteeringTarget& target) const {
    if (routeServes(q, target)) return normalized(target.point - q.from);
    const bool known = target.route == RouteUse::Known;
    // Where there was no route one is searched again after some steps.
    if (known || target.route == RouteUse::Wanted || --target.steps <= 0) target.route = RouteUse::Wanted;
    if (known && distance(q.from, target.point) > 1e-3) return normalized(target.point - q.from);
    return slideAlongWall(q.from, normalized(q.to - q.from));
}

}  // namespace muster
