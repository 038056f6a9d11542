#include "world/state/world_state.h"

namespace muster {

Group* WorldState::findGroup(GroupId id) {
    for (Group& group : groups)
        if (group.id == id) return &group;
    return nullptr;
}

void WorldState::refreshMembers() {
    for (Group& group : groups) group.members.clear();
    for (std::size_t i = 0; i < characters.size(); ++i)
        groups[characters.group[i]].members.push_back(static_cast<std::int32_t>(i));
}

std::int32_t mainRegion(const WorldState& state, const Group& group, std::vector<std::int32_t>& counts) {
    counts.clear();
    const bool only = state.routes.regionCount() <= 1;
    for (const std::int32_t i : group.members) {
        const std::int32_t label = state.routes.region(state.characters.position[i]);
        if (label < 0) continue;
        if (only) return label;
        if (label >= std::ssize(counts)) counts.resize(label + 1, 0);
        ++counts[label];
    }
    std::int32_t best = -1;
    for (std::int32_t label = 0; label < std::ssize(counts); ++label)
        if (counts[label] > (best < 0 ? 0 : counts[best])) best = label;
    return best;
}

}  // namespace muster
