#include "engine/formation/places/place_tracker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

// Operations after which path searches end in a step, of 10 to 100 ns each.
constexpr std::int64_t kPathOperations = 15000;
constexpr double kLeastProgress = 0.1;  // Share of a step below which a place that moves is blocked.
// Speed of reachable targets towards their targets, in top speeds of places.
constexpr double kAttractionSpeed = 2.0;
// Distance that a goal moves before a new path is searched [m]
constexpr double kReplanDistance = 1.0;
constexpr std::size_t kReservedCorners = 64;  // Number of corners for which a new path has memory.
constexpr std::size_t kReservedPaths = 512;   // Number of paths for which there is memory at first.
constexpr double kGoalInSight = 20.0;  // Distance from which on the goal is looked for on a long route [m].
// Steps between two requests of a place that a moving obstacle bars on its path.
constexpr std::uint32_t kBarredTurns = 8;
constexpr double kReplanShare = 0.25;  // and the same as a share of the straight distance to it.
// Length of the line to a goal that is tested in each step; the rest is tested when the place has come that
// far [m].
constexpr double kTestedLength = 4.0;
constexpr double kSightPeriod = 0.25;
// Greatest number of cells over which places that jumped are put in order.
constexpr std::int32_t kMostOrdered = 20000;
constexpr std::size_t kRanks = 24;        // Number of ranks in which places may cross each other,
constexpr int kRankPasses = 4;            // and number of passes over them.
constexpr double kTargetRestMove = 5e-5;  // Movement below which a target rests [m].

// The index of the detour of a place, or of where it belongs in the list.
template <class Detours>
auto detourAt(Detours& detours, std::int32_t place) {
    return std::lower_bound(detours.begin(), detours.end(), place,
                            [](const auto& d, std::int32_t p) { return d.place < p; });
}

}  // namespace

// The arrays must fit together, and numbers be so small that steps stay finite.
bool PlaceTracker::consistent() const {
    const auto sane = [](Vec2 p) { return std::fabs(p.x) <= 1e10 && std::fabs(p.y) <= 1e10; };
    const std::size_t n = position_.size();
    if (velocity_.size() != n || targets_.fit.size() != n || targets_.reachable.size() != n ||
        targets_.target.size() != n)
        return false;
    for (std::size_t k = 0; k < n; ++k)
        for (const Vec2 p : {position_[k], velocity_[k], targets_.reachable[k], targets_.target[k]})
            if (!sane(p) || targets_.fit[k] > 1) return false;
    std::int32_t last = -1;
    for (const Detour& detour : detours_) {
        if (detour.place <= last || std::cmp_greater_equal(detour.place, n) || !sane(detour.goal))
            return false;
        if (!std::all_of(detour.path.begin(), detour.path.end(), sane)) return false;
        last = detour.place;
    }
    return ways_.sane();
}

void PlaceTracker::readTargets(std::span<const Vec2> targets, const Environment& environment) {
    const Box& box = environment.def().box;
    wanted_.assign(targets.begin(), targets.end());
    for (Vec2& p : wanted_)
        if (!isFinite(p)) p = (box.min + box.max) / 2.0;
    // The environment may keep pushing the mesh to and fro a little.
    const std::size_t known = std::min(wanted_.size(), targets_.target.size());
    for (std::size_t k = 0; k < known; ++k)
        if (targets_.reachable[k] != targets_.target[k] &&
            distance(wanted_[k], targets_.target[k]) < kTargetRestMove)
            wanted_[k] = targets_.target[k];
}

// Moves targets on ground that is cut off to the nearest ground of the region, all alike, as far as the
// farthest of them has to, so that they keep their arrangement.
void PlaceTracker::bringWithinReach(const FreeSpace& space) {
    asked_ = wanted_;
    if (space.undivided()) return;
    cutOff_.clear();
    const bool holds = reach_.size() == wanted_.size() && reachGraph_ == &space.routes() &&
                       reachVersion_ == space.routes().version() && reachRegion_ == space.region();
    if (!holds) reach_.assign(wanted_.size(), {{kInfiniteCost, 0.0}, {}, false});
    reachGraph_ = &space.routes();
    reachVersion_ = space.routes().version();
    reachRegion_ = space.region();
    Vec2 shift;
    for (std::size_t k = 0; k < wanted_.size(); ++k) {
        Reach& reach = reach_[k];
        if (!(reach.target == wanted_[k])) {
            reach = {wanted_[k], {}, space.isCutOff(wanted_[k])};
            if (reach.cutOff) reach.way = space.nearestInRegion(wanted_[k]) - wanted_[k];
        }
        if (!reach.cutOff) continue;
        cutOff_.push_back(static_cast<std::int32_t>(k));
        if (lengthSquared(reach.way) > lengthSquared(shift)) shift = reach.way;
    }
    for (const std::int32_t k : cutOff_) wanted_[k] += shift;
}

void PlaceTracker::separateAll(const PlaceDef& def, const RouteGraph& routes, std::int32_t region) {
    targets_.target = wanted_;
    targets_.reachable = wanted_;
    separateTargets(FreeSpace(def, routes, region, nearest_), def.apart(), targets_.reachable, targets_.fit,
                    separationMemory_);
}

// Reassigns points after targets have jumped: targets in walls may have any free points; they get them in the
// order of their last ones, so that places do not pass each other on their paths.
void PlaceTracker::keepOrder(const FreeSpace& space) {
    displaced_.clear();
    points_.clear();
    const std::size_t n = std::min(before_.size(), targets_.reachable.size());
    for (std::size_t k = 0; k < n; ++k)
        if (targets_.fit[k] != 0 && !space.contains(wanted_[k])) {
            displaced_.push_back(static_cast<std::int32_t>(k));
            points_.push_back(targets_.reachable[k]);
        }
    if (2 * displaced_.size() <= n) return;  // Single obstacles scatter no place far.
    const auto count = static_cast<std::int32_t>(displaced_.size());
    order_.begin(space.routes(), space.region(), 1.0);
    for (std::int32_t k = 0; k < count; ++k) {
        order_.add(k, before_[displaced_[k]]);
        order_.add(count + k, points_[k]);
    }
    if (!order_.order(kMostOrdered, inOrder_)) return;
    const auto isPlace = [&](std::int32_t k) { return k < count; };
    std::stable_partition(inOrder_.begin(), inOrder_.end(), isPlace);
    keepRows(std::span(inOrder_).first(count), std::span(inOrder_).last(count), count);
    for (std::int32_t k = 0; k < count; ++k)
        targets_.reachable[displaced_[inOrder_[k]]] = points_[inOrder_[count + k] - count];
}

// Exchanges points of near ranks where places would cross: the order along the ground says little of the
// order across it.
void PlaceTracker::keepRows(std::span<const std::int32_t> places, std::span<std::int32_t> points,
                            std::int32_t first) const {
    for (int pass = 0; pass < kRankPasses; ++pass)
        for (std::size_t a = 0; a < places.size(); ++a)
            for (std::size_t b = a + 1; b < std::min(places.size(), a + kRanks); ++b) {
                const Vec2 before = before_[displaced_[places[b]]] - before_[displaced_[places[a]]];
                const Vec2 after = points_[points[b] - first] - points_[points[a] - first];
                if (dot(before, after) < 0.0) std::swap(points[a], points[b]);
            }
}

// Moves single places. They do not interact with each other, only with the ground.
class PlaceTracker::Mover {
public:
    Mover(PlaceTracker& tracker, const PlaceDef& def, const RouteGraph& routes, double dt)
        : tracker_(tracker),
          def_(def),
          environment_(routes.environment()),
          speed_(environment_.travelSpeed()),
          space_(def, routes, -1, tracker.nearest_),
          dt_(dt),
          radius_(lineRadius(def)) {}

    PathNeed move(std::int32_t place, Detour* detour) {
        Vec2& position = tracker_.position_[place];
        const Vec2 goal = tracker_.targets_.reachable[place];
        const Vec2 before = position;
        const std::int32_t cell = space_.cellOf(before);
        const double reach = def_.maxSpeed * speed_[cell] * dt_;
        const double left = distance(before, goal);
        PathNeed need = PathNeed::None;
        // Mostly no obstacle is nearer than the goal.
        if (space_.clearanceAt(cell) < left + radius_)
            need = moveNearObstacles(position, goal, left, reach, detour, testsWholeLine(place));
        else if (before != goal)
            position = stepTowards(before, goal, left, reach);
        tracker_.velocity_[place] = dt_ > 0.0 ? (position - before) / dt_ : Vec2{};
        return need;
    }

private:
    PathNeed moveNearObstacles(Vec2& position, Vec2 goal, double left, double reach, Detour* detour,
                               bool whole) {
        if (position == goal && space_.isClear(position, radius_)) return PathNeed::None;
        // Routes are taut: the goal comes in sight near the end of one, and long lines are costly.
        const bool far = detour != nullptr && detour->path.size() > 2 && left > kGoalInSight;
        if (!far && goesStraight(position, goal, left, whole, detour != nullptr)) {
            position = stepTowards(position, goal, left, reach);
            return PathNeed::None;
        }
        if (environment_.distanceToObstacle(position) < radius_ ||
            !environment_.def().box.contains(position)) {
            escape(position, reach);
            return detour != nullptr ? PathNeed::KeepDetour : PathNeed::None;
        }
        if (detour != nullptr && !detour->path.empty()) {
            const PathNeed need = follow(position, *detour, reach);
            const double stale = std::max(kReplanDistance, kReplanShare * distance(position, goal));
            return distance(detour->goal, goal) > stale ? PathNeed::Search : need;
        }
        const bool searched = detour != nullptr && distance(detour->goal, goal) <= kReplanDistance;
        approach(position, goal, reach);
        return searched ? PathNeed::KeepDetour : PathNeed::Search;
    }

    // Rows of places do not test their lines in the same step.
    bool testsWholeLine(std::int32_t place) const {
        const std::uint32_t hash = static_cast<std::uint32_t>(place) * 2654435761u;
        const Vec2 phase{(hash >> 24) / 256.0, ((hash >> 16) & 255) / 256.0};
        const Vec2 now = tracker_.position_[place] / kSightPeriod + phase;
        const Vec2 before = now - tracker_.velocity_[place] * (dt_ / kSightPeriod);
        return std::floor(now.x) != std::floor(before.x) || std::floor(now.y) != std::floor(before.y);
    }

    // Long lines are costly, and mostly as clear as a step before.
    bool goesStraight(Vec2 from, Vec2 goal, double left, bool whole, bool onDetour) const {
        if (whole || left <= kTestedLength) return lineIsClear(from, goal, left);
        return !onDetour && lineIsClear(from, stepTowards(from, goal, left, kTestedLength), kTestedLength);
    }

    bool lineIsClear(Vec2 a, Vec2 b, double length) const {
        return space_.isClear(a, length + radius_) || environment_.clearLine(a, b, radius_);
    }

    static Vec2 stepTowards(Vec2 from, Vec2 to, double left, double reach) {
        return left <= reach ? to : from + (to - from) * (reach / left);
    }
    static Vec2 stepTowards(Vec2 from, Vec2 to, double reach) {
        return stepTowards(from, to, distance(from, to), reach);
    }

    // A moving obstacle lies over the place, which leaves it through the nearest surface.
    void escape(Vec2& position, double reach) {
        position = stepTowards(position, space_.project(position), reach);
    }

    // Follows the path; a new one is needed at its end, and where an obstacle blocks it.
    PathNeed follow(Vec2& position, Detour& detour, double reach) {
        std::size_t passed = 0;
        bool blocked = false;
        while (reach > 0.0 && passed < detour.path.size()) {
            const Vec2 corner = detour.path[passed];
            Vec2 next = stepTowards(position, corner, reach);
            blocked = !environment_.clearLine(position, next, radius_) && !slideAlong(position, next, reach);
            if (blocked) break;
            reach -= distance(position, next);
            position = next;
            if (next != corner) break;
            ++passed;
        }
        detour.path.erase(detour.path.begin(), detour.path.begin() + static_cast<std::ptrdiff_t>(passed));
        // An unreachable goal makes the place need a path until one has been searched.
        if (detour.path.empty()) detour.goal = position + Vec2{1e9, 0.0};
        return (blocked && hasTurn(detour.place)) || detour.path.empty() ? PathNeed::Search
                                                                         : PathNeed::KeepDetour;
    }

    // The round robin of searches goes on by one place in each step.
    bool hasTurn(std::int32_t place) const {
        const auto n = static_cast<std::uint32_t>(tracker_.position_.size());
        return (tracker_.nextPathSearch_ + static_cast<std::uint32_t>(place)) % std::min(kBarredTurns, n) ==
               0;
    }

    // Paths lead from cell to cell, and between two free cells an obstacle may protrude by a few centimetres.
    // The place then slides along it.
    bool slideAlong(Vec2 position, Vec2& next, double reach) const {
        next = stepTowards(position, environment_.projectToFreeSpace(next, def_.radius), reach);
        return distance(position, next) > kLeastProgress * reach &&
               environment_.clearLine(position, next, radius_);
    }

    // Until a path has been searched, the place moves straight as long as that is free.
    void approach(Vec2& position, Vec2 goal, double reach) {
        const Vec2 next = stepTowards(position, goal, reach);
        if (environment_.clearLine(position, next, radius_)) position = next;
    }

    PlaceTracker& tracker_;
    const PlaceDef& def_;
    const Environment& environment_;
    RasterView speed_;  // Travel speed per cell.
    FreeSpace space_;
    double dt_;      // Time step [s].
    double radius_;  // Radius for tests of lines [m].
};

// Removes detours and collects their memory.
template <class Drop>
void PlaceTracker::dropDetours(const Drop& drop) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < detours_.size(); ++k) {
        if (drop(detours_[k])) {
            detours_[k].path.clear();
            sparePaths_.push_back(std::move(detours_[k].path));
        } else {
            if (count != k) detours_[count] = std::move(detours_[k]);
            ++count;
        }
    }
    detours_.resize(count);
}

// Paths are searched where there are obstacles.
void PlaceTracker::reserve(const Environment& environment) {
    if (environment.obstacleIds().empty()) return;
    const std::size_t paths = std::min(position_.size(), kReservedPaths);
    detours_.reserve(position_.size());
    samples_.reserve(kReservedCorners);
    sparePaths_.reserve(position_.size());
    while (sparePaths_.size() < paths) sparePaths_.emplace_back().reserve(kReservedCorners);
    ways_.reserve();
    search_.reserve();
}

void PlaceTracker::reset(const PlaceDef& def, std::span<const Vec2> targets, const RouteGraph& routes,
                         std::int32_t region) {
    readTargets(targets, routes.environment());
    bringWithinReach(FreeSpace(def, routes, region, nearest_));
    separateAll(def, routes, region);
    position_ = targets_.reachable;
    velocity_.assign(position_.size(), {});
    detours_.clear();
    ways_.clear();
    reserve(routes.environment());
    nextPathSearch_ = targets_.nextSearch = targets_.quiet = targets_.pause = 0;
}

void PlaceTracker::lead(std::span<const Vec2> positions, double dt) {
    const std::size_t n = positions.size();
    position_.resize(n);
    velocity_.resize(n);
    for (std::size_t k = 0; k < n; ++k) velocity_[k] = (positions[k] - position_[k]) / dt;
    position_.assign(positions.begin(), positions.end());
    asked_ = targets_.target = targets_.reachable = position_;
    targets_.fit.assign(n, 1);
    dropDetours([](const Detour&) { return true; });
    reachRegion_ = -1;
}

void PlaceTracker::stand(std::span<const Vec2> positions) {
    lead(positions, 1.0);
    velocity_.assign(positions.size(), Vec2{});
}

void PlaceTracker::assemble(std::span<const Origin> origins) {
    std::vector<Vec2> position, velocity;
    ReachableTargets targets;
    std::vector<Detour> detours;
    std::vector<const PlaceTracker*> sources;
    for (std::size_t k = 0; k < origins.size(); ++k) {
        const Origin& origin = origins[k];
        const PlaceTracker* const from = origin.tracker;
        const std::size_t place = from != nullptr ? static_cast<std::size_t>(origin.place) : 0;
        position.push_back(from != nullptr ? from->position_[place] : origin.position);
        velocity.push_back(from != nullptr ? from->velocity_[place] : Vec2{});
        targets.fit.push_back(from != nullptr ? from->targets_.fit[place] : 1);
        targets.reachable.push_back(from != nullptr ? from->targets_.reachable[place] : origin.position);
        targets.target.push_back(from != nullptr ? from->targets_.target[place] : origin.position);
        if (from == nullptr) continue;
        if (std::find(sources.begin(), sources.end(), from) == sources.end()) sources.push_back(from);
        const auto detour = detourAt(from->detours_, origin.place);
        if (detour == from->detours_.end() || detour->place != origin.place) continue;
        detours.push_back(*detour);
        detours.back().place = static_cast<std::int32_t>(k);
    }
    for (const PlaceTracker* const from : sources)
        if (from != this) ways_.add(from->ways_);
    position_ = std::move(position);
    velocity_ = std::move(velocity);
    targets_ = std::move(targets);
    detours_ = std::move(detours);
    asked_ = targets_.target;
    nextPathSearch_ = 0;
    reachRegion_ = -1;
    reach_.clear();
    updateMemory_.resting.region = -1;
    updateMemory_.resting.proposals.clear();
}

namespace {

// The detour of a place. Where it has none one is inserted, with memory of paths that ended.
template <class Detours, class Paths>
auto& detourFor(Detours& detours, Paths& sparePaths, std::int32_t place) {
    auto at = detourAt(detours, place);
    if (at == detours.end() || at->place != place) {
        at = detours.emplace(at);
        at->place = place;
        if (!sparePaths.empty()) {
            at->path.swap(sparePaths.back());
            sparePaths.pop_back();
        }
        at->path.reserve(kReservedCorners);
    }
    return *at;
}

// The first place in [from, to) that needs a path search, or `to`.
template <class Need>
std::int32_t firstSearching(const std::vector<Need>& needs, Need search, std::int32_t from, std::int32_t to) {
    static_assert(sizeof(Need) == 1);
    if (from >= to) return to;
    const void* const at = std::memchr(needs.data() + from, static_cast<int>(search), to - from);
    return at != nullptr ? static_cast<std::int32_t>(static_cast<const Need*>(at) - needs.data()) : to;
}

}  // namespace

// Searches the paths that are needed, round robin, at least one in a step.
void PlaceTracker::searchPaths(RouteGraph& routes) {
    const auto n = static_cast<std::int32_t>(position_.size());
    if (n == 0) return;
    std::int64_t left = kPathOperations;
    const auto first = static_cast<std::int32_t>(nextPathSearch_ % static_cast<std::uint32_t>(n));
    nextPathSearch_ = static_cast<std::uint32_t>((first + 1) % n);
    const auto search = [&](std::int32_t place) {
        Detour& detour = detourFor(detours_, sparePaths_, place);
        detour.goal = targets_.reachable[place];
        left -= findPath(routes, position_[place], detour.goal, detour.path);
        if (left <= 0) nextPathSearch_ = static_cast<std::uint32_t>((place + 1) % n);
    };
    // Where no path was found the search is repeated when the round robin begins at the place.
    if (needs_[first] == PathNeed::KeepDetour && detourAt(detours_, first)->path.empty()) search(first);
    const auto searchAll = [&](std::int32_t from, std::int32_t to) {
        for (; left > 0 && (from = firstSearching(needs_, PathNeed::Search, from, to)) < to; ++from)
            search(from);
    };
    searchAll(first, n);
    searchAll(0, first);
}

void PlaceTracker::moveAll(Mover& mover, ThreadPool* pool) {
    const std::size_t n = position_.size();
    needs_.resize(n);
    forChunks(pool, (n + kPerTask - 1) / kPerTask, 1, [&](std::size_t chunk) {
        const auto first = static_cast<std::int32_t>(chunk * kPerTask);
        const auto end = static_cast<std::int32_t>(std::min(n, (chunk + 1) * kPerTask));
        auto next = detourAt(detours_, first);
        for (std::int32_t place = first; place < end; ++place) {
            const bool known = next != detours_.end() && next->place == place;
            needs_[place] = mover.move(place, known ? &*next : nullptr);
            if (known) ++next;
        }
    });
}

void PlaceTracker::advance(const PlaceDef& def, std::span<const Vec2> targets, RouteGraph& routes,
                           std::int32_t region, double dt, ThreadPool* pool) {
    readTargets(targets, routes.environment());
    const FreeSpace space(def, routes, region, nearest_);
    bringWithinReach(space);
    TargetUpdate update(space, def.apart(), kAttractionSpeed * def.maxSpeed * dt, targets_, updateMemory_);
    before_ = targets_.reachable;
    if (!update.run(wanted_, pool)) {
        separateAll(def, routes, region);
        keepOrder(space);
    }
    const std::vector<Vec2>& reachable = targets_.reachable;
    const std::size_t n = reachable.size();
    const std::size_t old = std::min({position_.size(), velocity_.size(), n});
    position_.resize(old);
    position_.insert(position_.end(), reachable.begin() + static_cast<std::ptrdiff_t>(old), reachable.end());
    velocity_.resize(old);
    velocity_.resize(n, {});
    dropDetours([&](const Detour& d) { return d.place < 0 || std::cmp_greater_equal(d.place, n); });
    ways_.age();
    Mover mover(*this, def, routes, dt);
    moveAll(mover, pool);
    dropDetours([&](const Detour& d) { return needs_[d.place] == PathNeed::None; });
    searchPaths(routes);
}

}  // namespace muster
