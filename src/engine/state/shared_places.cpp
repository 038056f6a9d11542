#include "engine/state/shared_places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/steering/crowd_bodies.h"

namespace muster {

bool hasWeights(const WorldState& state, const Group& group) {
    return !group.def.demands.empty() ||
           std::any_of(group.members.begin(), group.members.end(),
                       [&](std::int32_t i) { return state.characters.body[i].supply != 1.0; });
}

// Discs of radius r lie within about r sqrt(n - 1) around one point: two side by side, seven in a ring and
// its middle, 37 in three rings.
void SharedPlaces::add(const WorldState& state, const Group& group) {
    if (!hasWeights(state, group)) return;
    const Characters& c = state.characters;
    room_.resize(c.size(), 0.0);
    count_.assign(group.places.positions().size(), 0);
    const auto isPlaced = [&](std::int32_t i) {
        return c.place[i] >= 0 && std::cmp_less(c.place[i], count_.size());
    };
    for (const std::int32_t i : group.members)
        if (isPlaced(i)) ++count_[c.place[i]];
    for (const std::int32_t i : group.members)
        if (isPlaced(i) && count_[c.place[i]] > 1)
            room_[i] = radiusOf(state.parameters.character, c.body[i]) *
                       std::sqrt(static_cast<double>(count_[c.place[i]] - 1));
}

void SharedPlaces::find(const WorldState& state, const Group& group) {
    room_.clear();
    add(state, group);
}

void SharedPlaces::find(const WorldState& state) {
    room_.clear();
    for (const Group& group : state.groups) add(state, group);
}

}  // namespace muster
