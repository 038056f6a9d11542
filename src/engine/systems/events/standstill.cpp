#include "engine/systems/events/standstill.h"

#include <algorithm>
#include <cmath>

#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

constexpr double kQueueReach = 2.5;   // Greatest distance of the agent ahead in a queue [diameters].
constexpr double kQueueCosine = 0.5;  // Least cosine between the route and the direction to the agent ahead.

double radiusAt(const WorldState& state, std::int32_t i) {
    return radiusOf(state.parameters.character, state.characters.body[i]);
}

}  // namespace

std::uint32_t stepsIn(const WorldState& state, double seconds) {
    return static_cast<std::uint32_t>(std::max(1.0, std::floor(seconds / state.parameters.stepTime + 0.5)));
}

void Standstill::reserve(const Characters& characters) {
    if (movesOn_.size() == characters.size()) return;
    movesOn_.resize(characters.size());
    spreading_.reserve(characters.size());
    cells_.sort(characters.position, 1.0);
}

bool Standstill::movedLately(const WorldState& state, std::int32_t i) const {
    return state.stepCount - state.characters.walk[i].movedAt < stepsIn(state, kStuckTime);
}

// True where character j stands before i on the route to the place of i.
bool Standstill::isAhead(const WorldState& state, std::int32_t j, std::int32_t i) const {
    const Characters& c = state.characters;
    const Vec2 offset = c.position[j] - c.position[i];
    const double away = length(offset);
    if (away > kQueueReach * (radiusAt(state, i) + radiusAt(state, j))) return false;
    const std::vector<Vec2>& places = state.groups[c.group[i]].places.positions();
    const Vec2 way = c.direction[i] == Vec2{} ? normalized(places[c.place[i]] - c.position[i], {})
                                              : c.direction[i];
    return dot(way, offset) >= kQueueCosine * away;
}

// Marks the waiting characters directly behind j.
void Standstill::markBehind(const WorldState& state, std::int32_t j) {
    const Characters& c = state.characters;
    const double reach = kQueueReach * (radiusAt(state, j) + largest_);
    const Grid& grid = cells_.grid();
    const Cell low = grid.nearestCell(c.position[j] - Vec2{reach, reach});
    const Cell high = grid.nearestCell(c.position[j] + Vec2{reach, reach});
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (const std::int32_t i : cells_.within(grid.index({low.x, y}), grid.index({high.x, y}))) {
            if (movesOn_[i] != 0 || c.place[i] < 0 || c.walk[i].within || !isAhead(state, j, i)) continue;
            movesOn_[i] = 1;
            spreading_.push_back(i);
        }
}

// Spreads from moving characters to those that wait behind them, and so on; agents that wait for each other
// in a ring remain unmarked.
void Standstill::markMovingQueues(const WorldState& state) {
    const Characters& c = state.characters;
    cells_.sort(c.position, 2.0 * state.parameters.character.radius);
    largest_ = 0.0;
    for (std::int32_t i = 0; i < std::ssize(c.id); ++i) largest_ = std::max(largest_, radiusAt(state, i));
    spreading_.clear();
    for (std::int32_t i = 0; i < std::ssize(c.id); ++i) {
        movesOn_[i] = movedLately(state, i) ? 1 : 0;
        if (movesOn_[i] != 0) spreading_.push_back(i);
    }
    for (std::size_t k = 0; k < spreading_.size(); ++k) markBehind(state, spreading_[k]);
}

void Standstill::raise(WorldState& state, std::vector<Event>& events) {
    Characters& c = state.characters;
    const auto stands = [&](std::int32_t i) {
        const WalkProgress& walk = c.walk[i];
        return !walk.stuckRaised && !walk.within && c.place[i] >= 0 && !movedLately(state, i) &&
               state.stepCount - walk.since >= stepsIn(state, kStuckTime);
    };
    bool marked = false;
    for (std::int32_t i = 0; i < std::ssize(c.id); ++i) {
        if (!stands(i)) continue;
        if (!marked) markMovingQueues(state);
        marked = true;
        if (movesOn_[i] != 0) continue;
        c.walk[i].stuckRaised = true;
        events.push_back({EventKind::Stuck, c.id[i], static_cast<std::uint32_t>(c.place[i]), c.position[i]});
    }
}

}  // namespace muster
