// Concave polygons into convex parts.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace muster {

/// Cuts a simple polygon into few convex parts that cover it exactly and do not overlap
/// (ear clipping, then merging of triangles across shared diagonals: Hertel and Mehlhorn 1983).
/// A convex polygon comes back as it is. Fails as cleanPolygon does.
Result<std::vector<Polygon>> decomposeConvex(std::span<const Vec2> polygon);

}  // namespace muster
