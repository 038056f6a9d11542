#include <string>

#include "engine/state/validation.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"

namespace muster {
Status apply(CommandContext& context, const SetRoles& command) {
    WorldState& state = context.groups();
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    if (Status s = validateRoles(command.roles); !s.ok()) return s;
    group->def.roles = command.roles;
    return {};
}

Status apply(CommandContext& context, const SetDemands& command) {
    WorldState& state = context.groups();
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    if (Status s = validateDemands(command.demands); !s.ok()) return s;
    const std::size_t places = group->places.positions().size();
    if (!command.demands.empty() && command.demands.size() != places)
        return invalidArgument("found " + std::to_string(command.demands.size()) +
                               " demands, expected one for each of the " + std::to_string(places) +
                               " places");
    group->def.demands = command.demands;
    return {};
}

}  // namespace muster
