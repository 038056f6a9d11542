#include <algorithm>
#include <string>

#include "base/maths.h"
#include "engine/state/bare_groups.h"
#include "engine/state/draw_person.h"
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/order_queues.h"

namespace muster {
namespace {

/// Index of an id in ascending ids; -1 for none.
template <class AnyId>
std::ptrdiff_t indexOf(const std::vector<AnyId>& ids, AnyId id) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return at != ids.end() && *at == id ? at - ids.begin() : -1;
}

Status tooMany(const char* what) {
    return {StatusCode::LimitExceeded, "a world holds at most " + std::to_string(kMaxObstacles) + " " + what};
}

Status groupIsThere(WorldState& state, GroupId group) {
    return !group || state.findGroup(group) != nullptr ? Status{} : noGroup(group);
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

}  // namespace

Status apply(CommandContext& context, const AddItem& add) {
    WorldState& state = context.state;
    if (state.items.size() >= kMaxObstacles) return tooMany("items");
    state.items.push_back(add.item);
    state.itemIds.push_back(ItemId{state.nextItem++});
    state.collected.push_back(0);
    return {};
}

Status apply(CommandContext& context, const ChangeItem& change) {
    WorldState& state = context.state;
    const std::ptrdiff_t at = indexOf(state.itemIds, change.id);
    if (at < 0) return notFound("item", change.id.value);
    state.items[at] = change.item;
    return {};
}

Status apply(CommandContext& context, const RemoveItem& remove) {
    WorldState& state = context.state;
    const std::ptrdiff_t at = indexOf(state.itemIds, remove.id);
    if (at < 0) return notFound("item", remove.id.value);
    state.items.erase(state.items.begin() + at);
    state.itemIds.erase(state.itemIds.begin() + at);
    state.collected.erase(state.collected.begin() + at);
    return {};
}

Status apply(CommandContext& context, const AddCheckpoint& add) {
    WorldState& state = context.state;
    const std::size_t before = state.checkpoints.size();
    if (before >= kMaxObstacles) return tooMany("checkpoints");
    if (const Status there = groupIsThere(state, add.group); !there.ok()) return there;
    state.checkpoints.push_back(add.checkpoint);
    state.checkpoints.back().group = -1;
    state.checkpointGroups.push_back(add.group);
    state.checkpointIds.push_back(CheckpointId{state.nextCheckpoint++});
    changeColumns(state, before, before + 1, before);
    return {};
}

Status apply(CommandContext& context, const ChangeCheckpoint& change) {
    WorldState& state = context.state;
    const std::ptrdiff_t at = indexOf(state.checkpointIds, change.id);
    if (at < 0) return notFound("checkpoint", change.id.value);
    if (const Status there = groupIsThere(state, change.group); !there.ok()) return there;
    state.checkpoints[at] = change.checkpoint;
    state.checkpoints[at].group = -1;
    state.checkpointGroups[at] = change.group;
    return {};
}

Status apply(CommandContext& context, const RemoveCheckpoint& remove) {
    WorldState& state = context.state;
    const std::ptrdiff_t at = indexOf(state.checkpointIds, remove.id);
    if (at < 0) return notFound("checkpoint", remove.id.value);
    const std::size_t before = state.checkpoints.size();
    changeColumns(state, before, before - 1, static_cast<std::size_t>(at));
    state.checkpoints.erase(state.checkpoints.begin() + at);
    state.checkpointGroups.erase(state.checkpointGroups.begin() + at);
    state.checkpointIds.erase(state.checkpointIds.begin() + at);
    for (Group& group : state.groups)
        if (std::cmp_greater(group.visitors.size(), at)) group.visitors.erase(group.visitors.begin() + at);
    return {};
}

Status apply(CommandContext& context, const PlaceGroup& place) {
    WorldState& state = context.groups();
    Group* group = state.findGroup(place.group);
    if (group == nullptr) return noGroup(place.group);
    if (state.continuum.isBare(group->id)) formUp(state, *group);
    const Pose pose{place.position, {cosine(place.angle), sine(place.angle)}};
    if (const Status placed = standAt(state, *group, pose); !placed.ok()) return placed;
    group->controls.clear();
    state.continuum.end(group->id);
    dropOrders(*group);
    group->orders.march.reversed = false;
    return {};
}

Status apply(CommandContext& context, const NameGroup& name) {
    WorldState& state = context.state;
    Group* group = state.findGroup(name.group);
    if (group == nullptr) return noGroup(name.group);
    group->def.name = name.name;
    return {};
}

Status apply(CommandContext& context, const ColourGroup& colour) {
    WorldState& state = context.state;
    Group* group = state.findGroup(colour.group);
    if (group == nullptr) return noGroup(colour.group);
    group->def.colour = colour.colour;
    return {};
}

Status apply(CommandContext& context, const SetAppearance& appearance) {
    WorldState& state = context.state;
    Group* group = state.findGroup(appearance.group);
    if (group == nullptr) return noGroup(appearance.group);
    group->def.build = appearance.build;
    group->def.motions = appearance.motions;
    return {};
}

Status apply(CommandContext& context, const SetPeople& set) {
    WorldState& state = context.groups();
    Group* group = state.findGroup(set.group);
    if (group == nullptr) return noGroup(set.group);
    Characters& c = state.characters;
    std::vector<std::uint32_t> ids;
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < group->members.size(); ++k) {
        const auto i = static_cast<std::size_t>(group->members[k]);
        ids.push_back(c.id[i]);
        bodies.push_back(withoutSorts(group->def, k, c.body[i]));
    }
    group->def.people = set.people;
    drawAll(group->def.people, state.seed, ids, bodies);
    for (std::size_t k = 0; k < bodies.size(); ++k)
        c.body[static_cast<std::size_t>(group->members[k])] = bodies[k];
    return {};
}

}  // namespace muster
