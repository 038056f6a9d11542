// Free spots to stand on.
#pragma once

#include <vector>

#include "environment/environment.h"
#include "muster/world_def.h"

namespace muster::scale {

/// The ground that a world made from `def` would begin with. Fails as that would.
Result<Environment> groundOf(const WorldDef& def);

/// `count` spots of a lattice of 1 m round `centre`, turned by `angle`, where a character can stand and walk
/// to the free ground nearest to `centre`: the innermost of a growing square. Fails with LimitExceeded where
/// there are fewer.
Result<std::vector<Vec2>> freeSpots(const Environment& ground, Vec2 centre, double angle, std::int32_t count);

}  // namespace muster::scale
