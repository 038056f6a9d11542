// The cost of impossible pairs and paths.
#pragma once

#include <limits>

namespace muster {

/// The cost of a pair that may not be matched, of a path that does not exist, and of an unknown path.
inline constexpr double kInfiniteCost = std::numeric_limits<double>::infinity();

}  // namespace muster
