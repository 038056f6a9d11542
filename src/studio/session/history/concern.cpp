// What each kind of command may change.
#include <algorithm>

#include "engine/state/group_change.h"
#include "engine/world/inspect.h"
#include "studio/session/history/group_fields.h"
#include "studio/session/history/step_record.h"
#include "studio/session/inbox/generated/command_traits.h"
#include "studio/session/inbox/received_commands.h"

namespace muster {
namespace {

/// One function for each kind of command that changes more than it says, or who belongs where.
struct Concerned {
    const World& world;
    Concern concern = {};

    void operator()(const GiveOrder& c) {
        // What the group is afterwards follows from the order.
        if (shapes(c.order)) ask(ChangeGroup{.group = c.group, .formation = FormationDef{}}, true);
    }
    void operator()(const SplitGroup& c) {
        shape(c.group, true);
        concern.queues.push_back(c.group);
        members(c.group);
    }
    void operator()(const MergeGroups& c) {
        for (const GroupId group : c.groups) {
            shape(group, true);
            concern.queues.push_back(group);
            if (group == c.groups.front()) continue;
            members(group);
            ask(propertiesOf(group), false);
            concern.parts.push_back({SetPose{group, {}, 0.0}, false});
            concern.parts.push_back({RemoveGroup{group}, false});
        }
    }
    void operator()(const AddCharacters& c) { shape(c.group); }
    void operator()(const TransferCharacters& c) {
        if (c.group) shape(c.group);
        leave(c.ids);
    }
    void operator()(const ChangeGroup& c) {
        if (!c.count) return;
        shape(c.group, true);
        members(c.group);
        concern.joined.push_back(c.group);
    }
    void operator()(const ChangeCharacters& c) {
        if (c.bodies) concern.characters = c.ids;
    }
    void operator()(const RemoveGroup& c) {
        members(c.group);
        concern.queues.push_back(c.group);
    }
    template <class Other>
    void operator()(const Other& other) {
        if constexpr (requires { concern.queues.push_back(other.group); })
            if (traitsOf(other).queues) concern.queues.push_back(other.group);
    }

    static ChangeGroup propertiesOf(GroupId group) {
        ChangeGroup asked = wholeChange(group, {});
        asked.formation.reset();
        asked.count.reset();
        asked.demands.reset();
        return asked;
    }

private:
    void ask(const CommandBody& body, bool stays) {
        for (CommandBody& asked : singleFields(body)) concern.parts.push_back({std::move(asked), stays});
    }
    void shape(GroupId group, bool stays = false) {
        // Places that are held are not found again when people come back.
        const auto g = inspect::indexOfGroup(world, group);
        stays = stays || (g && inspect::ownFormation(world, *g).kind == FormationKind::Points);
        ask(ChangeGroup{.group = group, .formation = FormationDef{}, .demands = std::vector<double>()},
            stays);
    }
    void members(GroupId group) {
        const auto g = inspect::indexOfGroup(world, group);
        if (!g) return;
        for (const std::int32_t member : world.group(*g).members)
            concern.characters.push_back(world.characters().id[static_cast<std::size_t>(member)]);
    }
    void leave(const std::vector<std::uint32_t>& ids) {
        concern.characters = ids;
        std::vector<std::uint32_t> groups;
        const auto all = world.characters().id;
        for (const std::uint32_t id : ids) {
            const auto at = std::lower_bound(all.begin(), all.end(), id);
            if (at == all.end() || *at != id) continue;
            groups.push_back(world.characters().group[static_cast<std::size_t>(at - all.begin())]);
        }
        std::sort(groups.begin(), groups.end());
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
        for (const std::uint32_t g : groups) shape(world.group(g).id);
    }
};

}  // namespace

Concern concernOf(const CommandBody& body, const World& world, bool place) {
    Concerned concerned{world};
    concerned.concern.place = place;
    std::visit(concerned, body);
    return std::move(concerned.concern);
}

std::vector<CommandBody> propertiesOf(GroupId group) {
    ChangeGroup asked = wholeChange(group, {});
    asked.count.reset();
    return singleFields(asked);
}

}  // namespace muster
