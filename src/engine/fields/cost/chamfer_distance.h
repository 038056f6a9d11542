// Chamfer distance transform (Borgefors 1986).
#pragma once

#include <cstdint>
#include <vector>

namespace muster {

/// Steps over cells overestimate the Euclidean distance by up to 8 %: this factor makes them a lower bound.
inline constexpr float kChamferLowerBound = 0.92f;

/// Replaces each value by the least sum of a value and the path to it over the eight neighbours [cells], in
/// two sweeps over a row-major raster. Zeros and large values give the distance to the nearest zero.
void chamferDistance(std::int32_t width, std::int32_t height, std::vector<float>& values);

}  // namespace muster
