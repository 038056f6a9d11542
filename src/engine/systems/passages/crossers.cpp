#include "engine/systems/passages/crossers.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"
#include "engine/passages/way_number.h"
#include "engine/state/held_ground.h"
#include "engine/systems/passages/goals.h"

namespace muster {
namespace {

constexpr std::size_t kMaxChoices = 6;  // Greatest number of passages in one choice.
// Share of the walk between two passages above which a detour leads past one of them.
constexpr double kPastShare = 0.75;
constexpr double
    // Ratio of a route through a passage to the planned route above which the passage is not needed...
    kDetourRatio = 1.25;
constexpr double kDetourCost = 2.0;  // ... if the difference is also above this cost [m].
// Distance between a place and its foreseen goal up to which they count as the same [m].
constexpr double kSameGoal = 0.5;
constexpr double kWaitDistance = 0.4;  // Distance before a passage at which people wait [m].

/// The point where people on the left or right side of a passage wait for it.
Vec2 mouthOf(const Passage& passage, bool onLeft) {
    const Vec2 left = perpendicular((passage.b - passage.a) / passage.width());
    return passage.middle() + left * (onLeft ? passage.left + kWaitDistance : -passage.right - kWaitDistance);
}

/// True where the middle of a body of this radius has room somewhere on the passage beside agents that hold
/// their ground.
bool hasRoom(const Passage& passage, std::span<const HeldSpot> held, double radius) {
    const Vec2 along = (passage.b - passage.a) / passage.width();
    const double end = passage.width() - radius;
    double open = radius;
    // Moves on from one end: an agent that covers the farthest open point moves it behind itself.
    for (bool moved = true; moved && open <= end;) {
        moved = false;
        for (const HeldSpot& spot : held) {
            const Vec2 to = spot.position - passage.a;
            const double reach = spot.radius + radius, beside = cross(along, to);
            if (std::fabs(beside) >= reach) continue;
            const double half = std::sqrt(reach * reach - beside * beside), middle = dot(along, to);
            if (middle - half > open || middle + half <= open) continue;
            open = middle + half;
            moved = true;
        }
    }
    return open <= end;
}

}  // namespace

void Crossers::findHeld(const WorldState& state) {
    passages_ = state.passages.size();
    held_.clear();
    if (std::none_of(state.groups.begin(), state.groups.end(), holdsGround)) return;
    for (const Group& group : state.groups) {
        listHeld(state, group, spots_);
        for (const Passage& passage : state.passages)
            held_.push_back(hasRoom(passage, spots_, state.parameters.character.radius) ? 0 : 1);
    }
}

void Crossers::gatherMember(const WorldState& state, const WayFields& fields, const Group& group,
                            std::int32_t pool, std::int32_t character) {
    const std::int32_t place = state.characters.place[character];
    const ChosenWay& chosen = state.characters.chosen[character];
    if (place < 0 || chosen.turns >= kGaveUp) return;
    if (fields.isInside(chosen.way, state.characters.position[character])) return;
    const WalkSpot from = fields.spot(fields.inRoom(state.characters.position[character]));
    const WalkSpot to = fields.spot(fields.inRoom(goalOf(group, place)));
    const double speed = metresPerSecond(state.parameters);
    const std::size_t all = state.passages.size();
    double least = kInfiniteCost;
    for (std::size_t p = 0; p < all; ++p) {
        const Walk here = fields.walk(p, from), there = fields.walk(p, to);
        const bool candidate = onOppositeSides(here, there) && !isHeld(pool, p);
        if (candidate) least = std::min(least, here.cost + there.cost);
        arrival_.push_back(candidate ? here.cost / speed : kInfiniteCost);
        onward_.push_back(candidate ? there.cost / speed : kInfiniteCost);
        side_.push_back(static_cast<std::int8_t>(here.side));
    }
    const bool past = least < kInfiniteCost && needsNone(state, fields, group, character, to.point, least);
    if (least < kInfiniteCost && !past) {
        characters_.push_back(character);
        pool_.push_back(pool);
        return;
    }
    if (past) past_.push_back(character);
    for (auto* table : {&arrival_, &onward_}) table->resize(table->size() - all);
    side_.resize(side_.size() - all);
}

// True where the route of a character leads past all passages: its goal is in sight, or the planned route is
// much shorter than that by any passage.
bool Crossers::needsNone(const WorldState& state, const WayFields& fields, const Group& group,
                         std::int32_t character, Vec2 goal, double byPassage) const {
    const Characters& c = state.characters;
    const Vec2 from = c.position[character];
    const bool through = std::any_of(state.passages.begin(), state.passages.end(),
                                     [&](const Passage& p) { return segmentsCross(from, goal, p.a, p.b); });
    if (!through && fields.ground().collisionFree(from, goal)) return true;
    const bool planned = c.chosen[character].way < 0 &&
                         distance(group.places.positions()[c.place[character]], goal) < kSameGoal;
    return planned && kDetourRatio * c.cost[character] + kDetourCost < byPassage;
}

void Crossers::gather(const WorldState& state, const WayFields& fields) {
    characters_.clear();
    past_.clear();
    pool_.clear();
    arrival_.clear();
    onward_.clear();
    side_.clear();
    findHeld(state);
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        if (state.groups[g].groundClass != 0) continue;  // Passages are those of bodies of the usual size.
        for (const std::int32_t i : state.groups[g].members)
            gatherMember(state, fields, state.groups[g], static_cast<std::int32_t>(g), i);
    }
    keepNearest(state.passages.size());
}

// Keeps the passages with the shortest routes in the tables, at most kMaxChoices.
void Crossers::keepNearest(std::size_t all) {
    least_.assign(all, kInfiniteCost);
    for (std::size_t k = 0; k < arrival_.size(); ++k)
        least_[k % all] = std::min(least_[k % all], arrival_[k] + onward_[k]);
    used_.clear();
    for (std::size_t p = 0; p < all; ++p)
        if (least_[p] < kInfiniteCost) used_.push_back(static_cast<std::int32_t>(p));
    if (used_.size() > kMaxChoices) {
        std::stable_sort(used_.begin(), used_.end(),
                         [&](std::int32_t x, std::int32_t y) { return least_[x] < least_[y]; });
        used_.resize(kMaxChoices);
        std::sort(used_.begin(), used_.end());
    }
    const std::size_t kept = used_.size();
    for (std::size_t k = 0; k < characters_.size(); ++k)
        for (std::size_t u = 0; u < kept; ++u) {
            arrival_[k * kept + u] = arrival_[k * all + used_[u]];
            onward_[k * kept + u] = onward_[k * all + used_[u]];
            side_[k * kept + u] = side_[k * all + used_[u]];
        }
}

void Crossers::shutPast(const WorldState& state, const WayFields& fields, std::span<const std::int32_t> way) {
    measureBetween(state, fields);
    const std::size_t kept = used_.size();
    for (std::size_t k = 0; k < way.size(); ++k) {
        if (way[k] < 0) continue;
        arrivalBefore_.assign(arrival_.begin() + k * kept, arrival_.begin() + (k + 1) * kept);
        for (std::size_t to = 0; to < kept; ++to)
            for (std::size_t by = 0; by < kept; ++by) {
                const std::size_t onLeft = side_[k * kept + by] > 0 ? 1 : 0;
                const double between = between_[(2 * by + onLeft) * kept + to];
                const bool past = arrivalBefore_[to] - arrivalBefore_[by] > kPastShare * between;
                if (past && to != by && std::cmp_not_equal(to, way[k]))
                    arrival_[k * kept + to] = kInfiniteCost;
            }
    }
}

// Measures the times of walks from the mouths of the used passages to the used passages.
void Crossers::measureBetween(const WorldState& state, const WayFields& fields) {
    const std::size_t kept = used_.size();
    const double speed = metresPerSecond(state.parameters);
    between_.clear();
    for (const std::int32_t by : used_)
        for (const bool onLeft : {false, true}) {
            const Vec2 mouth = fields.inRoom(mouthOf(state.passages[by], onLeft));
            const double toOwn = fields.walk(by, mouth).cost;
            for (std::size_t to = 0; to < kept; ++to)
                between_.push_back((fields.walk(used_[to], mouth).cost - toOwn) / speed);
        }
}

std::int32_t Crossers::wayOf(std::size_t crosser, std::size_t used) const {
    return wayNumber(used_[used], side_[crosser * used_.size() + used]);
}

}  // namespace muster
