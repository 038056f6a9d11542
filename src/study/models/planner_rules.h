// What the planner counts on in several of its parts.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace muster {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
inline constexpr double kTargetMetres = 1.0;  // What is aimed at is as large as an item's reach [m].
inline constexpr std::array<double, 4> kWidths{8.0, 12.0, 16.0, 20.0};

}  // namespace muster
