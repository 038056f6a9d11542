#include "engine/systems/commands/thing_commands.h"

#include <algorithm>
#include <string>

#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"

namespace muster {
namespace {

/// Index of an id in ascending ids; -1 for none.
template <class AnyId>
std::ptrdiff_t indexOf(const std::vector<AnyId>& ids, AnyId id) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return at != ids.end() && *at == id ? at - ids.begin() : -1;
}

Status tooMany(std::size_t most, const char* what) {
    return {StatusCode::LimitExceeded, "a world holds at most " + std::to_string(most) + " " + what};
}

/// Counts an edit of the ground that has succeeded; returns its status.
Status edited(WorldState& state, Status status) {
    state.groundEdits += status.ok() ? 1 : 0;
    return status;
}

Status putObstacle(CommandContext& context, ObstacleId id, const ObstacleDef& def) {
    Environment& ground = context.ground();
    return edited(context.state, id ? ground.changeObstacle(id, def) : ground.addObstacle(def).status());
}

Status putPatch(CommandContext& context, PatchId id, const PatchDef& def) {
    Environment& ground = context.ground();
    return edited(context.state, id ? ground.changePatch(id, def) : ground.addPatch(def).status());
}

Status putItem(WorldState& state, ItemId id, const ItemDef& def) {
    if (id) {
        const std::ptrdiff_t at = indexOf(state.itemIds, id);
        if (at < 0) return notFound("item", id.value);
        state.items[at] = def;
        return {};
    }
    if (state.items.size() >= kMaxObstacles) return tooMany(kMaxObstacles, "items");
    state.items.push_back(def);
    state.itemIds.push_back(ItemId{state.nextItem++});
    state.collected.push_back(0);
    return {};
}

Status removeItem(WorldState& state, ItemId id) {
    const std::ptrdiff_t at = indexOf(state.itemIds, id);
    if (at < 0) return notFound("item", id.value);
    state.items.erase(state.items.begin() + at);
    state.itemIds.erase(state.itemIds.begin() + at);
    state.collected.erase(state.collected.begin() + at);
    return {};
}

/// Adds a column to the marks of groups at checkpoints, or takes the column `without` out.
void changeColumns(WorldState& state, std::size_t before, std::size_t now, std::size_t without) {
    std::vector<std::uint8_t> marks;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        for (std::size_t c = 0; c < before; ++c)
            if (c != without) marks.push_back(state.checkpointState[g * before + c]);
        marks.resize((g + 1) * now, 0);
    }
    state.checkpointState = std::move(marks);
}

void addCheckpoint(WorldState& state) {
    const std::size_t before = state.checkpoints.size();
    state.checkpoints.emplace_back();
    state.checkpointGroups.emplace_back();
    state.checkpointIds.push_back(CheckpointId{state.nextCheckpoint++});
    changeColumns(state, before, before + 1, before);
}

Status putCheckpoint(WorldState& state, CheckpointId id, const FormationCheckpointDef& def, GroupId group) {
    const std::ptrdiff_t known = indexOf(state.checkpointIds, id);
    if (id && known < 0) return notFound("checkpoint", id.value);
    if (!id && state.checkpoints.size() >= kMaxObstacles) return tooMany(kMaxObstacles, "checkpoints");
    if (group && state.findGroup(group) == nullptr) return noGroup(group);
    if (!id) addCheckpoint(state);
    const std::size_t at = id ? static_cast<std::size_t>(known) : state.checkpoints.size() - 1;
    state.checkpoints[at] = def;
    state.checkpoints[at].group = -1;
    state.checkpointGroups[at] = group;
    return {};
}

Status removeCheckpoint(WorldState& state, CheckpointId id) {
    const std::ptrdiff_t at = indexOf(state.checkpointIds, id);
    if (at < 0) return notFound("checkpoint", id.value);
    const std::size_t before = state.checkpoints.size();
    changeColumns(state, before, before - 1, static_cast<std::size_t>(at));
    state.checkpoints.erase(state.checkpoints.begin() + at);
    state.checkpointGroups.erase(state.checkpointGroups.begin() + at);
    state.checkpointIds.erase(state.checkpointIds.begin() + at);
    for (Group& group : state.groups)
        if (std::cmp_greater(group.visitors.size(), at)) group.visitors.erase(group.visitors.begin() + at);
    return {};
}

Status putArea(WorldState& state, AreaId id, const AreaDef& def, GroupId group) {
    const bool source = def.kind == AreaKind::Source;
    if (source && state.findGroup(group) == nullptr) return noGroup(group);
    Area* area = state.findArea(id);
    if (id && area == nullptr) return notFound("area", id.value);
    if (area == nullptr) {
        if (state.areas.size() >= kMaxAreas) return tooMany(kMaxAreas, "areas");
        addArea(state, def, source ? group : GroupId{});
        return {};
    }
    area->def = def;
    area->group = source ? group : GroupId{};
    return {};
}

Status removeArea(WorldState& state, AreaId id) {
    const std::size_t removed = std::erase_if(state.areas, [&](const Area& area) { return area.id == id; });
    return removed > 0 ? Status{} : notFound("area", id.value);
}

}  // namespace

void addArea(WorldState& state, const AreaDef& def, GroupId group) {
    constexpr std::uint64_t kStream = 0x9e3779b97f4a7c15u;  // Areas draw from streams of their own.
    Area& area = state.areas.emplace_back();
    area.id = AreaId{state.nextArea++};
    area.def = def;
    area.group = group;
    area.source.random = Random(state.seed + kStream * area.id.value);
}

Status apply(CommandContext& context, const PutThing& put) {
    if (put.obstacle) return putObstacle(context, ObstacleId{put.id}, *put.obstacle);
    if (put.patch) return putPatch(context, PatchId{put.id}, *put.patch);
    if (put.item) return putItem(context.state, ItemId{put.id}, *put.item);
    if (put.checkpoint) return putCheckpoint(context.state, CheckpointId{put.id}, *put.checkpoint, put.group);
    return putArea(context.state, AreaId{put.id}, *put.area, put.group);
}

Status apply(CommandContext& context, const RemoveThing& remove) {
    switch (remove.thing) {
        case ThingKind::Obstacle:
            return edited(context.state, context.ground().removeObstacle(ObstacleId{remove.id}));
        case ThingKind::Patch:
            return edited(context.state, context.ground().removePatch(PatchId{remove.id}));
        case ThingKind::Item:
            return removeItem(context.state, ItemId{remove.id});
        case ThingKind::Checkpoint:
            return removeCheckpoint(context.state, CheckpointId{remove.id});
        case ThingKind::Area:
            break;
    }
    return removeArea(context.state, AreaId{remove.id});
}

}  // namespace muster
