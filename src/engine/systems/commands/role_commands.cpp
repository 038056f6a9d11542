#include "engine/systems/commands/role_commands.h"

#include <string>

#include "engine/state/validation.h"

namespace muster {
namespace {

Status noSuchGroup(GroupId id) {
    return {StatusCode::NotFound, "there is no group " + std::to_string(id.value)};
}

}  // namespace

Status setRoles(WorldState& state, const SetRoles& command) {
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noSuchGroup(command.group);
    if (Status s = validateRoles(command.roles); !s.ok()) return s;
    group->def.roles = command.roles;
    return {};
}

Status setDemands(WorldState& state, const SetDemands& command) {
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noSuchGroup(command.group);
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
