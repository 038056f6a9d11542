// Starting positions on free ground.
#pragma once

#include <vector>

#include "engine/ground/environment/environment.h"
#include "muster/world.h"

namespace muster::scale {

/// The initial environment of a world made from `def`. Fails as World::create does.
Result<Environment> groundOf(const WorldDef& def);

/// The `count` innermost points of a 1 m lattice that is centred on `centre` and rotated by `angle` [rad], of
/// those on free ground connected to that at `centre`. Fails with LimitExceeded where there are fewer.
Result<std::vector<Vec2>> freeSpots(const Environment& ground, Vec2 centre, double angle, std::int32_t count);

}  // namespace muster::scale
