#include "engine/state/world_state.h"

#include <algorithm>

#include "engine/state/ground_class.h"

namespace muster {

Group* WorldState::findGroup(GroupId id) {
    const auto at = std::lower_bound(
        groups.begin(), groups.end(), id.value,
        [](const Group& group, std::uint32_t value) { return group.id.value < value; });
    return at != groups.end() && at->id == id ? &*at : nullptr;
}

Area* WorldState::findArea(AreaId id) {
    const auto at = std::lower_bound(areas.begin(), areas.end(), id,
                                     [](const Area& area, AreaId wanted) { return area.id < wanted; });
    return at != areas.end() && at->id == id ? &*at : nullptr;
}

void WorldState::refreshMembers() {
    for (Group& group : groups) group.members.clear();
    for (std::size_t i = 0; i < characters.size(); ++i)
        groups[characters.group[i]].members.push_back(static_cast<std::int32_t>(i));
}

RouteGraph& WorldState::refreshRoutes(std::int32_t groundClass) {
    if (groundClass == 0) return refreshRoutes();
    RouteGraph& own = classRoutes[groundClass];
    own.update(environment, groundRadius(parameters.character.radius, groundClass));
    return own;
}

const RouteGraph& WorldState::routesOf(const Group& group) const {
    const auto own = group.groundClass == 0 ? classRoutes.end() : classRoutes.find(group.groundClass);
    return own == classRoutes.end() ? routes : own->second;
}

std::int32_t mainRegion(const WorldState& state, const Group& group, std::vector<std::int32_t>& counts) {
    counts.clear();
    const RouteGraph& routes = state.routesOf(group);
    const bool only = routes.regionCount() <= 1;
    for (const std::int32_t i : group.members) {
        if (!fitsGround(state, group, i)) continue;
        const std::int32_t label = routes.region(state.characters.position[i]);
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
