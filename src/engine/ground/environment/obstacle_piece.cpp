#include "engine/ground/environment/obstacle_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

struct BoundaryPoint {
    double squared = std::numeric_limits<double>::infinity();
    Vec2 point;
    bool inside = true;
};

// The nearest boundary point of a convex, counter-clockwise polygon, and whether `p` lies inside.
BoundaryPoint nearestOnBoundary(const Polygon& corners, Vec2 p) {
    BoundaryPoint best;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 a = corners[j], b = corners[i];
        const Vec2 along = b - a;
        if (cross(along, p - a) < 0.0) best.inside = false;
        // closestOnSegment() of this side, inlined for speed.
        const double sideSquared = lengthSquared(along), projection = dot(p - a, along);
        const Vec2 candidate = projection <= 0.0 || sideSquared <= 0.0 ? a
                               : projection >= sideSquared             ? b
                                                           : a + along * (projection / sideSquared);
        const double squared = lengthSquared(candidate - p);
        if (squared >= best.squared) continue;
        best.squared = squared;
        best.point = candidate;
    }
    return best;
}

}  // namespace

double ObstaclePiece::signedDistance(Vec2 p) const {
    if (corners.empty()) return distance(p, centre) - radius;
    const BoundaryPoint best = nearestOnBoundary(corners, p);
    const double d = std::sqrt(best.squared);
    return best.inside ? -d : d;
}

Vec2 ObstaclePiece::closestSurface(Vec2 p) const {
    if (corners.empty()) return centre + normalized(p - centre, {1.0, 0.0}) * radius;
    return nearestOnBoundary(corners, p).point;
}

SurfacePoint closestSurfacePoint(const ObstaclePiece& piece, Vec2 p) {
    if (piece.corners.empty()) return {piece.signedDistance(p), piece.closestSurface(p)};
    const BoundaryPoint best = nearestOnBoundary(piece.corners, p);
    const double d = std::sqrt(best.squared);
    return {best.inside ? -d : d, best.point};
}

double ObstaclePiece::segmentDistance(Vec2 a, Vec2 b) const {
    if (corners.empty()) return std::max(0.0, distance(closestOnSegment(a, b, centre), centre) - radius);
    return muster::segmentDistance(corners, a, b);
}

}  // namespace muster
