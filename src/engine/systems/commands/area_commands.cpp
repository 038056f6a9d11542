#include "engine/systems/commands/area_commands.h"

#include <algorithm>
#include <string>

#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"

namespace muster {

void addArea(WorldState& state, const AreaDef& def, GroupId group) {
    constexpr std::uint64_t kStream = 0x9e3779b97f4a7c15u;  // Areas draw from streams of their own.
    Area& area = state.areas.emplace_back();
    area.id = AreaId{state.nextArea++};
    area.def = def;
    area.group = group;
    area.source.random = Random(state.seed + kStream * area.id.value);
}

Status apply(CommandContext& context, const PutArea& put) {
    WorldState& state = context.state;
    const bool source = put.area.kind == AreaKind::Source;
    if (source && state.findGroup(put.group) == nullptr) return noGroup(put.group);
    Area* area = state.findArea(put.id);
    if (put.id && area == nullptr) return notFound("area", put.id.value);
    if (area == nullptr) {
        if (state.areas.size() >= kMaxAreas)
            return {StatusCode::LimitExceeded,
                    "a world holds at most " + std::to_string(kMaxAreas) + " areas"};
        addArea(state, put.area, source ? put.group : GroupId{});
        return {};
    }
    area->def = put.area;
    area->group = source ? put.group : GroupId{};
    return {};
}

Status apply(CommandContext& context, const RemoveArea& remove) {
    WorldState& state = context.state;
    const std::size_t removed = std::erase_if(state.areas,
                                              [&](const Area& area) { return area.id == remove.id; });
    return removed > 0 ? Status{} : notFound("area", remove.id.value);
}

}  // namespace muster
