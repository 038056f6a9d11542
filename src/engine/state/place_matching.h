// Which place of a new formation goes on from which former one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// For each of `to` one of `from`, -1 for none: each takes the nearest that is still free within `reach`, all
/// in [m]. Lower indices choose first.
std::vector<std::int32_t> matchNear(std::span<const Vec2> to, std::span<const Vec2> from, double reach);

/// For each of `to` one of `from`, -1 for none, so that as many as possible are matched at a low sum of
/// squared distances: near the least up to 128 of `from`, roughly where there are more; plans improve that.
std::vector<std::int32_t> matchAll(std::span<const Vec2> to, std::span<const Vec2> from);

}  // namespace muster
