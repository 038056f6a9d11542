// The least total walk from starts to places, for the path ratio of reports.
#pragma once

#include <span>

#include "engine/ground/environment/environment.h"

namespace muster {

/// Least sum of geodesic lengths that takes every start to a place of its own [m], round obstacles and
/// regardless of patches; -1 where somebody cannot get there.
double leastWalk(const Environment& environment, double radius, std::span<const Vec2> starts,
                 std::span<const Vec2> places);

}  // namespace muster
