// Commands that say how a group starts, is called and looks, and what persons it has.
#include "base/maths.h"
#include "engine/state/bare_groups.h"
#include "engine/state/draw_person.h"
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/order_queues.h"

namespace muster {

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
