#include "studio/session/history/crowd_change.h"

#include <algorithm>
#include <utility>

#include "engine/world/inspect.h"

namespace muster {
namespace {

PartState stateOf(const World& world, std::size_t g) {
    const GroupView view = world.group(g);
    PartState part{view.id, inspect::groupDef(world, g), {}, queueOf(view)};
    part.def.formation = inspect::ownFormation(world, g);
    part.def.starts.clear();
    part.def.bodies.clear();
    part.def.orders.clear();
    for (const std::int32_t member : view.members)
        part.members.push_back(world.characters().id[static_cast<std::size_t>(member)]);
    return part;
}

/// Adds a command where the group is not as it asks for.
void addChange(const CommandBody& wanted, const CommandBody& now, CrowdCommands& commands) {
    if (!sameBody(wanted, now)) commands.bodies.push_back(wanted);
}

/// Formation, roles and demands of a group as they were.
void shapeAgain(const PartState& part, const GroupDef& now, CrowdCommands& commands) {
    const GroupDef& def = part.def;
    addChange(SetFormation{part.id, def.formation}, SetFormation{part.id, now.formation}, commands);
    addChange(SetRoles{part.id, def.roles}, SetRoles{part.id, now.roles}, commands);
    addChange(SetDemands{part.id, def.demands}, SetDemands{part.id, now.demands}, commands);
}

std::vector<GroupId> idsOf(const std::vector<PartState>& parts) {
    std::vector<GroupId> ids;
    for (const PartState& part : parts) ids.push_back(part.id);
    return ids;
}

/// Notes the groups as they are now; those that are gone are left out.
void look(DivisionChange& crowdChange, const World& world) {
    std::vector<PartState> parts;
    for (const GroupId id : idsOf(crowdChange.parts))
        if (const auto g = inspect::indexOfGroup(world, id)) parts.push_back(stateOf(world, *g));
    crowdChange.parts = std::move(parts);
}

/// Those orders of the whole that still wait are as they were before it was divided.
void wholeOrders(const DivisionChange& crowdChange, const World& world, CrowdCommands& commands) {
    const GroupView now = world.group(*inspect::indexOfGroup(world, crowdChange.whole.id));
    PartState wanted{crowdChange.whole.id, {}, {}, queueOf(now)};
    for (QueuedOrder& order : wanted.queue.orders)
        for (const QueuedOrder& was : crowdChange.whole.queue.orders)
            if (order.id == was.id) order.order = was.order;
    giveAll(wanted, now, commands);
}

void unite(DivisionChange& crowdChange, const World& world, CrowdCommands& commands) {
    look(crowdChange, world);
    if (crowdChange.parts.empty()) return;
    const auto* asked = std::get_if<MergeGroups>(&crowdChange.asked);
    MergeGroups merge{{crowdChange.whole.id}, asked == nullptr ? PartShape::AsHeld : asked->shape};
    for (const PartState& part : crowdChange.parts) merge.groups.push_back(part.id);
    commands.bodies.push_back(std::move(merge));
    if (asked == nullptr) {
        commands.bodies.push_back(SetFormation{crowdChange.whole.id, crowdChange.whole.def.formation});
        if (!crowdChange.whole.def.roles.empty())
            commands.bodies.push_back(SetRoles{crowdChange.whole.id, crowdChange.whole.def.roles});
        wholeOrders(crowdChange, world, commands);
    } else {
        crowdChange.whole = stateOf(world, *inspect::indexOfGroup(world, crowdChange.whole.id));
    }
}

void divide(DivisionChange& crowdChange, const World& world, CrowdCommands& commands) {
    const std::size_t g = *inspect::indexOfGroup(world, crowdChange.whole.id);
    const auto* asked = std::get_if<SplitGroup>(&crowdChange.asked);
    const PartState now = stateOf(world, g);
    std::size_t left = now.members.size();
    std::vector<PartState> parts;
    for (PartState& part : crowdChange.parts) {
        SplitGroup split{crowdChange.whole.id, SplitBy::Ids, {}, {}, {}, false, PartShape::AsHeld};
        if (asked != nullptr) split.shape = asked->shape;
        for (const std::uint32_t id : part.members)
            if (std::find(now.members.begin(), now.members.end(), id) != now.members.end())
                split.ids.push_back(id);
        if (split.ids.empty() || split.ids.size() >= left) continue;
        left -= split.ids.size();
        commands.bodies.push_back(std::move(split));
        parts.push_back(std::move(part));
    }
    crowdChange.parts = std::move(parts);
    crowdChange.whole.queue = now.queue;
}

}  // namespace

DivisionChange divisionOf(const CommandBody& asked, const World& world) {
    DivisionChange crowdChange{asked, {}, {}, false};
    std::vector<GroupId> groups;
    if (const auto* split = std::get_if<SplitGroup>(&asked)) groups = {split->group};
    if (const auto* merge = std::get_if<MergeGroups>(&asked)) groups = merge->groups;
    for (const GroupId id : groups) {
        const auto g = inspect::indexOfGroup(world, id);
        if (!g) continue;
        if (id == groups.front()) {
            crowdChange.whole = stateOf(world, *g);
            crowdChange.whole.members.clear();  // Whoever is in no part belongs to it.
        } else {
            crowdChange.parts.push_back(stateOf(world, *g));
        }
    }
    return crowdChange;
}

void divisionCommands(DivisionChange& crowdChange, const World& world, CrowdCommands& commands) {
    if (!inspect::indexOfGroup(world, crowdChange.whole.id)) return;
    if (crowdChange.splits())
        divide(crowdChange, world, commands);
    else
        unite(crowdChange, world, commands);
}

std::vector<GroupId> takeNewParts(const DivisionChange& crowdChange, std::vector<Event>& added) {
    std::vector<GroupId> parts;
    const auto* first = std::get_if<SplitGroup>(&crowdChange.asked);
    const bool again = crowdChange.undone || !crowdChange.parts.empty();
    std::size_t most = crowdChange.parts.size();
    if (!again) most = first->by == SplitBy::Shares ? first->shares.size() - 1 : 1;
    for (Event& event : added) {
        if (parts.size() == most) break;
        if (event.kind != EventKind::GroupAdded || event.value != crowdChange.whole.id.value) continue;
        parts.push_back(GroupId{event.subject});
        event.value = 0;  // It is of one change of the crowd only.
    }
    return parts;
}

void partsComeBack(const DivisionChange& crowdChange, const World& world, CrowdCommands& commands) {
    // A split that is done again gives the same orders and formations as the first time.
    const bool joined = std::holds_alternative<MergeGroups>(crowdChange.asked);
    for (const PartState& part : crowdChange.parts) {
        const auto g = inspect::indexOfGroup(world, part.id);
        if (!g) continue;
        const GroupDef& now = inspect::groupDef(world, *g);
        addChange(NameGroup{part.id, part.def.name}, NameGroup{part.id, now.name}, commands);
        if (!joined) continue;
        addChange(ColourGroup{part.id, part.def.colour}, ColourGroup{part.id, now.colour}, commands);
        addChange(SetAppearance{part.id, part.def.build, part.def.motions},
                  SetAppearance{part.id, now.build, now.motions}, commands);
        addChange(SetConduct{part.id, part.def.conduct}, SetConduct{part.id, now.conduct}, commands);
        shapeAgain(part, now, commands);
        giveAll(part, world.group(*g), commands);
    }
    const auto whole = inspect::indexOfGroup(world, crowdChange.whole.id);
    if (!joined || !whole) return;
    shapeAgain(crowdChange.whole, inspect::groupDef(world, *whole), commands);
    wholeOrders(crowdChange, world, commands);
}

}  // namespace muster
