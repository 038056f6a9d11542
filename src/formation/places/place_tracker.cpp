#include "formation/places/place_tracker.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "formation/places/goal_carrier.h"
#include "formation/places/place_goals.h"
#include "formation/places/place_spacing.h"

namespace muster {
namespace {

constexpr int kSpacingRounds = 8;          // Of moving targets apart.
constexpr std::int32_t kPathsPerStep = 3;  // Searches for a way round, so that the cost of a step is bounded.
constexpr double kMetresPerStep = 12.0;    // As the crow flies, of all these searches but the last.
constexpr double kGrazed = 0.1;            // Who gets on by less than this share of a step is blocked.
// Goals beside their targets are drawn to them at so many top speeds.
constexpr double kDrawn = 2.0;
constexpr std::size_t kChunk = 256;      // Places a task moves.
constexpr double kReplanDistance = 1.0;  // A goal that moved farther asks for a new way [m],
constexpr double kReplanShare = 0.25;    // and farther than this share of what is left as the crow flies.

}  // namespace

PlaceTracker::PlaceTracker() : carry_(std::make_unique<CarryMemory>()) {}
PlaceTracker::~PlaceTracker() = default;
PlaceTracker::PlaceTracker(PlaceTracker&&) noexcept = default;
PlaceTracker& PlaceTracker::operator=(PlaceTracker&&) noexcept = default;

// What was read must fit together, and numbers be such that steps stay finite.
bool PlaceTracker::consistent() const {
    const auto sane = [](Vec2 p) { return std::fabs(p.x) <= 1e10 && std::fabs(p.y) <= 1e10; };
    const std::size_t n = position_.size();
    if (velocity_.size() != n || fit_.size() != n || goal_.size() != n || target_.size() != n) return false;
    for (std::size_t k = 0; k < n; ++k)
        for (const Vec2 p : {position_[k], velocity_[k], goal_[k], target_[k]})
            if (!sane(p) || fit_[k] > 1) return false;
    std::int32_t last = -1;
    for (const Detour& detour : detours_) {
        if (detour.place <= last || static_cast<std::size_t>(detour.place) >= n || !sane(detour.goal))
            return false;
        if (!std::all_of(detour.way.begin(), detour.way.end(), sane)) return false;
        last = detour.place;
    }
    return true;
}

void PlaceTracker::readTargets(std::span<const Vec2> targets, const Environment& environment) {
    const Box& box = environment.def().box;
    wanted_.assign(targets.begin(), targets.end());
    for (Vec2& p : wanted_)
        if (!isFinite(p)) p = (box.min + box.max) / 2.0;
}

// All anew, whatever they were.
void PlaceTracker::findGoals(const PlaceDef& def, const Environment& environment, std::int32_t region) {
    const PlaceGround ground(def, environment, region);
    const std::size_t n = wanted_.size();
    target_ = wanted_;
    goal_.resize(n);
    fit_.assign(n, 1);
    for (std::size_t k = 0; k < n; ++k) goal_[k] = ground.reachable(wanted_[k]);
    const double apart = 2.0 * def.radius;
    mark_.assign(n, 1);
    spacing_.foundAt.clear();
    for (int round = 0; round < kSpacingRounds; ++round) {
        if (!partClosePairs(goal_, apart, spacing_, mark_)) return;
        for (std::size_t k = 0; k < n; ++k)
            if (mark_[k] != 0) goal_[k] = ground.reachable(goal_[k]);
    }
    markUnfit(goal_, apart * (1.0 - 1e-9), spacing_, fit_);
    seatUnfit(ground, apart, goal_, fit_, spacing_);
}

// Moves places one after the other; they do not look at each other, only at the ground.
class PlaceTracker::Mover {
public:
    Mover(PlaceTracker& tracker, const PlaceDef& def, const Environment& environment, double dt)
        : tracker_(tracker),
          def_(def),
          environment_(environment),
          speed_(environment.travelSpeed()),
          ground_(def, environment, -1),
          dt_(dt),
          radius_(lineRadius(def)) {}

    // What a place needs after its step.
    enum class Need { Nothing, Way, KeepsDetour };

    Need move(std::size_t place, Detour* detour) {
        Vec2& position = tracker_.position_[place];
        const Vec2 goal = tracker_.goal_[place];
        const Vec2 before = position;
        const std::size_t cell = ground_.cellOf(before);
        const double reach = def_.maxSpeed * speed_[cell] * dt_;
        const double way = distance(before, goal);
        Need need = Need::Nothing;
        // Mostly there is room all round up to the goal.
        if (ground_.roomAt(cell) < way + radius_)
            need = moveAmong(position, goal, way, reach, detour);
        else if (before != goal)
            position = stepTowards(before, goal, way, reach);
        tracker_.velocity_[place] = dt_ > 0.0 ? (position - before) / dt_ : Vec2{};
        return need;
    }

private:
    // Where obstacles may be in the way.
    Need moveAmong(Vec2& position, Vec2 goal, double way, double reach, Detour* detour) {
        if (position == goal && ground_.roomy(position, radius_)) return Need::Nothing;
        if (lineIsClear(position, goal, way)) {
            position = stepTowards(position, goal, way, reach);
            return Need::Nothing;
        }
        if (environment_.distanceToObstacle(position) < radius_ ||
            !environment_.def().box.contains(position)) {
            escape(position, reach);
            return detour != nullptr ? Need::KeepsDetour : Need::Nothing;
        }
        if (detour != nullptr && !detour->way.empty()) {
            const Need need = follow(position, *detour, reach);
            const double stale = std::max(kReplanDistance, kReplanShare * distance(position, goal));
            return distance(detour->goal, goal) > stale ? Need::Way : need;
        }
        const bool sought = detour != nullptr && distance(detour->goal, goal) <= kReplanDistance;
        approach(position, goal, reach);
        return sought ? Need::KeepsDetour : Need::Way;
    }

    bool lineIsClear(Vec2 a, Vec2 b, double way) const {
        return ground_.roomy(a, way + radius_) || environment_.clearLine(a, b, radius_);
    }

    static Vec2 stepTowards(Vec2 from, Vec2 to, double way, double reach) {
        return way <= reach ? to : from + (to - from) * (reach / way);
    }
    static Vec2 stepTowards(Vec2 from, Vec2 to, double reach) {
        return stepTowards(from, to, distance(from, to), reach);
    }

    // A moving obstacle has run over the place: out by the nearest way, never through.
    void escape(Vec2& position, double reach) {
        position = stepTowards(position, environment_.projectToFreeSpace(position, ground_.clearRadius()), reach);
    }

    // Goes on along the way; a new one is needed at its end, and where something has come between.
    Need follow(Vec2& position, Detour& detour, double reach) {
        std::size_t passed = 0;
        bool blocked = false;
        while (reach > 0.0 && passed < detour.way.size()) {
            const Vec2 corner = detour.way[passed];
            Vec2 next = stepTowards(position, corner, reach);
            blocked = !environment_.clearLine(position, next, radius_) && !graze(position, next, reach);
            if (blocked) break;
            reach -= distance(position, next);
            position = next;
            if (next != corner) break;
            ++passed;
        }
        detour.way.erase(detour.way.begin(), detour.way.begin() + static_cast<std::ptrdiff_t>(passed));
        // Its goal is forgotten, so that a place at the end of its way asks again until it is served.
        if (detour.way.empty()) detour.goal = position + Vec2{1e9, 0.0};
        return blocked || detour.way.empty() ? Need::Way : Need::KeepsDetour;
    }

    // Ways lead from cell to cell, and between two free cells an obstacle may stand out by a few centimetres:
    // along it.
    bool graze(Vec2 position, Vec2& next, double reach) const {
        next = stepTowards(position, environment_.projectToFreeSpace(next, def_.radius), reach);
        return distance(position, next) > kGrazed * reach && environment_.clearLine(position, next, radius_);
    }

    // Until it is its turn to find a way, a place goes as far as the straight line lets it.
    void approach(Vec2& position, Vec2 goal, double reach) {
        const Vec2 next = stepTowards(position, goal, reach);
        if (environment_.clearLine(position, next, radius_)) position = next;
    }

    PlaceTracker& tracker_;
    const PlaceDef& def_;
    const Environment& environment_;
    std::span<const float> speed_;  // Travel speed of cells.
    PlaceGround ground_;
    double dt_;
    double radius_;
};

// Forgets detours, but not their memory.
template <class Drop>
void PlaceTracker::dropDetours(const Drop& drop) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < detours_.size(); ++k) {
        if (drop(detours_[k])) {
            detours_[k].way.clear();
            spareWays_.push_back(std::move(detours_[k].way));
        } else {
            if (kept != k) detours_[kept] = std::move(detours_[k]);
            ++kept;
        }
    }
    detours_.resize(kept);
}

void PlaceTracker::reset(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
                         std::int32_t region) {
    readTargets(targets, environment);
    findGoals(def, environment, region);
    position_ = goal_;
    velocity_.assign(goal_.size(), {});
    detours_.clear();
    turn_ = seatTurn_ = 0;
}

namespace {

// The detour of a place, or where it belongs among the others.
template <class Detours>
auto detourAt(Detours& detours, std::size_t place) {
    return std::lower_bound(detours.begin(), detours.end(), static_cast<std::int32_t>(place),
                            [](const auto& d, std::int32_t p) { return d.place < p; });
}

// The detour of a place, put among the others where it has none yet, with memory of ways that ended.
template <class Detours, class Ways>
auto& detourFor(Detours& detours, Ways& spareWays, std::size_t place) {
    auto at = detourAt(detours, place);
    if (at == detours.end() || static_cast<std::size_t>(at->place) != place) {
        at = detours.emplace(at);
        at->place = static_cast<std::int32_t>(place);
        if (!spareWays.empty()) {
            at->way.swap(spareWays.back());
            spareWays.pop_back();
        }
    }
    return *at;
}

// The first of the places in [from, to) that bears a mark, or `to`.
std::size_t firstMarked(const std::vector<std::uint8_t>& marks, std::uint8_t mark, std::size_t from,
                        std::size_t to) {
    const void* const at = from < to ? std::memchr(marks.data() + from, mark, to - from) : nullptr;
    return at != nullptr ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(at) - marks.data()) : to;
}

}  // namespace

// Marks: 0 needs nothing, 1 needs a way, 2 keeps its detour. Few ways are sought per step, in turns.
void PlaceTracker::findWays(const PlaceDef& def, const Environment& environment) {
    const std::size_t n = position_.size();
    if (n == 0) return;
    std::int32_t left = kPathsPerStep;
    const std::size_t first = turn_ % n;
    turn_ = static_cast<std::uint32_t>((first + 1) % n);
    double metres = kMetresPerStep;
    const auto seek = [&](std::size_t place) {
        Detour& detour = detourFor(detours_, spareWays_, place);
        detour.goal = goal_[place];
        environment.findPath(position_[place], goal_[place], def.radius, detour.way);
        metres -= distance(position_[place], goal_[place]);
        left = metres > 0.0 ? left - 1 : 0;
        if (left == 0) turn_ = static_cast<std::uint32_t>((place + 1) % n);
    };
    // Where no way was found it is sought again when the place's turn comes first.
    if (mark_[first] == 2 && detourAt(detours_, first)->way.empty()) seek(first);
    const auto seekAll = [&](std::size_t from, std::size_t to) {
        for (; left > 0 && (from = firstMarked(mark_, 1, from, to)) < to; ++from) seek(from);
    };
    seekAll(first, n);
    seekAll(0, first);
}

// By chunks: a place looks at nothing but the ground, and has its own detour.
void PlaceTracker::moveAll(Mover& mover, ThreadPool* pool) {
    const std::size_t n = position_.size();
    mark_.resize(n);
    const auto task = [&](std::int32_t chunk, std::int32_t) {
        const auto first = static_cast<std::size_t>(chunk) * kChunk;
        auto next = detourAt(detours_, first);
        for (std::size_t place = first; place < std::min(n, first + kChunk); ++place) {
            const bool known = next != detours_.end() && static_cast<std::size_t>(next->place) == place;
            mark_[place] = static_cast<std::uint8_t>(mover.move(place, known ? &*next : nullptr));
            if (known) ++next;
        }
    };
    const auto chunks = static_cast<std::int32_t>((n + kChunk - 1) / kChunk);
    if (pool != nullptr && chunks > 1)
        pool->run(chunks, task);
    else
        for (std::int32_t c = 0; c < chunks; ++c) task(c, 0);
}

void PlaceTracker::advance(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
                           std::int32_t region, double dt, ThreadPool* pool) {
    readTargets(targets, environment);
    const PlaceGround ground(def, environment, region);
    const GoalState state{goal_, target_, fit_, seatTurn_};
    GoalCarrier carrier(ground, 2.0 * def.radius, kDrawn * def.maxSpeed * dt, state, *carry_);
    if (!carrier.run(wanted_, pool)) findGoals(def, environment, region);
    const std::size_t n = goal_.size();
    const std::size_t old = std::min({position_.size(), velocity_.size(), n});
    position_.resize(old);
    position_.insert(position_.end(), goal_.begin() + static_cast<std::ptrdiff_t>(old), goal_.end());
    velocity_.resize(old);
    velocity_.resize(n, {});
    dropDetours([&](const Detour& d) { return d.place < 0 || static_cast<std::size_t>(d.place) >= n; });
    Mover mover(*this, def, environment, dt);
    moveAll(mover, pool);
    dropDetours([&](const Detour& d) { return mark_[d.place] == 0; });
    findWays(def, environment);
}

}  // namespace muster
