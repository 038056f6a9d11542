#include "studio/session/history/place_edit.h"

#include <algorithm>

#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

/// Calls `visit(kind, id)` for all ids that a command names, its own thing first.
template <class Visit>
struct IdVisitor {
    Visit visit;

    void operator()(ChangeObstacle& c) { visit(ThingKind::Obstacle, c.id.value); }
    void operator()(RemoveObstacle& c) { visit(ThingKind::Obstacle, c.id.value); }
    void operator()(ChangePatch& c) { visit(ThingKind::Patch, c.id.value); }
    void operator()(RemovePatch& c) { visit(ThingKind::Patch, c.id.value); }
    void operator()(ChangeItem& c) { visit(ThingKind::Item, c.id.value); }
    void operator()(RemoveItem& c) { visit(ThingKind::Item, c.id.value); }
    void operator()(AddCheckpoint& c) { visit(ThingKind::Group, c.group.value); }
    void operator()(ChangeCheckpoint& c) {
        visit(ThingKind::Checkpoint, c.id.value);
        visit(ThingKind::Group, c.group.value);
    }
    void operator()(RemoveCheckpoint& c) { visit(ThingKind::Checkpoint, c.id.value); }
    void operator()(PutArea& c) {
        if (c.id) visit(ThingKind::Area, c.id.value);
        visit(ThingKind::Group, c.group.value);
    }
    void operator()(RemoveArea& c) { visit(ThingKind::Area, c.id.value); }
    template <class Body>
    void operator()(Body& c) {
        if constexpr (requires { c.group.value; }) visit(ThingKind::Group, c.group.value);
    }
};

template <class Visit>
void visitIds(CommandBody& body, Visit visit) {
    std::visit(IdVisitor<Visit>{visit}, body);
}

template <class AnyId>
std::optional<std::size_t> indexOf(std::span<const AnyId> ids, AnyId id) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    if (at == ids.end() || *at != id) return std::nullopt;
    return static_cast<std::size_t>(at - ids.begin());
}

/// One function for each kind of edit.
struct Inverse {
    using Answer = std::optional<CommandBody>;
    const World& world;
    const Place& place;
    const Environment& ground = inspect::environment(world);

    Answer operator()(const AddObstacle&) const { return RemoveObstacle{}; }
    Answer operator()(const ChangeObstacle& c) const {
        const ObstacleDef* def = ground.obstacle(c.id);
        return def == nullptr ? Answer() : ChangeObstacle{c.id, *def};
    }
    Answer operator()(const RemoveObstacle& c) const {
        const ObstacleDef* def = ground.obstacle(c.id);
        return def == nullptr ? Answer() : AddObstacle{*def};
    }
    Answer operator()(const AddPatch&) const { return RemovePatch{}; }
    Answer operator()(const ChangePatch& c) const {
        const PatchDef* def = ground.patch(c.id);
        return def == nullptr ? Answer() : ChangePatch{c.id, *def};
    }
    Answer operator()(const RemovePatch& c) const {
        const PatchDef* def = ground.patch(c.id);
        return def == nullptr ? Answer() : AddPatch{*def};
    }
    Answer operator()(const AddItem&) const { return RemoveItem{}; }
    Answer operator()(const ChangeItem& c) const {
        const auto at = indexOf(world.itemIds(), c.id);
        return at ? ChangeItem{c.id, world.items()[*at]} : Answer();
    }
    Answer operator()(const RemoveItem& c) const {
        const auto at = indexOf(world.itemIds(), c.id);
        return at ? AddItem{world.items()[*at]} : Answer();
    }
    Answer operator()(const AddCheckpoint&) const { return RemoveCheckpoint{}; }
    Answer operator()(const ChangeCheckpoint& c) const {
        const auto at = indexOf(world.checkpointIds(), c.id);
        if (!at) return {};
        return ChangeCheckpoint{c.id, world.checkpoints()[*at], world.checkpointGroups()[*at]};
    }
    Answer operator()(const RemoveCheckpoint& c) const {
        const auto at = indexOf(world.checkpointIds(), c.id);
        return at ? AddCheckpoint{world.checkpoints()[*at], world.checkpointGroups()[*at]} : Answer();
    }
    Answer operator()(const PutArea& c) const {
        if (!c.id) return RemoveArea{};
        const auto area = areaOf(c.id);
        return area ? PutArea{c.id, area->def, area->group} : Answer();
    }
    Answer operator()(const RemoveArea& c) const {
        const auto area = areaOf(c.id);
        return area ? PutArea{{}, area->def, area->group} : Answer();
    }
    Answer operator()(const AddGroup&) const { return RemoveGroup{}; }
    Answer operator()(const RemoveGroup& c) const {
        if (const PlaceGroupDef* group = place.group(c.group)) return AddGroup{group->def};
        return onGroup(c.group, [&](std::size_t g, const GroupDef& now) {
            GroupDef def = now;
            def.position = world.group(g).pose.position;
            def.starts.clear();
            for (const std::int32_t member : world.group(g).members)
                def.starts.push_back(world.characters().position[static_cast<std::size_t>(member)]);
            def.count = static_cast<std::int32_t>(def.starts.size());
            return AddGroup{def};
        });
    }
    Answer operator()(const PlaceGroup& c) const {
        if (const PlaceGroupDef* group = place.group(c.group))
            return PlaceGroup{c.group, group->def.position, group->def.angle};
        return onGroup(c.group, [&](std::size_t g, const GroupDef& def) {
            return PlaceGroup{c.group, world.group(g).pose.position, def.angle};
        });
    }
    Answer operator()(const NameGroup& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return NameGroup{c.group, def.name};
        });
    }
    Answer operator()(const ColourGroup& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return ColourGroup{c.group, def.colour};
        });
    }
    Answer operator()(const SetAppearance& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return SetAppearance{c.group, def.build, def.motions};
        });
    }
    Answer operator()(const SetPeople& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return SetPeople{c.group, def.people};
        });
    }
    Answer operator()(const SetCount& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return SetCount{c.group, def.count};
        });
    }
    Answer operator()(const SetFormation& c) const {
        return onGroup(c.group, [&](std::size_t g, const GroupDef&) {
            return SetFormation{c.group, inspect::ownFormation(world, g)};
        });
    }
    Answer operator()(const SetPose& c) const {
        return onGroup(c.group, [&](std::size_t g, const GroupDef&) {
            const Pose pose = world.group(g).pose;
            return SetPose{c.group, pose.position, arcTangent2(pose.rotation.s, pose.rotation.c)};
        });
    }
    Answer operator()(const PinControl& c) const {
        const auto g = inspect::indexOfGroup(world, c.group);
        if (!g) return {};
        const auto controls = world.group(*g).controls;
        const auto at = std::find_if(controls.begin(), controls.end(),
                                     [&](const Control& control) { return control.id == c.control; });
        return at == controls.end() ? Answer() : PinControl{c.group, c.control, at->pinned};
    }
    Answer operator()(const SetConduct& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return SetConduct{c.group, def.conduct};
        });
    }
    Answer operator()(const SetRoles& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return SetRoles{c.group, def.roles};
        });
    }
    Answer operator()(const SetDemands& c) const {
        return onGroup(c.group, [&](std::size_t, const GroupDef& def) {
            return SetDemands{c.group, def.demands};
        });
    }
    Answer operator()(const SetBodies& c) const {
        SetBodies before{c.ids, {}};
        for (const std::uint32_t id : c.ids) {
            const auto at = indexOf(world.characters().id, id);
            if (!at) return {};
            before.bodies.push_back(world.characters().body[*at]);
        }
        return before;
    }
    Answer operator()(const SetParameter& c) const {
        for (const ParameterInfo& info : parameterTable())
            if (c.name == info.name) return SetParameter{c.name, info.get(world.parameters())};
        return {};
    }
    template <class Other>
    Answer operator()(const Other&) const {
        return {};
    }

private:
    std::optional<AreaView> areaOf(AreaId id) const {
        for (std::size_t a = 0; a < world.areaCount(); ++a)
            if (AreaView area = world.area(a); area.id == id) return area;
        return std::nullopt;
    }
    template <class Make>
    Answer onGroup(GroupId id, Make make) const {
        const auto g = inspect::indexOfGroup(world, id);
        return g ? Answer(make(*g, inspect::groupDef(world, *g))) : Answer();
    }
};

bool addsArea(const CommandBody& body) {
    const auto* put = std::get_if<PutArea>(&body);
    return put != nullptr && !put->id;
}

/// Id of the first thing above `after` that equals the definition; 0 for none.
template <class Ids, class Same>
std::uint32_t firstAbove(const Ids& ids, std::uint32_t after, Same same) {
    for (std::size_t k = 0; k < ids.size(); ++k)
        if (ids[k].value > after && same(k)) return ids[k].value;
    return 0;
}

}  // namespace

std::optional<Thing> thingOf(const CommandBody& body) {
    if (std::holds_alternative<SetBodies>(body)) return Thing{ThingKind::Characters, 0};
    if (std::holds_alternative<SetParameter>(body)) return Thing{ThingKind::Parameter, 0};
    if (std::holds_alternative<AddObstacle>(body)) return Thing{ThingKind::Obstacle, 0};
    if (std::holds_alternative<AddPatch>(body)) return Thing{ThingKind::Patch, 0};
    if (std::holds_alternative<AddItem>(body)) return Thing{ThingKind::Item, 0};
    if (std::holds_alternative<AddCheckpoint>(body)) return Thing{ThingKind::Checkpoint, 0};
    if (std::holds_alternative<AddGroup>(body)) return Thing{ThingKind::Group, 0};
    if (addsArea(body)) return Thing{ThingKind::Area, 0};
    std::optional<Thing> thing;
    CommandBody copy = body;
    visitIds(copy, [&](ThingKind kind, std::uint32_t id) {
        if (!thing) thing = Thing{kind, id};
    });
    return thing;
}

bool adds(const CommandBody& body) {
    return std::holds_alternative<AddObstacle>(body) || std::holds_alternative<AddPatch>(body) ||
           std::holds_alternative<AddItem>(body) || std::holds_alternative<AddCheckpoint>(body) ||
           std::holds_alternative<AddGroup>(body) || addsArea(body);
}

std::optional<CommandBody> inverseOf(const CommandBody& body, const World& world, const Place& place) {
    return std::visit(Inverse{world, place}, body);
}

std::uint32_t addedId(const CommandBody& added, const World& world, std::uint32_t after) {
    const Environment& ground = inspect::environment(world);
    if (const auto* add = std::get_if<AddObstacle>(&added)) {
        const auto ids = ground.obstacleIds();
        return firstAbove(ids, after,
                          [&](std::size_t k) { return *ground.obstacle(ids[k]) == add->obstacle; });
    }
    if (const auto* add = std::get_if<AddPatch>(&added)) {
        const auto ids = ground.patchIds();
        return firstAbove(ids, after, [&](std::size_t k) { return *ground.patch(ids[k]) == add->patch; });
    }
    if (const auto* add = std::get_if<AddItem>(&added))
        return firstAbove(world.itemIds(), after,
                          [&](std::size_t k) { return world.items()[k].position == add->item.position; });
    if (const auto* add = std::get_if<AddCheckpoint>(&added))
        return firstAbove(world.checkpointIds(), after, [&](std::size_t k) {
            return world.checkpoints()[k].position == add->checkpoint.position;
        });
    if (const auto* add = std::get_if<AddGroup>(&added)) {
        for (std::size_t g = 0; g < world.groupCount(); ++g)
            if (world.group(g).id.value > after && world.group(g).name == add->group.name)
                return world.group(g).id.value;
    }
    if (const auto* add = std::get_if<PutArea>(&added)) {
        for (std::size_t a = 0; a < world.areaCount(); ++a)
            if (const AreaView area = world.area(a); area.id.value > after && area.def == add->area)
                return area.id.value;
    }
    return 0;
}

std::vector<std::uint32_t> highestIds(const World& world) {
    const auto last = [](const auto& ids) { return ids.empty() ? 0u : ids.back().value; };
    const Environment& ground = inspect::environment(world);
    const std::size_t groups = world.groupCount(), areas = world.areaCount();
    return {last(ground.obstacleIds()),
            last(ground.patchIds()),
            last(world.itemIds()),
            last(world.checkpointIds()),
            groups == 0 ? 0u : world.group(groups - 1).id.value,
            areas == 0 ? 0u : world.area(areas - 1).id.value,
            0u,
            0u};
}

void rename(CommandBody& body, Thing from, std::uint32_t to) {
    visitIds(body, [&](ThingKind kind, std::uint32_t& id) {
        if (kind == from.kind && id == from.id) id = to;
    });
}

}  // namespace muster
