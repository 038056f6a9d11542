// Orders: what groups are to do, one after the other, and how they behave meanwhile (SPEC B3, B11, B12, B14,
// B15).
#pragma once

#include <vector>

#include "muster/formation.h"
#include "muster/generated/orders_definitions.h"
#include "muster/vec2.h"

namespace muster {

/// What would come of an order.
struct OrderForecast {
    bool arrives = false;   ///< True where the target can be reached.
    std::vector<Vec2> way;  ///< The way of the formation's centre, both ends included [m].
    Vec2 end;               ///< Where the formation would stand: the target, or the nearest ground to it [m].
    double seconds = 0.0;   ///< Time until it would arrive [s]; infinite where it never does.
};

}  // namespace muster
