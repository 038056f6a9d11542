// The bottleneck assignment of starts to places: the least possible longest walk.
#pragma once

#include <span>

#include "muster/vec2.h"

namespace muster {

/// The value of the bottleneck assignment by straight distances: the smallest d such that every start can
/// have a place of its own at most d away [m]. 0 without starts; -1 where there are fewer places than starts.
double bottleneckWalk(std::span<const Vec2> starts, std::span<const Vec2> places);

}  // namespace muster
