#include "muster/formation/place_tracker.h"

#include <algorithm>
#include <cmath>

#include "formation/place_spacing.h"

namespace muster {
namespace {

constexpr int kSpacingRounds = 8;        // Of moving targets apart.
constexpr std::int32_t kPathsPerStep = 8;  // Searches for a way round, so that the cost of a step is bounded.
constexpr double kReplanDistance = 1.0;  // A goal that moved farther asks for a new way [m].

// Lines are tested with slightly less than the radius: places stand and ways run exactly at it.
double lineRadius(const PlaceDef& def) { return def.radius - std::min(1e-3, 0.01 * def.radius); }

bool boxHolds(const Box& box, Vec2 p, double margin) { return box.grown(-margin).contains(p); }

// The nearest point where a disc is free, in the region (any region where negative).
Vec2 reachable(const Environment& environment, Vec2 p, const PlaceDef& def, std::int32_t region) {
    const double radius = def.radius + def.clearance;
    const bool free = boxHolds(environment.def().box, p, radius) && environment.distanceToObstacle(p) >= radius;
    if (free && (region < 0 || environment.region(p, def.radius) == region)) return p;
    const Vec2 pushed = free ? p : environment.pushOut(p, radius);
    if (region < 0 || environment.region(pushed, def.radius) == region) return pushed;
    const Vec2 inside = environment.nearestInRegion(p, def.radius, region);
    // The cell's centre may lack the clearance; it is kept where gaining that would leave the region.
    const Vec2 clear = environment.pushOut(inside, radius);
    return environment.region(clear, def.radius) == region ? clear : inside;
}

}  // namespace

void PlaceTracker::findGoals(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
                             std::int32_t region) {
    const std::size_t n = targets.size();
    goal_.resize(n);
    fit_.assign(n, 1);
    const Box& box = environment.def().box;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 target = isFinite(targets[k]) ? targets[k] : (box.min + box.max) / 2.0;
        goal_[k] = reachable(environment, target, def, region);
    }
    const double apart = 2.0 * def.radius;
    for (int round = 0; round < kSpacingRounds; ++round) {
        moved_.assign(n, 0);
        if (!partClosePairs(goal_, apart, spacing_, moved_)) return;
        for (std::size_t k = 0; k < n; ++k)
            if (moved_[k] != 0) goal_[k] = reachable(environment, goal_[k], def, region);
    }
    markUnfit(goal_, apart * (1.0 - 1e-9), spacing_, fit_);
}

// Moves places one after the other; they do not look at each other, only at the ground.
class PlaceTracker::Mover {
public:
    Mover(PlaceTracker& tracker, const PlaceDef& def, const Environment& environment, double dt)
        : tracker_(tracker), def_(def), environment_(environment), dt_(dt), radius_(lineRadius(def)) {}

    void move(std::size_t place, Detour* detour, bool& detourEnds) {
        Vec2& position = tracker_.position_[place];
        const Vec2 goal = tracker_.goal_[place];
        const Vec2 before = position;
        const std::int32_t cell = environment_.grid().index(environment_.grid().nearestCell(position));
        const double reach = def_.maxSpeed * environment_.travelSpeed()[static_cast<std::size_t>(cell)] * dt_;
        detourEnds = false;
        const double room = environment_.distanceToObstacle(position);
        if (room < radius_ || !environment_.def().box.contains(position)) {
            escape(position, reach);
        } else if (lineIsClear(position, goal, room)) {
            position = stepTowards(position, goal, reach);
            detourEnds = true;
        } else if (detour != nullptr && !detour->way.empty()) {
            follow(position, *detour, reach);
            detourEnds = detour->way.empty();
        } else {
            approach(position, goal, reach);
        }
        tracker_.velocity_[place] = dt_ > 0.0 ? (position - before) / dt_ : Vec2{};
    }

    // True where the place has to look for a way: none yet, its goal has left, or it is blocked.
    bool wantsPath(std::size_t place, const Detour* detour) const {
        const Vec2 position = tracker_.position_[place];
        const Vec2 goal = tracker_.goal_[place];
        if (detour != nullptr && distance(detour->goal, goal) <= kReplanDistance) {
            if (detour->way.empty()) return false;
            return !environment_.clearLine(position, detour->way.front(), radius_);
        }
        const double room = environment_.distanceToObstacle(position);
        return room >= radius_ && !lineIsClear(position, goal, room);
    }

private:
    bool lineIsClear(Vec2 a, Vec2 b, double room) const {
        const double way = distance(a, b);
        if (way == 0.0) return true;
        if (room >= way + radius_ && environment_.def().box.grown(-radius_).contains(b)) return true;
        return environment_.clearLine(a, b, radius_);
    }

    static Vec2 stepTowards(Vec2 from, Vec2 to, double reach) {
        const double way = distance(from, to);
        return way <= reach ? to : from + (to - from) * (reach / way);
    }

    // A moving obstacle has run over the place: out by the nearest way, never through.
    void escape(Vec2& position, double reach) {
        position = stepTowards(position, environment_.pushOut(position, def_.radius + def_.clearance), reach);
    }

    void follow(Vec2& position, Detour& detour, double reach) {
        std::size_t passed = 0;
        while (reach > 0.0 && passed < detour.way.size()) {
            const Vec2 corner = detour.way[passed];
            const Vec2 next = stepTowards(position, corner, reach);
            if (!environment_.clearLine(position, next, radius_)) break;
            reach -= distance(position, next);
            position = next;
            if (next != corner) break;
            ++passed;
        }
        detour.way.erase(detour.way.begin(), detour.way.begin() + static_cast<std::ptrdiff_t>(passed));
    }

    // Until it is its turn to find a way, a place goes as far as the straight line lets it.
    void approach(Vec2& position, Vec2 goal, double reach) {
        const Vec2 next = stepTowards(position, goal, reach);
        if (environment_.clearLine(position, next, radius_)) position = next;
    }

    PlaceTracker& tracker_;
    const PlaceDef& def_;
    const Environment& environment_;
    double dt_;
    double radius_;
};

void PlaceTracker::reset(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
                         std::int32_t region) {
    findGoals(def, targets, environment, region);
    position_ = goal_;
    velocity_.assign(goal_.size(), {});
    detours_.clear();
    turn_ = 0;
}

void PlaceTracker::findWays(const PlaceDef& def, const Environment& environment, const Mover& mover) {
    const std::size_t n = position_.size();
    std::int32_t left = kPathsPerStep;
    const auto byPlace = [](const Detour& d, std::int32_t place) { return d.place < place; };
    for (std::size_t k = 0; k < n && left > 0; ++k) {
        const std::size_t place = (turn_ + k) % n;
        const auto index = static_cast<std::int32_t>(place);
        auto at = std::lower_bound(detours_.begin(), detours_.end(), index, byPlace);
        const bool known = at != detours_.end() && at->place == index;
        // Where no way was found it is looked for again when the place's turn comes first.
        const bool again = known && at->way.empty() && k == 0;
        if (!again && !mover.wantsPath(place, known ? &*at : nullptr)) continue;
        if (!known) at = detours_.insert(at, Detour{});
        at->place = index;
        at->goal = goal_[place];
        at->way = environment.findPath(position_[place], goal_[place], def.radius);
        --left;
        if (left == 0) {
            turn_ = static_cast<std::uint32_t>((place + 1) % n);
            return;
        }
    }
    turn_ = n > 0 ? static_cast<std::uint32_t>((turn_ + 1) % n) : 0;
}

void PlaceTracker::advance(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
                           std::int32_t region, double dt) {
    findGoals(def, targets, environment, region);
    const std::size_t n = goal_.size();
    const std::size_t old = std::min({position_.size(), velocity_.size(), n});
    position_.resize(old);
    position_.insert(position_.end(), goal_.begin() + static_cast<std::ptrdiff_t>(old), goal_.end());
    velocity_.resize(old);
    velocity_.resize(n, {});
    std::erase_if(detours_, [&](const Detour& d) { return d.place < 0 || static_cast<std::size_t>(d.place) >= n; });
    Mover mover(*this, def, environment, dt);
    findWays(def, environment, mover);
    std::size_t next = 0;
    std::size_t kept = 0;
    for (std::size_t place = 0; place < n; ++place) {
        const bool known = next < detours_.size() && static_cast<std::size_t>(detours_[next].place) == place;
        bool ends = false;
        mover.move(place, known ? &detours_[next] : nullptr, ends);
        if (!known) continue;
        if (!ends) {
            if (kept != next) detours_[kept] = std::move(detours_[next]);
            ++kept;
        }
        ++next;
    }
    detours_.resize(kept);
}

}  // namespace muster
