// The area of a box that convex obstacles leave free: the complement of a union of convex polygons.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/polygon.h"

namespace muster {

/// The parts of the box that lie in none of the convex polygons, whose corners run counter-clockwise. Parts
/// that only touch in a point are parts of their own. Each outline and each hole begins at its leftmost
/// corner, of these the lowest; parts and holes are ordered by that corner. Corners within 1e-7 m of each
/// other become one. The cost grows with the square of the number of polygons at most.
std::vector<PolygonWithHoles> freeArea(const Box& box, std::span<const Polygon> convex);

}  // namespace muster
