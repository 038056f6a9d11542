// What the planner counts on in several of its parts, and the hands do.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace muster {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
inline constexpr double kTargetMetres = 1.0;  // What is aimed at is as large as an item's reach [m].
inline constexpr double kBetweenTaps = 0.15;  // Between two taps on one spot [s].
inline constexpr double kTakenMargin = 0.55;  // A loop is drawn so far round those whom it takes out [m].
inline constexpr std::array<double, 4> kWidths{8.0, 12.0, 16.0, 20.0};

}  // namespace muster
