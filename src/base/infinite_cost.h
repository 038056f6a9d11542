// The cost of what is impossible.
#pragma once

#include <limits>

namespace muster {

/// The cost of a pair that may not be matched, of a path that does not exist, and of one that is unknown.
inline constexpr double kInfiniteCost = std::numeric_limits<double>::infinity();

}  // namespace muster
