#include "engine/state/bare_groups.h"

#include <algorithm>
#include <utility>

#include "engine/formation/shapes/make_formation.h"
#include "engine/state/group_edits.h"
#include "engine/state/reform.h"

namespace muster {
namespace {

// Points are the places of a formation that has none now; other shapes are made for any number.
HeldPlaces definedPlaces(const Group& group) {
    HeldPlaces held;
    if (group.def.formation.kind != FormationKind::Points) return held;
    held.rest = group.def.formation.points;
    held.occupants.assign(held.rest.size(), 0);
    held.origins.assign(held.rest.size(), {});
    return held;
}

}  // namespace

void dissolveFormation(WorldState& state, Group& group) {
    const Characters& c = state.characters;
    leavePlaces(state, group);
    std::erase_if(state.ownRoutes, [&](const OwnRoute& route) {
        const std::int32_t i = c.indexOf(route.character);
        return i < 0 || &state.groups[c.group[i]] == &group;
    });
    group.places.assemble({});
    group.mesh.setPlaces({});
    group.def.demands.clear();
    group.lastAssignment.clear();
    group.placeClass.clear();
    group.room = {};
    group.flow = {};
    group.avoidance = {};
    // While it makes no plans it follows no changes of the ground either.
    group.plan = makePlan(state.parameters);
    group.slices = 1;
    group.meanLag = 0.0;
    group.refitted = false;
    ++group.formationVersion;
}

void formUp(WorldState& state, Group& group) {
    std::vector<std::uint32_t> ids;
    for (const std::int32_t i : group.members) {
        ids.push_back(state.characters.id[i]);
        state.characters.goal[i] = 0;
    }
    const HeldPlaces held = definedPlaces(group);
    FormationDef def = resized(group, held, ids, true);
    const HeldPlaces none;
    Result<Reform> reform = refit(state, group, none, def, ids);
    if (!reform.ok()) {
        def = {};
        def.spacing = group.def.formation.spacing;
        reform = refit(state, group, none, def, ids);
    }
    MUSTER_ASSERT(reform.ok());
    if (!reform->unmoved.empty()) reform->formation.mesh.vertices = std::move(reform->unmoved);
    applyReform(state, group, std::move(*reform), group.mesh);
    group.refitted = false;
    group.planNow = !group.members.empty();
    group.order.begin(state.stepCount);
    group.order.withoutWay = 0;
}

std::size_t joinBare(WorldState& state, Group& group, Vec2 position, const Body& body) {
    const auto index = static_cast<std::uint32_t>(&group - state.groups.data());
    const std::size_t i = addCharacter(state, group, index, position, body);
    group.members.push_back(static_cast<std::int32_t>(i));
    ++group.def.count;
    return i;
}

}  // namespace muster
