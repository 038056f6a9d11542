// The command that sets a parameter.
#include "engine/state/group_edits.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "muster/parameter_table.h"

namespace muster {

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
