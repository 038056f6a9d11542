// Points moved a diameter apart.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/formation/place_tracker.h"

namespace muster {

/// Moves points that lie nearer than `apart` [m] away from each other, once; what moved is marked in
/// `moved`. Returns false where none were too near. Coincident points part in fixed directions.
bool partClosePairs(std::vector<Vec2>& points, double apart, SpacingMemory& memory, std::vector<std::uint8_t>& moved);

/// Marks with 0 every point that lies nearer than `apart` [m] to one of lower index marked with 1.
void markUnfit(const std::vector<Vec2>& points, double apart, SpacingMemory& memory, std::vector<std::uint8_t>& fit);

}  // namespace muster
