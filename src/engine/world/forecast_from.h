// What would come of an order after others.
#pragma once

#include "muster/order.h"
#include "muster/vec2.h"
#include "muster/world.h"

namespace muster {

/// As World::forecast, but from a pose to which another order would have brought the formation. Its position
/// is moved into the world's box.
OrderForecast forecastFrom(const World& world, GroupId group, const Order& order, const Pose& from);

}  // namespace muster
