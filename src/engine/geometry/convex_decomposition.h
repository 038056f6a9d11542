// Convex decomposition of concave polygons (Hertel and Mehlhorn 1983).
#pragma once

#include <vector>

#include "engine/geometry/polygon.h"

namespace muster {

/// Cuts a simple polygon into few convex parts that cover it exactly and do not overlap, by ear clipping and
/// merging of triangles across shared diagonals. A convex polygon is returned as one part. Fails where
/// cleanPolygon() fails.
Result<std::vector<Polygon>> decomposeConvex(std::span<const Vec2> polygon);

}  // namespace muster
