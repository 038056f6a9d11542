// Commands that edit the ground, and parameters.
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

// Counts an edit of the ground that has succeeded; returns its status.
Status edited(WorldState& state, Status status) {
    state.groundEdits += status.ok() ? 1 : 0;
    return status;
}

}  // namespace

Status apply(CommandContext& context, const AddObstacle& add) {
    return edited(context.state, context.ground().addObstacle(add.obstacle).status());
}

Status apply(CommandContext& context, const ChangeObstacle& change) {
    return edited(context.state, context.ground().changeObstacle(change.id, change.obstacle));
}

Status apply(CommandContext& context, const RemoveObstacle& remove) {
    return edited(context.state, context.ground().removeObstacle(remove.id));
}

Status apply(CommandContext& context, const AddPatch& add) {
    return edited(context.state, context.ground().addPatch(add.patch).status());
}

Status apply(CommandContext& context, const ChangePatch& change) {
    return edited(context.state, context.ground().changePatch(change.id, change.patch));
}

Status apply(CommandContext& context, const RemovePatch& remove) {
    return edited(context.state, context.ground().removePatch(remove.id));
}

Status apply(CommandContext& context, const SetParameter& set) {
    if (set.name == "time.step")
        return invalidArgument("parameter 'time.step' stands for the life of a world");
    Parameters next = context.state.parameters;
    Status status = setParameter(next, set.name, set.value);
    if (status.ok()) status = validateParameters(next, context.state.environment.def().box);
    if (status.ok()) status = validateTotal(static_cast<std::int64_t>(context.state.characters.size()), next);
    if (!status.ok()) return status;
    const bool exchanged = next.plan.solver != context.state.parameters.plan.solver;
    context.state.parameters = next;
    if (exchanged) {
        context.pool.wait();  // Background work reads the plans.
        exchangePlans(context.state);
    }
    context.ground().setFieldDefaults(next.field.range, next.field.strength);
    return status;
}

}  // namespace muster
