// Queries of polygons in the ground plane: exact signs of determinants, and mean-value coordinates (Floater
// 2003; Hormann and Floater 2006).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "muster/geometry.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// The point of a boundary that is nearest to a query point.
struct ClosestPoint {
    Vec2 point;             ///< Nearest point on the boundary [m].
    double distance = 0.0;  ///< Distance from the query point [m], >= 0.
};

/// Area [m^2], positive where the corners run counter-clockwise.
double signedArea(std::span<const Vec2> polygon);
/// Centre of area; the mean of the corners where the area vanishes.
Vec2 centroid(std::span<const Vec2> polygon);
/// True where no corner turns right (collinear corners allowed); expects counter-clockwise order.
bool isConvex(std::span<const Vec2> polygon);
/// True where `p` lies inside or on the boundary (within 1e-12 of its size).
bool containsPoint(std::span<const Vec2> polygon, Vec2 p);
/// True where `p` lies inside the outline and in no hole.
bool containsPoint(const PolygonWithHoles& shape, Vec2 p);
/// The nearest point of the segment from `a` to `b`.
Vec2 closestOnSegment(Vec2 a, Vec2 b, Vec2 p);
/// The nearest point of the boundary.
ClosestPoint closestOnBoundary(std::span<const Vec2> polygon, Vec2 p);
/// Distance to the boundary [m], negative inside.
double signedDistance(std::span<const Vec2> polygon, Vec2 p);
/// Smallest distance between a segment and a polygon's area [m]; 0 where they meet.
double segmentDistance(std::span<const Vec2> polygon, Vec2 a, Vec2 b);
/// Smallest distance between two segments [m]; 0 where they cross.
double segmentDistance(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// True where the closed segments share a point.
bool segmentsCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// The convex hull, counter-clockwise, without collinear corners (Andrew's monotone chain).
Polygon convexHull(std::span<const Vec2> points);
/// A polygon of the user in normal form: without repeated corners, counter-clockwise. Fails with
/// InvalidArgument, naming edges or corners, where fewer than three distinct corners remain, the area is
/// under 1e-9 m^2, a coordinate is not finite, or edges cross.
Result<Polygon> cleanPolygon(std::span<const Vec2> polygon);

/// 1 where a, b, c turn left, -1 where they turn right, 0 where they lie exactly on one line.
int orientation(Vec2 a, Vec2 b, Vec2 c);

/// 1 where `d` lies inside the circle through the left-turning a, b, c, -1 outside, 0 exactly on it.
int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Writes to `weights` (one per corner, sum 1) the mean-value coordinates of `p` in the polygon:
/// sum of weights times corners gives `p`. Exact on corners and edges. At least three corners.
void meanValueCoordinates(std::span<const Vec2> polygon, Vec2 p, std::span<double> weights);

}  // namespace muster
