#include "engine/systems/steering/own_routes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engine/state/held_ground.h"

namespace muster {
namespace {

constexpr double kCampsFor = 6.0;    // Who camps for this long gets a route [s].
constexpr double kRouteFor = 30.0;   // A route is followed for this long at most [s].
constexpr double kGoalMoved = 0.5;   // A place this far from where it was gets a new route [m].
constexpr double kCommitment = 0.5;  // A place with a route counts as nearer by this, so that it is kept [m].
constexpr double kNearPlace = 1.0;   // From here on the straight line to a place is tested [m].
constexpr double kAtPlace = 0.02;    // From here on it needs no test [m].
constexpr double kMisled = 1.2;      // A cost above this times the straight line is no line of sight,
constexpr double kMisledBy = 0.05;   // and this [m].
constexpr double kAtCorner = 0.1;    // A corner this near is reached [m].
constexpr std::uint32_t kSearchTurns = 8;   // Each may search in one step of so many.
constexpr std::int64_t kRouteWork = 12000;  // Searches begin in a step until they have used so much.
constexpr std::size_t kMostClosed = 16;     // Of those who hold their ground, round whom a search goes.
constexpr double kTightMargin = 0.02;       // Kept from them where there is no wider way [m].
constexpr double kSlowMargin = 0.1;         // Kept from slow ground that a route goes round [m].
constexpr double kNoSlower = 1e-6;          // Rounding of lengths that are compared [m].
constexpr double kMovingReach = 6.0;        // Of the discomfort round moving obstacles [m].

// In metres of open ground.
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

// Rasters do not know every line along a wall; near its place a character goes by the exact ground.
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

    // The straight line to its place [m]; -1 where it is not clear, or the raster tells all.
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
    // True where ground may cost more than its length, because something moves there.
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

// True for who has been on its way for long without getting farther than about a step or two.
bool OwnRoutes::camps(const WorldState& state, std::int32_t i) {
    const WalkProgress& walk = state.characters.walk[i];
    return (state.stepCount - walk.campedAt) * state.parameters.stepTime >= kCampsFor;
}

// Finds the characters of routes, and drops the routes of those who left, arrived, or took too long.
void OwnRoutes::dropEnded(WorldState& state) {
    const Characters& c = state.characters;
    std::vector<OwnRoute>& routes = state.ownRoutes;
    index_.clear();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < routes.size(); ++k) {
        const std::int32_t i = c.indexOf(routes[k].character);
        const bool known = i >= 0;
        const bool arrived = known && c.walk[i].within &&
                             (state.stepCount - c.walk[i].since) * state.parameters.stepTime >= kStayedFor;
        const bool late = (state.stepCount - routes[k].since) * state.parameters.stepTime > kRouteFor;
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

// A cross on each of the nearest who hold their ground, as wide as both bodies; who is nearer goes out
// between them.
void OwnRoutes::closeHeld(const WorldState& state, std::int32_t i, double margin) {
    const Vec2 from = state.characters.position[i];
    const Group& group = state.groups[state.characters.group[i]];
    listHeld(state, group, held_);
    const std::size_t count = std::min(held_.size(), kMostClosed);
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

// Closes a patch at a little distance, so that a route leads past it. False where an end of the route lies in
// it, or it is closed.
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

// Closes the slow patches that the route of the last search leads into, but for those in which it begins or
// ends. False where there are none that are still open.
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

// Where the shortest route leads over slow ground, the one round that is taken if it is quicker.
void OwnRoutes::avoidSlow(WorldState& state, std::int32_t i, std::vector<Vec2>& path) {
    const Environment& environment = state.environment;
    const Vec2 from = state.characters.position[i];
    double least = lengthFrom(environment, from, path);
    while (budget_ > 0 && closeSlow(environment) &&
           find(state, i, closed_, kRouteWork) == RouteStatus::Found && search_.path().size() > 1) {
        const auto round = std::span(search_.path()).subspan(1);
        const double length = lengthFrom(environment, from, round);
        if (length >= least) continue;
        least = length;
        path.assign(round.begin(), round.end());
    }
}

// False where no way leads to the place.
bool OwnRoutes::search(WorldState& state, std::int32_t i, OwnRoute& route) {
    route.place = state.characters.place[i];
    route.goal = placeOf(state, i);
    constexpr std::int64_t kWhole = std::numeric_limits<std::int64_t>::max();
    RouteStatus status = RouteStatus::Unreachable;
    for (const double margin : {kHeldMargin, kTightMargin}) {
        closeHeld(state, i, margin);
        status = find(state, i, closed_, closed_.empty() ? kWhole : kRouteWork);
        if (status != RouteStatus::Unreachable || closed_.empty()) break;
    }
    // Where those who hold their ground leave no way, or none that is soon found, it waits for one before
    // them.
    if (status != RouteStatus::Found && !closed_.empty()) status = find(state, i, {}, kWhole);
    if (status != RouteStatus::Found || search_.path().size() < 2) return false;
    route.path.assign(search_.path().begin() + 1, search_.path().end());
    if (!state.environment.patchIds().empty()) avoidSlow(state, i, route.path);
    return true;
}

// Those who camp or are barred get a route, as far as the budget goes.
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
    const bool moved = route.place != c.place[i] || distance(route.goal, placeOf(state, i)) > kGoalMoved;
    const bool lost = route.path.empty() || !ground.lineClear(here, route.path.front());
    if ((moved || lost) && hasTurn(state, i) && budget_ > 0) search(state, i, route);
    if (route.place != c.place[i] || route.path.empty()) return;
    bool listed = false;
    const bool moving = !state.environment.movingObstacleAreas().empty();
    const auto sees = [&](Vec2 corner, Vec2 p) {
        if (!ground.lineClear(here, p)) return false;
        if (moving && !state.environment.clearLine(here, p, ground.radius())) return false;
        const Vec2 round[] = {corner, p};
        if (state.environment.travelLength(here, p) > lengthFrom(state.environment, here, round) + kNoSlower)
            return false;
        if (!listed) listHeld(state, state.groups[c.group[i]], held_);
        listed = true;
        return clearOf(held_, here, p, routesFor(state, i).radius());
    };
    std::size_t passed = 0;
    while (passed + 1 < route.path.size() && (distance(here, route.path[passed]) < kAtCorner ||
                                              sees(route.path[passed], route.path[passed + 1])))
        ++passed;
    route.path.erase(route.path.begin(), route.path.begin() + static_cast<std::ptrdiff_t>(passed));
    if (route.path.size() == 1) route.path.front() = placeOf(state, i);
    route.cost = static_cast<float>(lengthFrom(state.environment, here, route.path));
    c.direction[i] = normalized(route.path.front() - here, c.direction[i]);
    c.cost[i] = route.cost;
}

// Near its place nobody goes round where the straight line is clear.
void OwnRoutes::goStraight(WorldState& state) {
    Characters& c = state.characters;
    const auto count = static_cast<std::int32_t>(c.size());
    for (std::int32_t i = 0; i < count; ++i) {
        if (c.place[i] < 0) continue;
        const Vec2 way = placeOf(state, i) - c.position[i];
        const double left = length(way);
        if (left > kNearPlace || !(c.cost[i] > kMisled * left + kMisledBy) ||
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
        costs.push_back(route != nullptr ? std::max(0.0, route->cost - kCommitment) : near.cost(i));
    }
}

void OwnRoutes::run(WorldState& state, std::span<const std::uint8_t> barred) {
    budget_ = kRouteWork;
    dropEnded(state);
    begin(state, barred);
    goStraight(state);
    for (std::size_t k = 0; k < state.ownRoutes.size(); ++k) follow(state, index_[k], state.ownRoutes[k]);
}

}  // namespace muster
