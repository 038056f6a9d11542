#include "muster/obstacle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "environment/nearest_surface.h"

namespace muster {
namespace {

struct ConvexNearest {
    double squared = std::numeric_limits<double>::infinity();
    Vec2 point;
    bool inside = true;
};

// One pass over a convex, counter-clockwise polygon: the nearest boundary point and the side.
ConvexNearest nearestOf(const Polygon& corners, Vec2 p) {
    ConvexNearest best;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 a = corners[j], b = corners[i];
        const Vec2 along = b - a;
        if (cross(along, p - a) < 0.0) best.inside = false;
        // closestOnSegment() of a side, without a call.
        const double whole = lengthSquared(along), part = dot(p - a, along);
        const Vec2 candidate = part <= 0.0 || whole <= 0.0 ? a
                               : part >= whole             ? b
                                                           : a + along * (part / whole);
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
    const ConvexNearest best = nearestOf(corners, p);
    const double d = std::sqrt(best.squared);
    return best.inside ? -d : d;
}

Vec2 ObstaclePiece::closestSurface(Vec2 p) const {
    if (corners.empty()) return centre + normalized(p - centre, {1.0, 0.0}) * radius;
    return nearestOf(corners, p).point;
}

NearestSurface nearestSurface(const ObstaclePiece& piece, Vec2 p) {
    if (piece.corners.empty()) return {piece.signedDistance(p), piece.closestSurface(p)};
    const ConvexNearest best = nearestOf(piece.corners, p);
    const double d = std::sqrt(best.squared);
    return {best.inside ? -d : d, best.point};
}

double ObstaclePiece::segmentDistance(Vec2 a, Vec2 b) const {
    if (corners.empty()) return std::max(0.0, distance(closestOnSegment(a, b, centre), centre) - radius);
    return muster::segmentDistance(corners, a, b);
}

}  // namespace muster
