// Validation of polygons from the user.
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/geometry/polygon.h"

namespace muster {
namespace {

constexpr double kSameCorner = 1e-9;  // Distance below which two corners count as one [m].
constexpr double kLeastArea = 1e-9;   // Least area of a polygon [m^2].

// Drops corners that repeat the one before. `from` receives the original index of each corner left.
void dropRepeats(std::span<const Vec2> polygon, Polygon& corners, std::vector<std::size_t>& from) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (!corners.empty() && distance(corners.back(), polygon[i]) <= kSameCorner) continue;
        corners.push_back(polygon[i]);
        from.push_back(i);
    }
    while (corners.size() > 1 && distance(corners.back(), corners.front()) <= kSameCorner) {
        corners.pop_back();
        from.pop_back();
    }
}

// True where the edges that start at corners i < j share more than a common corner.
bool edgesMeet(const Polygon& p, std::size_t i, std::size_t j) {
    const std::size_t count = p.size();
    const Vec2 a = p[i], b = p[(i + 1) % count], c = p[j], d = p[(j + 1) % count];
    if (j == i + 1) return orientation(a, b, d) == 0 && dot(a - b, d - b) > 0.0;
    if ((j + 1) % count == i) return orientation(c, a, b) == 0 && dot(c - a, b - a) > 0.0;
    return segmentsCross(a, b, c, d);
}

Status checkCrossings(const Polygon& p, const std::vector<std::size_t>& from) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = i + 1; j < p.size(); ++j) {
            if (!edgesMeet(p, i, j)) continue;
            return invalidArgument("edges " + std::to_string(from[i]) + " and " + std::to_string(from[j]) +
                                   " of the polygon cross or touch");
        }
    }
    return {};
}

}  // namespace

Result<Polygon> cleanPolygon(std::span<const Vec2> polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        // Beyond 1e7 m a double cannot tell corners a few nanometres apart.
        if (!isFinite(polygon[i]) || std::fabs(polygon[i].x) > 1e7 || std::fabs(polygon[i].y) > 1e7) {
            return invalidArgument("corner " + std::to_string(i) +
                                   " of the polygon is not a finite position within 10,000 km");
        }
    }
    Polygon corners;
    std::vector<std::size_t> from;
    dropRepeats(polygon, corners, from);
    if (corners.size() < 3) {
        return invalidArgument("a polygon needs three distinct corners, found " +
                               std::to_string(corners.size()));
    }
    if (corners.size() > 10000) {
        return invalidArgument("a polygon may have 10,000 corners, found " + std::to_string(corners.size()));
    }
    if (Status status = checkCrossings(corners, from); !status.ok()) return status;
    const double area = signedArea(corners);
    if (std::fabs(area) < kLeastArea)
        return invalidArgument("the polygon's area is under 1e-9 square metres");
    // The first corner stays the first.
    if (area < 0.0) std::reverse(corners.begin() + 1, corners.end());
    return corners;
}

}  // namespace muster
