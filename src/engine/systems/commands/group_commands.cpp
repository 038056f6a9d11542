// Commands that put a group elsewhere, add one or remove one.
#include "base/maths.h"
#include "engine/state/bare_groups.h"
#include "engine/state/group_edits.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"
#include "engine/systems/commands/order_queues.h"

namespace muster {

Status apply(CommandContext& context, const SetPose& set) {
    WorldState& state = context.groups();
    Group* group = state.findGroup(set.group);
    if (group == nullptr) return noGroup(set.group);
    if (state.continuum.isBare(group->id)) formUp(state, *group);
    const Pose pose{set.position, {cosine(set.angle), sine(set.angle)}};
    if (set.characters)
        if (const Status placed = standAt(state, *group, pose); !placed.ok()) return placed;
    group->controls.clear();
    state.continuum.end(group->id);
    dropOrders(*group);
    group->orders.march.reversed = false;
    if (set.characters) return {};
    group->order.begin(state.stepCount);
    group->mesh.setPose(pose);
    return {};
}

Status apply(CommandContext& context, const AddGroup& add) {
    return addGroup(context.state, add.group);
}

Status apply(CommandContext& context, const RemoveGroup& remove) {
    const Group* group = context.state.findGroup(remove.group);
    if (group == nullptr) return noGroup(remove.group);
    context.pool.wait();  // Background work reads the plan.
    removeGroup(context.state, static_cast<std::size_t>(group - context.state.groups.data()));
    return {};
}

}  // namespace muster
