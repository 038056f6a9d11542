#include "engine/world/take_up.h"

#include "engine/world/world_engine.h"

namespace muster {

std::size_t dropWaitingCommands(World& world) {
    std::vector<Command>& queue = WorldAccess::of(world).state.queue;
    const std::size_t dropped = queue.size();
    queue.clear();
    return dropped;
}

}  // namespace muster
