#include <algorithm>
#include <string>

#include "engine/state/bare_groups.h"
#include "engine/state/group_edits.h"
#include "engine/state/reform.h"
#include "engine/state/standing_room.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/join_one.h"
#include "engine/systems/commands/not_found.h"

namespace muster {
namespace {

std::uint32_t indexOf(const WorldState& state, const Group& group) {
    return static_cast<std::uint32_t>(&group - state.groups.data());
}

/// Indices of the characters with these ids, in ascending order.
Result<std::vector<std::int32_t>> charactersOf(const WorldState& state, std::span<const std::uint32_t> ids) {
    std::vector<std::int32_t> indices;
    for (const std::uint32_t id : ids) {
        const std::int32_t i = state.characters.indexOf(id);
        if (i < 0) return noCharacter(id);
        indices.push_back(i);
    }
    std::sort(indices.begin(), indices.end());
    return indices;
}

std::vector<std::uint32_t> memberIds(const WorldState& state, const Group& group) {
    std::vector<std::uint32_t> ids;
    for (const std::int32_t i : group.members) ids.push_back(state.characters.id[i]);
    return ids;
}

/// The groups that lose members, and their formations without these.
struct Shrinking {
    std::vector<std::uint32_t> groups;  // Indices of the groups.
    std::vector<Reform> reforms;        // The new formation of each group.
};

/// The groups that the characters `leaving` leave, and their new formations; `leaving` ascends.
Result<Shrinking> shrink(const WorldState& state, std::span<const std::int32_t> leaving) {
    Shrinking result;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        const Group& group = state.groups[g];
        std::vector<std::uint32_t> stay;
        for (const std::int32_t i : group.members)
            if (!std::binary_search(leaving.begin(), leaving.end(), i))
                stay.push_back(state.characters.id[i]);
        if (stay.size() == group.members.size() || state.continuum.isBare(group.id)) continue;
        HeldPlaces held;
        held.add(state, group, group);
        Result<Reform> reform = refit(state, group, held, resized(group, held, stay, false), stay);
        if (!reform.ok()) return reform.status().within("group '" + group.def.name + "'");
        result.groups.push_back(static_cast<std::uint32_t>(g));
        result.reforms.push_back(std::move(*reform));
    }
    return result;
}

// Applies the new formations. A group that was on a march goes on with it.
void apply(WorldState& state, Shrinking& shrinking) {
    for (Group& group : state.groups)
        if (state.continuum.isBare(group.id))
            group.def.count = static_cast<std::int32_t>(group.members.size());
    for (std::size_t k = 0; k < shrinking.groups.size(); ++k) {
        Group& group = state.groups[shrinking.groups[k]];
        Reform& reform = shrinking.reforms[k];
        const bool marches = group.flow.moves() && group.flow.version == group.formationVersion;
        std::vector<std::int32_t> kept;
        for (const PlaceTracker::Origin& origin : reform.origins)
            if (origin.tracker == &group.places && origin.place >= 0) kept.push_back(origin.place);
        const bool known = !kept.empty() && kept.size() == reform.origins.size();
        applyReform(state, group, std::move(reform), group.mesh);
        if (!marches || !known) continue;
        group.flow.keep(kept);
        group.flow.version = group.formationVersion;
    }
}

/// Gives a group, whose members are up to date, places for the members that have joined.
Status growTo(WorldState& state, Group& group, const HeldPlaces& held) {
    if (state.continuum.isBare(group.id)) {
        group.def.count = static_cast<std::int32_t>(group.members.size());
        return {};
    }
    const std::vector<std::uint32_t> ids = memberIds(state, group);
    const FormationDef def = resized(group, held, ids, false);
    Result<Reform> reform = refit(state, group, held, def, ids);
    if (!reform.ok()) return reform.status().within("group '" + group.def.name + "'");
    applyReform(state, group, std::move(*reform), group.mesh);
    return {};
}

}  // namespace

std::int32_t joinOne(WorldState& state, Group& group, Vec2 position, const Body& body) {
    const bool leaves = !group.orders.orders.empty() && isBare(group.orders.orders.front().order.kind);
    // The first member of a group that is to go without a formation needs none.
    if (group.members.empty() && leaves && !state.continuum.isBare(group.id)) {
        dissolveFormation(state, group);
        state.continuum.begin(group.id, group.orders.orders.front().order.kind, {}).active = false;
    }
    HeldPlaces held;
    held.add(state, group, group);
    const auto i = static_cast<std::int32_t>(joinBare(state, group, position, body));
    const Status grown = growTo(state, group, held);
    MUSTER_ASSERT(grown.ok());
    (void)grown;
    return i;
}

Status apply(CommandContext& context, const AddCharacters& command) {
    WorldState& state = context.groups();
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    const auto total = static_cast<std::int64_t>(state.characters.size() + command.positions.size());
    if (const Status fits = validateTotal(total, state.parameters); !fits.ok()) return fits;
    HeldPlaces held;
    held.add(state, *group, *group);
    const std::size_t before = state.characters.size();
    joinCharacters(state, *group, command.positions, command.bodies);
    if (const Status grown = growTo(state, *group, held); !grown.ok()) {
        std::vector<std::uint8_t> leaves(state.characters.size(), 0);
        std::fill(leaves.begin() + static_cast<std::ptrdiff_t>(before), leaves.end(), 1);
        removeCharacters(state.characters, leaves);
        state.nextCharacter -= static_cast<std::uint32_t>(command.positions.size());
        state.refreshMembers();
        return grown;
    }
    const Characters& characters = state.characters;
    for (std::size_t i = before; i < characters.size(); ++i)
        context.events.push_back(
            {EventKind::Joined, characters.id[i], group->id.value, characters.position[i]});
    return {};
}

namespace {

Status leaveWorld(CommandContext& context, const std::vector<std::uint32_t>& ids) {
    WorldState& state = context.groups();
    const auto leaving = charactersOf(state, ids);
    if (!leaving.ok()) return leaving.status();
    Result<Shrinking> shrinking = shrink(state, *leaving);
    if (!shrinking.ok()) return shrinking.status();
    std::vector<std::uint8_t> leaves(state.characters.size(), 0);
    for (const std::int32_t i : *leaving) {
        leaves[i] = 1;
        context.events.push_back({EventKind::Left, state.characters.id[i],
                                  state.groups[state.characters.group[i]].id.value,
                                  state.characters.position[i]});
    }
    removeCharacters(state.characters, leaves);
    state.refreshMembers();
    apply(state, *shrinking);
    return {};
}

}  // namespace

Status apply(CommandContext& context, const TransferCharacters& command) {
    if (!command.group) return leaveWorld(context, command.ids);
    WorldState& state = context.groups();
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    auto leaving = charactersOf(state, command.ids);
    if (!leaving.ok()) return leaving.status();
    const std::uint32_t target = indexOf(state, *group);
    std::erase_if(*leaving, [&](std::int32_t i) { return state.characters.group[i] == target; });
    if (leaving->empty()) return invalidArgument("all of them are in the group already");
    Result<Shrinking> shrinking = shrink(state, *leaving);
    if (!shrinking.ok()) return shrinking.status();
    HeldPlaces held;
    held.add(state, *group, *group);
    std::vector<std::uint32_t> former;
    for (const std::int32_t i : *leaving) {
        former.push_back(state.characters.group[i]);
        state.characters.group[i] = target;
    }
    state.refreshMembers();
    if (const Status grown = growTo(state, *group, held); !grown.ok()) {
        for (std::size_t k = 0; k < former.size(); ++k) state.characters.group[(*leaving)[k]] = former[k];
        state.refreshMembers();
        return grown;
    }
    apply(state, *shrinking);
    for (const std::int32_t i : *leaving)
        context.events.push_back(
            {EventKind::Transferred, state.characters.id[i], group->id.value, state.characters.position[i]});
    return {};
}

Status apply(CommandContext& context, const MergeGroups& command) {
    WorldState& state = context.groups();
    for (const GroupId id : command.groups)
        if (state.findGroup(id) == nullptr) return noGroup(id);
    Group& first = *state.findGroup(command.groups.front());
    HeldPlaces held;
    std::vector<std::uint32_t> ids;
    const bool bare = state.continuum.isBare(first.id);
    for (const GroupId id : command.groups) {
        const Group& group = *state.findGroup(id);
        held.add(state, group, first);
        const std::vector<std::uint32_t> members = memberIds(state, group);
        ids.insert(ids.end(), members.begin(), members.end());
    }
    std::sort(ids.begin(), ids.end());
    Result<Reform> reform = bare ? Result<Reform>(Reform{})
                            : command.shape == PartShape::AsHeld
                                ? asHeld(state, first, held, ids)
                                : refit(state, first, held, resized(first, held, ids, true), ids);
    if (!reform.ok()) return reform.status().within("group '" + first.def.name + "'");
    const std::uint32_t index = indexOf(state, first);
    for (const GroupId id : command.groups)
        for (const std::int32_t i : state.findGroup(id)->members) state.characters.group[i] = index;
    state.refreshMembers();
    if (bare)
        dissolveFormation(state, first);
    else
        applyReform(state, first, std::move(*reform), first.mesh);
    first.def.count = static_cast<std::int32_t>(first.members.size());
    const GroupId into = first.id;
    for (const GroupId id : command.groups) {
        if (id == into) continue;
        const Group& group = *state.findGroup(id);
        context.events.push_back({EventKind::GroupRemoved, id.value, into.value, group.mesh.pose().position});
        removeGroup(state, indexOf(state, group));
    }
    return {};
}

}  // namespace muster
