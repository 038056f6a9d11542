#include <algorithm>
#include <string>

#include "engine/geometry/bowyer_watson.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/triangulation.h"

namespace muster {
namespace {

// The first three points that span a triangle, or nothing.
std::optional<std::array<std::int32_t, 3>> spanningTriple(std::span<const Vec2> points) {
    const auto count = static_cast<std::int32_t>(points.size());
    std::int32_t second = 1;
    while (second < count && points[second] == points[0]) ++second;
    for (std::int32_t third = second + 1; third < count; ++third) {
        if (orientation(points[0], points[second], points[third]) != 0) return {{0, second, third}};
    }
    return {};
}

}  // namespace

Result<std::vector<Triangle>> delaunay(std::span<const Vec2> points) {
    if (points.size() < 3) {
        return invalidArgument("a triangulation needs three points, found " + std::to_string(points.size()));
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) return invalidArgument("point " + std::to_string(i) + " is not finite");
    }
    const auto first = spanningTriple(points);
    if (!first) return invalidArgument("all points to triangulate lie on one line");
    BowyerWatson mesh({points.begin(), points.end()}, *first);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!mesh.insert(static_cast<std::int32_t>(i))) {
            return invalidArgument("point " + std::to_string(i) + " repeats an earlier point");
        }
    }
    std::vector<Triangle> triangles;
    for (const BowyerWatson::Face& face : mesh.faces()) {
        if (!face.alive || BowyerWatson::isGhost(face)) continue;
        Triangle triangle = face.vertex;
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace muster
