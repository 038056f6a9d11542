// The cost of an impossible pair.
#pragma once

#include <limits>

namespace muster {

/// The cost of a pair that may not be matched, and the length of a path that does not exist.
inline constexpr double kInfiniteCost = std::numeric_limits<double>::infinity();

}  // namespace muster
