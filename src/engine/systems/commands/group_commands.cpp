// Commands that change a group's formation, number and pose, or add and remove a group.
#include <algorithm>

#include "base/maths.h"
#include "engine/formation/shapes/make_formation.h"
#include "engine/state/bare_groups.h"
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/order_queues.h"

namespace muster {
namespace {

// Sets a group's formation. A group that has no formation now, or no members, takes it up later.
Status defineFormation(Group& group, const FormationDef& def) {
    const Result<Formation> formation = makeFormation(def, std::max(1, group.def.count));
    if (!formation.ok()) return formation.status().within("group '" + group.def.name + "'");
    group.def.formation = def;
    group.orders.own.reset();
    return {};
}

}  // namespace

Status apply(CommandContext& context, const SetFormation& set) {
    Group* group = context.state.findGroup(set.group);
    if (group == nullptr) return notFound("group", set.group.value);
    if (context.state.continuum.isBare(group->id) || group->members.empty())
        return defineFormation(*group, set.formation);
    const Status changed = changeFormation(context.state, *group, set.formation, group->def.count);
    if (!changed.ok()) return changed;
    group->orders.own.reset();
    context.state.continuum.end(group->id);
    return changed;
}

Status apply(CommandContext& context, const SetCount& set) {
    Group* group = context.state.findGroup(set.group);
    if (group == nullptr) return notFound("group", set.group.value);
    const std::int64_t sum = static_cast<std::int64_t>(context.state.characters.size()) - group->def.count +
                             set.count;
    const Status total = validateTotal(sum, context.state.parameters);
    if (!total.ok()) return total;
    const bool bare = context.state.continuum.isBare(group->id);
    const Status changed = bare ? Status()
                                : changeFormation(context.state, *group, group->def.formation, set.count);
    if (bare) group->def.count = set.count;
    if (changed.ok()) setCount(context.state, *group, set.count);
    return changed;
}

Status apply(CommandContext& context, const SetPose& set) {
    Group* group = context.state.findGroup(set.group);
    if (group == nullptr) return notFound("group", set.group.value);
    group->controls.clear();
    if (context.state.continuum.isBare(group->id)) formUp(context.groups(), *group);
    context.state.continuum.end(group->id);
    dropOrders(*group);
    group->orders.march.reversed = false;
    group->order.begin(context.state.stepCount);
    group->mesh.setPose({set.position, {cosine(set.angle), sine(set.angle)}});
    return {};
}

Status apply(CommandContext& context, const AddGroup& add) {
    return addGroup(context.state, add.group);
}

Status apply(CommandContext& context, const RemoveGroup& remove) {
    const Group* group = context.state.findGroup(remove.group);
    if (group == nullptr) return notFound("group", remove.group.value);
    context.pool.wait();  // Background work reads the plan.
    removeGroup(context.state, static_cast<std::size_t>(group - context.state.groups.data()));
    return {};
}

}  // namespace muster
