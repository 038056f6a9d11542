#include "world/commands/body_commands.h"

namespace muster {
namespace {

Status notYet() {
    return {StatusCode::Unsupported, "characters have no bodies of their own yet"};
}

}  // namespace

Status setBodies(WorldState&, const SetBodies&) {
    return notYet();
}
Status setDriver(WorldState&, const SetDriver&) {
    return notYet();
}
Status writeMotion(WorldState&, const WriteMotion&) {
    return notYet();
}

}  // namespace muster
