// The command that changes what a group is: formation, number, people, conduct, roles, demands, name and
// look.
#include <algorithm>
#include <string>

#include "engine/formation/shapes/make_formation.h"
#include "engine/state/draw_person.h"
#include "engine/state/group_change.h"
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"

namespace muster {
namespace {

/// The number of characters must fit the world, and demands the places that there are then.
Status canChange(const WorldState& state, const Group& group, const ChangeGroup& change) {
    if (change.count) {
        const std::int64_t sum = static_cast<std::int64_t>(state.characters.size()) - group.def.count +
                                 *change.count;
        if (const Status total = validateTotal(sum, state.parameters); !total.ok()) return total;
    }
    if (!change.demands || change.demands->empty()) return {};
    const std::size_t places = change.count && !state.continuum.isBare(group.id)
                                   ? static_cast<std::size_t>(*change.count)
                                   : group.places.positions().size();
    if (change.demands->size() == places) return {};
    return invalidArgument("found " + std::to_string(change.demands->size()) +
                           " demands, expected one for each of the " + std::to_string(places) + " places");
}

/// Gives the group its formation with so many places. One that has no formation now, or no members, takes it
/// up later.
Status reshape(WorldState& state, Group& group, const ChangeGroup& change) {
    if (!change.formation && !change.count) return {};
    const FormationDef def = change.formation.value_or(group.def.formation);
    const std::int32_t count = change.count.value_or(group.def.count);
    const bool bare = state.continuum.isBare(group.id);
    const bool later = bare || (group.members.empty() && !change.count);
    if (!later) {
        if (const Status changed = changeFormation(state, group, def, count); !changed.ok()) return changed;
    } else if (change.formation) {
        const Result<Formation> formation = makeFormation(def, std::max(1, count));
        if (!formation.ok()) return formation.status().within("group '" + group.def.name + "'");
    }
    if (bare) group.def.count = count;
    if (!change.formation) return {};
    group.def.formation = def;
    group.orders.own.reset();
    if (!later) state.continuum.end(group.id);
    return {};
}

/// Draws all members again: each number that neither the sorts before nor these draw stays as it is.
void drawPeople(WorldState& state, Group& group, const std::vector<PeopleDef>& people) {
    Characters& c = state.characters;
    std::vector<std::uint32_t> ids;
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        ids.push_back(c.id[i]);
        bodies.push_back(withoutSorts(group.def, k, c.body[i]));
    }
    group.def.people = people;
    drawAll(group.def.people, state.seed, ids, bodies);
    for (std::size_t k = 0; k < bodies.size(); ++k)
        c.body[static_cast<std::size_t>(group.members[k])] = bodies[k];
}

}  // namespace

Status apply(CommandContext& context, const ChangeGroup& change) {
    WorldState& state = context.groups();
    Group* const group = state.findGroup(change.group);
    if (group == nullptr) return noGroup(change.group);
    if (const Status can = canChange(state, *group, change); !can.ok()) return can;
    if (const Status shaped = reshape(state, *group, change); !shaped.ok()) return shaped;
    if (change.people) drawPeople(state, *group, *change.people);
    if (change.count) setCount(state, *group, *change.count);
    setPlainFields(group->def, change);
    return {};
}

}  // namespace muster
