// The cost of a pair of points without a path between them.
#pragma once

#include <limits>

namespace muster {

/// Stands for "unreachable" and for "unknown" where costs are doubles [m].
inline constexpr double kInfiniteCost = std::numeric_limits<double>::infinity();

}  // namespace muster
