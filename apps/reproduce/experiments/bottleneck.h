// The least longest walk from starts to places: no assignment lets everybody be there earlier.
#pragma once

#include <span>

#include "muster/vec2.h"

namespace muster {

/// The smallest d such that every start can be given a place of its own at most d away in a straight line
/// [m]: the value of the bottleneck assignment. 0 without starts; -1 where there are fewer places than
/// starts.
double bottleneckWalk(std::span<const Vec2> starts, std::span<const Vec2> places);

}  // namespace muster
