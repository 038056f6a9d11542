#include "world/commands/order_commands.h"

namespace muster {
namespace {

Status notYet() {
    return {StatusCode::Unsupported, "orders are not carried out yet"};
}

}  // namespace

Status giveOrder(WorldState&, const GiveOrder&, std::vector<Event>&) {
    return notYet();
}

Status editQueue(WorldState&, const EditQueue&, std::vector<Event>&) {
    return notYet();
}

Status setConduct(WorldState& state, const SetConduct& command) {
    Group* const group = state.findGroup(command.group);
    if (group == nullptr)
        return {StatusCode::NotFound, "no group has the id " + std::to_string(command.group.value)};
    group->def.conduct = command.conduct;
    return {};
}

}  // namespace muster
