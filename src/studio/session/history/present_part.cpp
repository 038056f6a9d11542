// What the world says, in the words of the commands that set it.
#include <algorithm>

#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/state/group_change.h"
#include "engine/world/inspect.h"
#include "muster/parameter_table.h"
#include "studio/session/history/definition.h"
#include "studio/session/history/group_fields.h"

namespace muster {
namespace {

using Said = std::optional<CommandBody>;

template <class AnyId>
std::optional<std::size_t> indexOfId(std::span<const AnyId> ids, AnyId id) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    if (at == ids.end() || *at != id) return std::nullopt;
    return static_cast<std::size_t>(at - ids.begin());
}

/// A group that begins as it is now.
GroupDef wholeGroup(const World& world, std::size_t g) {
    const GroupView view = world.group(g);
    GroupDef def = inspect::groupDef(world, g);
    def.formation = inspect::ownFormation(world, g);
    def.position = view.pose.position;
    def.angle = arcTangent2(view.pose.rotation.s, view.pose.rotation.c);
    def.jitter = 0.0;
    def.starts.clear();
    def.bodies.clear();
    for (const std::int32_t member : view.members) {
        def.starts.push_back(world.characters().position[static_cast<std::size_t>(member)]);
        def.bodies.push_back(world.characters().body[static_cast<std::size_t>(member)]);
    }
    def.count = static_cast<std::int32_t>(def.starts.size());
    def.orders.clear();
    for (const QueuedOrder& order : view.orders) def.orders.push_back(order.order);
    def.patrols = view.patrols;
    return def;
}

/// What a definition of a group says.
struct OfGroup {
    const GroupDef& def;

    Said operator()(const ChangeGroup& c) const { return sameFields(wholeChange(c.group, def), c); }
    Said operator()(const SetPose& c) const {
        return c.characters ? Said(SetPose{c.group, def.position, def.angle, true}) : Said();
    }
    template <class Other>
    Said operator()(const Other&) const {
        return {};
    }
};

/// A thing of that kind and id, as it is put.
Said presentThing(ThingKind thing, std::uint32_t id, const World& world) {
    const Environment& ground = inspect::environment(world);
    PutThing put;
    put.id = id;
    if (thing == ThingKind::Obstacle) {
        if (const ObstacleDef* def = ground.obstacle(ObstacleId{id})) put.obstacle = *def;
    } else if (thing == ThingKind::Patch) {
        if (const PatchDef* def = ground.patch(PatchId{id})) put.patch = *def;
    } else if (thing == ThingKind::Item) {
        if (const auto at = indexOfId(world.itemIds(), ItemId{id})) put.item = world.items()[*at];
    } else if (thing == ThingKind::Checkpoint) {
        if (const auto at = indexOfId(world.checkpointIds(), CheckpointId{id})) {
            put.checkpoint = world.checkpoints()[*at];
            put.group = world.checkpointGroups()[*at];
        }
    } else {
        for (std::size_t a = 0; a < world.areaCount(); ++a) {
            const AreaView area = world.area(a);
            if (area.id != AreaId{id}) continue;
            put.area = area.def;
            put.group = area.group;
        }
    }
    return thingOf(put) ? Said(put) : Said();
}

/// One function for each kind of command that sets a property or removes a thing.
struct Present {
    const World& world;

    Said operator()(const PutThing& c) const {
        const auto thing = thingOf(c);
        return thing ? presentThing(*thing, c.id, world) : Said();
    }
    Said operator()(const RemoveThing& c) const { return presentThing(c.thing, c.id, world); }
    Said operator()(const RemoveGroup& c) const {
        return onGroup(c.group,
                       [&](std::size_t g, const GroupDef&) { return AddGroup{wholeGroup(world, g)}; });
    }
    Said operator()(const ChangeGroup& c) const {
        return onGroup(c.group, [&](std::size_t g, const GroupDef& def) {
            ChangeGroup whole = wholeChange(c.group, def);
            whole.formation = inspect::ownFormation(world, g);
            return sameFields(std::move(whole), c);
        });
    }
    Said operator()(const SetPose& c) const {
        return onGroup(c.group, [&](std::size_t g, const GroupDef&) {
            const Pose pose = world.group(g).pose;
            return SetPose{c.group, pose.position, arcTangent2(pose.rotation.s, pose.rotation.c),
                           c.characters};
        });
    }
    Said operator()(const EditControl& c) const {
        const auto g = inspect::indexOfGroup(world, c.group);
        if (!g) return {};
        for (const Control& control : world.group(*g).controls)
            if (control.id == c.control)
                return EditControl{c.group, c.control,
                                   control.pinned ? ControlEdit::Pin : ControlEdit::Release};
        return {};
    }
    Said operator()(const SetParameter& c) const {
        for (const ParameterInfo& info : parameterTable())
            if (c.name == info.name) return SetParameter{c.name, info.get(world.parameters())};
        return {};
    }
    template <class Other>
    Said operator()(const Other& c) const {
        if constexpr (requires { c.group.value; })
            return onGroup(c.group, [&](std::size_t, const GroupDef& def) { return OfGroup{def}(c); });
        return {};
    }

private:
    template <class Make>
    Said onGroup(GroupId id, Make make) const {
        const auto g = inspect::indexOfGroup(world, id);
        return g ? Said(make(*g, inspect::groupDef(world, *g))) : Said();
    }
};

/// The group of which the command says something; none for other commands.
struct GroupSaid {
    template <class Body>
    GroupId operator()(const Body& c) const {
        if constexpr (requires { c.group.value; }) return c.group;
        return {};
    }
};

}  // namespace

Said presentPart(const CommandBody& asked, bool start, const Scene& scene) {
    Said said;
    if (!start)
        said = std::visit(Present{scene.world}, asked);
    else if (const PlaceGroupDef* group = scene.place.group(std::visit(GroupSaid{}, asked)))
        said = std::visit(OfGroup{group->def}, asked);
    if (said) scene.names.toNames(*said);
    return said;
}

MemberState presentMember(std::uint32_t id, const World& world, Names& names) {
    const CharactersView all = world.characters();
    const auto at = indexOfId(all.id, id);
    if (!at) return {};
    const GroupId group = world.group(all.group[*at]).id;
    return {names.nameOf(SubjectKind::Group, group.value), all.position[*at], all.body[*at]};
}

}  // namespace muster
