#include "engine/systems/passages/group_ways.h"

#include <algorithm>

#include "engine/passages/way_number.h"
#include "engine/systems/passages/goals.h"

namespace muster {
void GroupWays::readChosen(const WorldState& state, const Group& group, std::span<const float> reach) {
    const double speed = metresPerSecond(state.parameters), now = state.time();
    const std::size_t count = group.members.size();
    way_.assign(count, -1);
    reach_.assign(count, 0.0f);
    used_.assign(wayCount(state.passages.size()), 0);
    any_ = false;
    for (std::size_t k = 0; k < count; ++k) {
        const ChosenWay& chosen = state.characters.chosen[group.members[k]];
        if (chosen.way < 0) continue;
        any_ = true;
        used_[chosen.way] = 1;
        way_[k] = chosen.way;
        reach_[k] = std::max(reach[group.members[k]], static_cast<float>((chosen.passAt - now) * speed));
    }
}

void GroupWays::prepare(const WorldState& state, const WayFields& fields, const Group& group,
                        std::span<const float> reach, ThreadPool& pool) {
    readChosen(state, group, reach);
    if (!any_) return;
    const std::vector<Vec2>& goals = group.places.reachableTargets();
    onward_.resize(used_.size() * goals.size());
    for (std::size_t w = 0; w < used_.size(); ++w) {
        if (used_[w] == 0) continue;
        const auto way = static_cast<std::int32_t>(w);
        forChunks(&pool, goals.size(), kPerTask, [&](std::size_t j) {
            const Walk walk = fields.walk(passageOf(way), goals[j] + group.foreseen);
            const bool beyond = walk.side == sideBehind(way);
            onward_[w * goals.size() + j] = beyond ? static_cast<float>(walk.cost) : kUnreachableCost;
        });
    }
}

}  // namespace muster
