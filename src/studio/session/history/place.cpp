#include "studio/session/history/place.h"

#include <algorithm>

#include "base/as_mutable.h"
#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/state/group_change.h"
#include "engine/world/inspect.h"
#include "muster/ground.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

/// Turns explicit starts with the formation that they belong to.
void moveStarts(GroupDef& def, Vec2 position, double angle) {
    const double turn = angle - def.angle;
    const double c = cosine(turn), s = sine(turn);
    for (Vec2& start : def.starts) {
        const Vec2 from = start - def.position;
        start = position + Vec2{c * from.x - s * from.y, s * from.x + c * from.y};
    }
}

/// Lists that have one entry for each character follow their number.
void resizeLists(GroupDef& def, std::int32_t count) {
    const auto size = static_cast<std::size_t>(count);
    def.count = count;
    def.starts.clear();
    if (def.bodies.size() > 1) def.bodies.resize(size, def.bodies.back());
    if (!def.demands.empty()) def.demands.resize(size, 1.0);
}

/// How a group starts follows a command that changes it.
void changeStart(GroupDef& def, const ChangeGroup& change) {
    if (change.formation) {
        def.formation = *change.formation;
        def.starts.clear();
    }
    if (change.count) resizeLists(def, *change.count);
    if (change.people) def.people = *change.people;
    setPlainFields(def, change);
}

/// Puts those things that a map makes behind all others, and tells where they begin; -1 where some of them
/// are changed or gone.
template <class Def>
std::ptrdiff_t putMapLast(std::vector<Def>& defs, std::vector<std::uint32_t>& ids,
                          const std::vector<Def>& ofMap) {
    const auto from = std::search(defs.begin(), defs.end(), ofMap.begin(), ofMap.end());
    if (from == defs.end() && !ofMap.empty()) return -1;
    const auto size = static_cast<std::ptrdiff_t>(ofMap.size());
    const std::ptrdiff_t at = from - defs.begin();
    std::rotate(ids.begin() + at, ids.begin() + at + size, ids.end());
    std::rotate(from, from + size, defs.end());
    return std::ssize(defs) - size;
}

/// Puts obstacles and patches of a world into a definition, with its map where that still holds.
void putGround(PlaceDefinition& place, const Environment& environment) {
    WorldDef& def = place.def;
    def.obstacles.clear();
    def.patches.clear();
    for (const ObstacleId id : environment.obstacleIds()) {
        def.obstacles.push_back(*environment.obstacle(id));
        place.obstacles.push_back(id.value);
    }
    for (const PatchId id : environment.patchIds()) {
        def.patches.push_back(*environment.patch(id));
        place.patches.push_back(id.value);
    }
    if (!def.map) return;
    const std::ptrdiff_t obstacles = putMapLast(def.obstacles, place.obstacles,
                                                mapObstacles(def.map->grid, def.map->def));
    const std::ptrdiff_t patches = putMapLast(def.patches, place.patches,
                                              mapPatches(def.map->grid, def.map->def, 1));
    if (obstacles < 0 || patches < 0) return def.map.reset();
    def.obstacles.resize(static_cast<std::size_t>(obstacles));
    def.patches.resize(static_cast<std::size_t>(patches));
}

/// Puts items and checkpoints of a world into a definition.
void putMarks(PlaceDefinition& place, const Place& groups, const World& world) {
    place.def.items.assign(world.items().begin(), world.items().end());
    for (const ItemId id : world.itemIds()) place.items.push_back(id.value);
    place.def.checkpoints.clear();
    for (std::size_t c = 0; c < world.checkpoints().size(); ++c) {
        FormationCheckpointDef checkpoint = world.checkpoints()[c];
        const GroupId concerned = world.checkpointGroups()[c];
        const PlaceGroupDef* group = groups.group(concerned);
        if (concerned && group == nullptr) continue;  // Only a part of a group would pass it.
        checkpoint.group = group == nullptr ? -1 : static_cast<std::int32_t>(group - groups.groups().data());
        place.def.checkpoints.push_back(checkpoint);
        place.checkpoints.push_back(world.checkpointIds()[c].value);
    }
}

/// Puts areas of a world into a definition. A source whose group is only a part of one is left out.
void putAreas(PlaceDefinition& place, const Place& groups, const World& world) {
    place.def.areas.clear();
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        AreaView area = world.area(a);
        const PlaceGroupDef* group = groups.group(area.group);
        if (area.group && group == nullptr) continue;
        area.def.group = group == nullptr ? 0 : static_cast<std::int32_t>(group - groups.groups().data());
        place.def.areas.push_back(std::move(area.def));
        place.areas.push_back(area.id.value);
    }
}

/// Puts the ids of those who stand for the characters of a group.
void putCharacters(PlaceDefinition& place, const PlaceGroupDef& group, const World& world) {
    const auto count = static_cast<std::size_t>(group.def.count);
    const auto g = inspect::indexOfGroup(world, group.id);
    const auto members = g ? world.group(*g).members : std::span<const std::int32_t>();
    for (std::size_t k = 0; k < count; ++k)
        place.characters.push_back(
            members.size() == count ? world.characters().id[static_cast<std::size_t>(members[k])] : 0);
}

/// Orders name areas by the ids that these get in a world that begins with them: 1, 2, 3... in the order of
/// `ids`. What names only areas that are gone is left out.
void renumberAreas(std::vector<Order>& orders, const std::vector<std::uint32_t>& ids) {
    const auto renumbered = [&](AreaId id) {
        const auto at = std::find(ids.begin(), ids.end(), id.value);
        return at == ids.end() ? AreaId{} : AreaId{static_cast<std::uint32_t>(at - ids.begin() + 1)};
    };
    std::erase_if(orders, [&](Order& order) {
        const bool waits = static_cast<bool>(order.area), chooses = !order.exits.empty();
        order.area = renumbered(order.area);
        std::vector<AreaId> exits;
        std::vector<double> attractions;
        for (std::size_t e = 0; e < order.exits.size(); ++e) {
            const AreaId exit = renumbered(order.exits[e]);
            if (!exit) continue;
            exits.push_back(exit);
            if (e < order.attractions.size()) attractions.push_back(order.attractions[e]);
        }
        order.exits = std::move(exits);
        order.attractions = std::move(attractions);
        return (waits && !order.area) || (chooses && order.exits.empty());
    });
}

}  // namespace

void Place::begin(const WorldDef& def) {
    groups_.clear();
    for (const GroupDef& group : def.groups)
        groups_.push_back({GroupId{static_cast<std::uint32_t>(groups_.size() + 1)}, group});
    parameters_.clear();
    edited_ = false;
}

void Place::beginAgain(const PlaceDefinition& before) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        groups_[g].id = GroupId{static_cast<std::uint32_t>(g + 1)};
        renumberAreas(groups_[g].def.orders, before.areas);
    }
}

PlaceGroupDef* Place::find(GroupId id) {
    const auto at = std::find_if(groups_.begin(), groups_.end(),
                                 [&](const PlaceGroupDef& group) { return group.id == id; });
    return at == groups_.end() ? nullptr : &*at;
}

const PlaceGroupDef* Place::group(GroupId id) const {
    return asMutable(*this).find(id);
}

// Groups that are added get the highest id, and the edits of a step are applied in its order.
void Place::addNewest(const GroupDef& def, const World& world) {
    GroupId newest;
    for (const PlaceGroupDef& group : groups_) newest = std::max(newest, group.id);
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupId id = world.group(g).id;
        if (id <= newest || !(inspect::groupDef(world, g).name == def.name)) continue;
        return add(id, def);
    }
}

void Place::add(GroupId id, const GroupDef& def) {
    groups_.push_back({id, def});
}

void Place::follow(GroupId before, GroupId now) {
    if (PlaceGroupDef* group = find(before)) group->id = now;
}

void Place::setBodies(const ChangeCharacters& set, const World& world) {
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView view = world.group(g);
        PlaceGroupDef* group = find(view.id);
        if (group == nullptr || std::cmp_not_equal(group->def.count, view.members.size())) continue;
        std::vector<Body>& bodies = group->def.bodies;
        bodies.resize(view.members.size(), bodies.empty() ? Body{} : bodies.back());
        for (std::size_t k = 0; k < set.ids.size(); ++k) {
            const auto at = std::find_if(view.members.begin(), view.members.end(), [&](std::int32_t member) {
                return world.characters().id[static_cast<std::size_t>(member)] == set.ids[k];
            });
            if (at != view.members.end())
                bodies[static_cast<std::size_t>(at - view.members.begin())] = (*set.bodies)[std::min(
                    k, set.bodies->size() - 1)];
        }
        if (std::all_of(bodies.begin(), bodies.end(),
                        [&](const Body& body) { return body == bodies.front(); }))
            bodies.resize(1);
    }
}

void Place::apply(const CommandBody& edit, const World& world) {
    edited_ = true;
    const auto of = [&](GroupId id, auto change) {
        if (PlaceGroupDef* found = find(id)) change(found->def);
    };
    if (const auto* add = std::get_if<AddGroup>(&edit)) addNewest(add->group, world);
    if (const auto* remove = std::get_if<RemoveGroup>(&edit))
        std::erase_if(groups_, [&](const PlaceGroupDef& group) { return group.id == remove->group; });
    if (const auto* pose = std::get_if<SetPose>(&edit)) {
        of(pose->group, [&](GroupDef& def) {
            moveStarts(def, pose->position, pose->angle);
            def.position = pose->position;
            def.angle = pose->angle;
        });
    }
    if (const auto* change = std::get_if<ChangeGroup>(&edit))
        of(change->group, [&](GroupDef& def) { changeStart(def, *change); });
    if (const auto* set = std::get_if<ChangeCharacters>(&edit)) setBodies(*set, world);
    if (const auto* set = std::get_if<SetParameter>(&edit)) parameters_.push_back(*set);
}

PlaceDefinition Place::definition(const WorldDef& began, const World& world) const {
    PlaceDefinition place;
    place.def = began;
    putGround(place, inspect::environment(world));
    putMarks(place, *this, world);
    putAreas(place, *this, world);
    place.def.groups.clear();
    for (const PlaceGroupDef& group : groups_) {
        place.def.groups.push_back(group.def);
        renumberAreas(place.def.groups.back().orders, place.areas);
        place.groups.push_back(group.id.value);
        putCharacters(place, group, world);
    }
    for (const SetParameter& set : parameters_) (void)setParameter(place.def.parameters, set.name, set.value);
    return place;
}

}  // namespace muster
