#include "engine/systems/orders/premovement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

// The first step at or after a time, up to rounding.
std::uint32_t stepsUntil(double seconds, double stepTime, std::uint32_t now) {
    const double last = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(last, now + std::ceil(seconds / stepTime - 1e-9)));
}

}  // namespace

void hearOrders(WorldState& state) {
    Characters& c = state.characters;
    for (const Group& group : state.groups) {
        if (group.orders.orders.empty() || group.orders.held) continue;
        for (const std::int32_t i : group.members)
            if (c.setsOutAt[i] == 0)
                c.setsOutAt[i] = stepsUntil(c.body[i].premovement, state.parameters.stepTime,
                                            state.stepCount);
    }
}

}  // namespace muster
