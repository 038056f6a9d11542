#include "engine/systems/steering/own_routes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engine/state/held_ground.h"

namespace muster {
namespace {

constexpr double kCampTime = 6.0;    // Time within kCampReach after which an agent searches an own route [s].
constexpr double kRouteTime = 30.0;  // Greatest time for which a route is followed [s].
constexpr double kPlaceMove = 0.5;   // Movement of a place after which its route is searched again [m].
// Cost by which a place with a route counts as nearer, so that the agent keeps it [m].
constexpr double kCommitmentCost = 0.5;
constexpr double kNearPlace = 1.0;  // Distance to a place within which the straight line to it is tested [m].
constexpr double kAtPlace = 0.02;   // Distance to a place within which the line needs no test [m].
constexpr double kDetourFactor = 1.2;      // Factor of the straight line above which a cost means a detour,
constexpr double kDetourLength = 0.05;     // plus this length [m].
constexpr double kCornerReach = 0.1;       // Distance at which a corner of a route is reached [m].
constexpr std::uint32_t kSearchTurns = 8;  // Steps between two turns of one agent to search.
// Operations that searches may use in a step before no other one begins.
constexpr std::int64_t kRouteOperations = 12000;
constexpr std::size_t kMostHolders = 16;  // Greatest number of holders that a search goes round.
constexpr double kTightMargin = 0.02;     // Distance to holders where there is no wider gap [m].
constexpr double kSlowMargin = 0.1;       // Distance to slow ground that a route goes round [m].
constexpr double kLengthRounding = 1e-6;  // Rounding error of compared lengths [m].
constexpr double kMovingReach = 6.0;      // Reach of the discomfort round moving obstacles [m].

// The length of a path in metres of open ground.
double lengthFrom(const Environment& environment, Vec2 from, std::span<const Vec2> path) {
    double sum = 0.0;
    for (const Vec2 corner : path) {
        sum += environment.travelLength(from, corner);
        from = corner;
    }
    return sum;
}

Vec2 placeOf(const WorldState& state, std::int32_t i) {
    return state.groups[state.characters.group[i]].places.positions()[state.characters.place[i]];
}

const RouteGraph& routesFor(const WorldState& state, std::int32_t i) {
    return state.routesOf(state.groups[state.characters.group[i]]);
}

// Costs near places by the exact ground, since rasters do not resolve every line along a wall.
class NearPlaces {
public:
    NearPlaces(const WorldState& state, const Group& group)
        : characters_(state.characters),
          routes_(state.routesOf(group)),
          positions_(group.places.positions()),
          patches_(!state.environment.patchIds().empty()),
          moving_(state.environment.movingObstacleAreas()),
          grid_(state.environment.grid()),
          clearance_(state.environment.clearance()) {}

    // The length of the straight line to its place [m]; -1 where it is not clear, or the raster is exact
    // there.
    double cost(std::int32_t i) const {
        const Characters& c = characters_;
        if (patches_ || c.place[i] < 0 || c.chosen[i].way >= 0) return -1.0;
        const Vec2 here = c.position[i], place = positions_[c.place[i]];
        const double left = distance(here, place);
        if (left > kNearPlace) return -1.0;
        const Cell cell = grid_.nearestCell(here);
        const double clearance = clearance_[grid_.index(cell)];
        if (clearance > left + routes_.radius() + grid_.cell || nearMoving(cell)) return -1.0;
        return left < kAtPlace || routes_.ground().lineClear(here, place) ? left : -1.0;
    }

private:
    // True where moving obstacles may raise the cost of ground above its length.
    bool nearMoving(Cell here) const {
        const auto reach = static_cast<std::int32_t>(kMovingReach / grid_.cell);
        return std::any_of(moving_.begin(), moving_.end(), [&](const CellRect& area) {
            return !area.empty() && here.x >= area.low.x - reach && here.x <= area.high.x + reach &&
                   here.y >= area.low.y - reach && here.y <= area.high.y + reach;
        });
    }

    const Characters& characters_;
    const RouteGraph& routes_;
    std::span<const Vec2> positions_;
    bool patches_;
    std::span<const CellRect> moving_;
    Grid grid_;
    std::span<const float> clearance_;
};

bool hasTurn(const WorldState& state, std::int32_t i) {
    return (state.stepCount + state.characters.id[i]) % kSearchTurns == 0;
}

}  // namespace

bool OwnRoutes::mayHave(const WorldState& state, std::int32_t i) {
    const Characters& c = state.characters;
    return !c.walk[i].within && c.place[i] >= 0 && c.chosen[i].way < 0;
}

// True for an agent that has been on its way for long without getting farther than a step or two.
bool OwnRoutes::camps(const WorldState& state, std::int32_t i) {
    const WalkProgress& walk = state.characters.walk[i];
    return (state.stepCount - walk.campedAt) * state.parameters.stepTime >= kCampTime;
}

// Finds the characters of routes, and drops the routes of characters that left, arrived, or took too long.
void OwnRoutes::dropEnded(WorldState& state) {
    const Characters& c = state.characters;
    std::vector<OwnRoute>& routes = state.ownRoutes;
    index_.clear();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < routes.size(); ++k) {
        const std::int32_t i = c.indexOf(routes[k].character);
        const bool known = i >= 0;
        const bool arrived = known && c.walk[i].within &&
                             (state.stepCount - c.walk[i].since) * state.parameters.stepTime >= kStayedTime;
        const bool late = (state.stepCount - routes[k].since) * state.parameters.stepTime > kRouteTime;
        if (!known || arrived || late || c.place[i] < 0 || c.chosen[i].way >= 0) {
            spare_.push_back(std::move(routes[k].path));
            continue;
        }
        if (kept != k) std::swap(routes[kept], routes[k]);
        index_.push_back(i);
        ++kept;
    }
    routes.resize(kept);
}

// Closes a cross on each of the nearest agents that hold their ground, as wide as both bodies; narrower on a
// holder that is nearer, so that the agent gets out between them.
void OwnRoutes::closeHeld(const WorldState& state, std::int32_t i, double margin) {
    const Vec2 from = state.characters.position[i];
    const Group& group = state.groups[state.characters.group[i]];
    listHeld(state, group, held_);
    const std::size_t count = std::min(held_.size(), kMostHolders);
    std::partial_sort(
        held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(count), held_.end(),
        [&](const HeldSpot& a, const HeldSpot& b) {
            const double toA = lengthSquared(a.position - from), toB = lengthSquared(b.position - from);
            if (toA != toB) return toA < toB;
            return a.position.x != b.position.x ? a.position.x < b.position.x : a.position.y < b.position.y;
        });
    closed_.clear();
    for (std::size_t k = 0; k < count; ++k) {
        const double reach = std::min(held_[k].radius - kHeldMargin + margin + routesFor(state, i).radius(),
                                      distance(held_[k].position, from));
        for (const Vec2 arm : {Vec2{reach, 0.0}, Vec2{0.0, reach}})
            closed_.push_back({held_[k].position - arm, held_[k].position + arm});
    }
}

RouteStatus OwnRoutes::find(WorldState& state, std::int32_t i, std::span<const ClosedLine> closed,
                            std::int64_t most) {
    RouteGraph& graph = state.routesOf(state.groups[state.characters.group[i]]);
    search_.start(graph, state.characters.position[i], placeOf(state, i), closed,
                  !state.environment.movingObstacleAreas().empty());
    const RouteStatus status = search_.advance(graph, most);
    budget_ -= search_.work() + 1;
    return status;
}

// Closes the outline of a patch at a small distance, so that a route leads past it. False where an end of the
// route lies in it, or where it is closed already.
bool OwnRoutes::close(std::span<const Vec2> outline, Vec2 from, Vec2 to) {
    const double room = std::min(signedDistance(outline, from), signedDistance(outline, to));
    if (room <= 0.0) return false;
    const double margin = std::min(kSlowMargin, 0.5 * room);
    const std::size_t count = outline.size();
    const auto corner = [&](std::size_t k) {
        const Vec2 in = normalized(outline[k] - outline[(k + count - 1) % count], {1.0, 0.0});
        const Vec2 out = normalized(outline[(k + 1) % count] - outline[k], {1.0, 0.0});
        return outline[k] - margin * perpendicular(in + out) / std::max(0.5, 1.0 + dot(in, out));
    };
    const ClosedLine first{corner(0), corner(1)};
    const auto same = [&](const ClosedLine& line) { return line.a == first.a && line.b == first.b; };
    if (std::any_of(closed_.begin(), closed_.end(), same)) return false;
    for (std::size_t k = 0; k < count; ++k) closed_.push_back({corner(k), corner((k + 1) % count)});
    return true;
}

// Closes the slow patches through which the last route leads, except those that hold its begin or end. False
// where no such patch is open.
bool OwnRoutes::closeSlow(const Environment& environment) {
    const std::vector<Vec2>& path = search_.path();
    bool any = false;
    PatchId last;
    for (std::size_t k = 1; k < path.size(); ++k) {
        const double part = distance(path[k - 1], path[k]);
        for (double s = 0.0; s < part; s += 0.5 * environment.grid().cell) {
            const GroundSample ground = environment.ground(lerp(path[k - 1], path[k], s / part));
            if (ground.travelSpeed >= 1.0 || ground.patch == last) continue;
            last = ground.patch;
            environment.patchPolygon(last, outline_);
            any = close(outline_, path.front(), path.back()) || any;
        }
    }
    return any;
}

// Replaces a route over slow ground by the route round it if that is quicker.
void OwnRoutes::avoidSlow(WorldState& state, std::int32_t i, std::vector<Vec2>& path) {
    const Environment& environment = state.environment;
    const Vec2 from = state.characters.position[i];
    double least = lengthFrom(environment, from, path);
    while (budget_ > 0 && closeSlow(environment) &&
           find(state, i, closed_, kRouteOperations) == RouteStatus::Found && search_.path().size() > 1) {
        const auto round = std::span(search_.path()).subspan(1);
        const double length = lengthFrom(environment, from, round);
        if (length >= least) continue;
        least = length;
        path.assign(round.begin(), round.end());
    }
}

// Searches the route of a character; false where no route leads to its place.
bool OwnRoutes::search(WorldState& state, std::int32_t i, OwnRoute& route) {
    route.place = state.characters.place[i];
    route.goal = placeOf(state, i);
    constexpr std::int64_t kWhole = std::numeric_limits<std::int64_t>::max();
    RouteStatus status = RouteStatus::Unreachable;
    for (const double margin : {kHeldMargin, kTightMargin}) {
        closeHeld(state, i, margin);
        status = find(state, i, closed_, closed_.empty() ? kWhole : kRouteOperations);
        if (status != RouteStatus::Unreachable || closed_.empty()) break;
    }
    // Where holders leave no route, or none that is found soon, the agent goes up to them and waits there.
    if (status != RouteStatus::Found && !closed_.empty()) status = find(state, i, {}, kWhole);
    if (status != RouteStatus::Found || search_.path().size() < 2) return false;
    route.path.assign(search_.path().begin() + 1, search_.path().end());
    if (!state.environment.patchIds().empty()) avoidSlow(state, i, route.path);
    return true;
}

// Searches routes for agents that camp or are barred, within the budget.
void OwnRoutes::begin(WorldState& state, std::span<const std::uint8_t> barred) {
    const auto count = static_cast<std::int32_t>(state.characters.size());
    for (std::int32_t i = 0; i < count && budget_ > 0; ++i) {
        if (!hasTurn(state, i) || !mayHave(state, i)) continue;
        if (!camps(state, i) && (barred.empty() || barred[i] == 0)) continue;
        std::vector<OwnRoute>& routes = state.ownRoutes;
        const std::uint32_t id = state.characters.id[i];
        const auto at = std::lower_bound(
            routes.begin(), routes.end(), id,
            [](const OwnRoute& r, std::uint32_t own) { return r.character < own; });
        if (at != routes.end() && at->character == id) continue;
        OwnRoute route;
        if (!spare_.empty()) {
            route.path.swap(spare_.back());
            spare_.pop_back();
        }
        route.character = id;
        route.since = state.stepCount;
        if (!search(state, i, route)) {
            spare_.push_back(std::move(route.path));
            continue;
        }
        index_.insert(index_.begin() + (at - routes.begin()), i);
        routes.insert(at, std::move(route));
    }
}

void OwnRoutes::follow(WorldState& state, std::int32_t i, OwnRoute& route) {
    Characters& c = state.characters;
    const RouteGround& ground = routesFor(state, i).ground();
    const Vec2 here = c.position[i];
    const bool moved = route.place != c.place[i] || distance(route.goal, placeOf(state, i)) > kPlaceMove;
    const bool lost = route.path.empty() || !ground.lineClear(here, route.path.front());
    if ((moved || lost) && hasTurn(state, i) && budget_ > 0) search(state, i, route);
    if (route.place != c.place[i] || route.path.empty()) return;
    bool listed = false;
    const bool moving = !state.environment.movingObstacleAreas().empty();
    const auto sees = [&](Vec2 corner, Vec2 p) {
        if (!ground.lineClear(here, p)) return false;
        if (moving && !state.environment.clearLine(here, p, ground.radius())) return false;
        const Vec2 round[] = {corner, p};
        if (state.environment.travelLength(here, p) >
            lengthFrom(state.environment, here, round) + kLengthRounding)
            return false;
        if (!listed) listHeld(state, state.groups[c.group[i]], held_);
        listed = true;
        return clearOf(held_, here, p, routesFor(state, i).radius());
    };
    std::size_t passed = 0;
    while (passed + 1 < route.path.size() && (distance(here, route.path[passed]) < kCornerReach ||
                                              sees(route.path[passed], route.path[passed + 1])))
        ++passed;
    route.path.erase(route.path.begin(), route.path.begin() + static_cast<std::ptrdiff_t>(passed));
    if (route.path.size() == 1) route.path.front() = placeOf(state, i);
    route.cost = static_cast<float>(lengthFrom(state.environment, here, route.path));
    c.direction[i] = normalized(route.path.front() - here, c.direction[i]);
    c.cost[i] = route.cost;
}

// An agent near its place that is led on a detour goes straight where the line is clear.
void OwnRoutes::goStraight(WorldState& state) {
    Characters& c = state.characters;
    const auto count = static_cast<std::int32_t>(c.size());
    for (std::int32_t i = 0; i < count; ++i) {
        if (c.place[i] < 0) continue;
        const Vec2 way = placeOf(state, i) - c.position[i];
        const double left = length(way);
        if (left > kNearPlace || !(c.cost[i] > kDetourFactor * left + kDetourLength) ||
            NearPlaces(state, state.groups[c.group[i]]).cost(i) < 0.0)
            continue;
        c.direction[i] = normalized(way, c.direction[i]);
        c.cost[i] = left;
    }
}

const OwnRoute* followedRoute(const WorldState& state, std::size_t i) {
    const OwnRoute* const route = ownRouteOf(state.ownRoutes, state.characters.id[i]);
    const bool leads = route != nullptr && route->place == state.characters.place[i] && !route->path.empty();
    return leads ? route : nullptr;
}

void gatherExactCosts(const WorldState& state, const Group& group, std::vector<double>& costs) {
    costs.clear();
    const NearPlaces near(state, group);
    for (const std::int32_t i : group.members) {
        const OwnRoute* const route = state.ownRoutes.empty() ? nullptr : followedRoute(state, i);
        costs.push_back(route != nullptr ? std::max(0.0, route->cost - kCommitmentCost) : near.cost(i));
    }
}

void OwnRoutes::run(WorldState& state, std::span<const std::uint8_t> barred) {
    budget_ = kRouteOperations;
    dropEnded(state);
    begin(state, barred);
    goStraight(state);
    for (std::size_t k = 0; k < state.ownRoutes.size(); ++k) follow(state, index_[k], state.ownRoutes[k]);
}

}  // namespace muster
