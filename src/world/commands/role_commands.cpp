#include "world/commands/role_commands.h"

namespace muster {
namespace {

Status notYet() {
    return {StatusCode::Unsupported, "places have no roles yet"};
}

}  // namespace

Status setRoles(WorldState&, const SetRoles&) {
    return notYet();
}
Status setDemands(WorldState&, const SetDemands&) {
    return notYet();
}

}  // namespace muster
