#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

// Calls `visit(a, b)` for every edge.
template <class Visit>
void forEdges(std::span<const Vec2> polygon, const Visit& visit) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0, j = count - 1; i < count; j = i++) visit(polygon[j], polygon[i]);
}

// Even-odd rule; a point on the boundary may count as inside or outside.
bool crossesOddly(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    forEdges(polygon, [&](Vec2 a, Vec2 b) {
        if ((a.y > p.y) == (b.y > p.y)) return;
        const double side = cross(b - a, p - a);
        if ((side > 0.0) == (b.y > a.y)) inside = !inside;
    });
    return inside;
}

}  // namespace

double signedArea(std::span<const Vec2> polygon) {
    if (polygon.size() < 3) return 0.0;
    // Summed relative to the first corner, so that polygons far from the origin lose no digits.
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    }
    return 0.5 * twice;
}

Vec2 centroid(std::span<const Vec2> polygon) {
    if (polygon.empty()) return {};
    const Vec2 base = polygon[0];
    double weight = 0.0;
    Vec2 sum, mean;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        mean += polygon[i] - base;
        if (i == 0 || i + 1 == polygon.size()) continue;
        const Vec2 u = polygon[i] - base;
        const Vec2 v = polygon[i + 1] - base;
        weight += cross(u, v);
        sum += cross(u, v) * (u + v);
    }
    const Box box = boundsOf(polygon);
    const double size = box.width() + box.height();
    if (std::fabs(weight) <= 1e-14 * size * size) return base + mean / static_cast<double>(polygon.size());
    return base + sum / (3.0 * weight);
}

bool isConvex(std::span<const Vec2> polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (orientation(polygon[i], polygon[(i + 1) % count], polygon[(i + 2) % count]) < 0) return false;
    }
    return true;
}

bool containsPoint(std::span<const Vec2> polygon, Vec2 p) {
    if (polygon.empty()) return false;
    if (crossesOddly(polygon, p)) return true;
    const Box box = boundsOf(polygon);
    const double tolerance = 1e-12 * std::max(box.width(), box.height());
    if (!box.grown(tolerance).contains(p)) return false;
    return closestOnBoundary(polygon, p).distance <= tolerance;
}

bool containsPoint(const PolygonWithHoles& shape, Vec2 p) {
    if (!containsPoint(std::span(shape.outline), p)) return false;
    return std::none_of(shape.holes.begin(), shape.holes.end(),
                        [&](const Polygon& hole) { return containsPoint(std::span(hole), p); });
}

Vec2 closestOnSegment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 along = b - a;
    const double squared = lengthSquared(along);
    if (squared <= 0.0) return a;
    const double t = dot(p - a, along) / squared;
    if (t <= 0.0) return a;
    if (t >= 1.0) return b;
    return a + along * t;
}

ClosestPoint closestOnBoundary(std::span<const Vec2> polygon, Vec2 p) {
    MUSTER_ASSERT(!polygon.empty());
    Vec2 best = polygon[0];
    double bestSquared = std::numeric_limits<double>::infinity();
    forEdges(polygon, [&](Vec2 a, Vec2 b) {
        const Vec2 candidate = closestOnSegment(a, b, p);
        const double squared = lengthSquared(candidate - p);
        if (squared < bestSquared) {
            bestSquared = squared;
            best = candidate;
        }
    });
    return {best, std::sqrt(bestSquared)};
}

double signedDistance(std::span<const Vec2> polygon, Vec2 p) {
    const double d = closestOnBoundary(polygon, p).distance;
    return crossesOddly(polygon, p) ? -d : d;
}

double segmentDistance(std::span<const Vec2> polygon, Vec2 a, Vec2 b) {
    if (crossesOddly(polygon, a) || crossesOddly(polygon, b)) return 0.0;
    double nearest = std::numeric_limits<double>::infinity();
    forEdges(polygon, [&](Vec2 c, Vec2 d) { nearest = std::min(nearest, segmentDistance(a, b, c, d)); });
    return nearest;
}

double segmentDistance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (segmentsCross(a, b, c, d)) return 0.0;
    return std::sqrt(std::min(
        std::min(lengthSquared(closestOnSegment(a, b, c) - c), lengthSquared(closestOnSegment(a, b, d) - d)),
        std::min(lengthSquared(closestOnSegment(c, d, a) - a),
                 lengthSquared(closestOnSegment(c, d, b) - b))));
}

bool segmentsCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
        return false;
    }
    // The bounding boxes meet. The segments meet where neither lies on one side of the other's line.
    if (orientation(a, b, c) * orientation(a, b, d) > 0) return false;
    return orientation(c, d, a) * orientation(c, d, b) <= 0;
}

Polygon convexHull(std::span<const Vec2> points) {
    Polygon sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    Polygon hull;
    const auto add = [&hull](std::size_t floor, Vec2 p) {
        while (hull.size() >= floor + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) {
            hull.pop_back();
        }
        hull.push_back(p);
    };
    for (Vec2 p : sorted) add(0, p);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = sorted.size() - 1; i-- > 0;) add(lower, sorted[i]);
    hull.pop_back();
    return hull;
}

}  // namespace muster
