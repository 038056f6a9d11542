#include "geometry/mesh_locator.h"

#include <algorithm>
#include <array>

#include "geometry/triangulation.h"

namespace muster {

MeshLocator::MeshLocator(const std::vector<Triangle>& triangles, const std::vector<Vec2>& vertices)
    : triangles_(triangles), vertices_(vertices), inCell_(static_cast<std::size_t>(kCells) * kCells) {
    if (vertices.empty()) return;
    const Box box = boundsOf(vertices);
    low_ = box.min;
    size_ = box.max - box.min;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& triangle = triangles[t];
        const std::array<Vec2, 3> corner{vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
        // A little more on each side, so that rounding cannot lose a triangle.
        const Box bounds = boundsOf(corner);
        const double margin = 1e-9 * (size_.x + size_.y);
        const std::int32_t left = cellOf(bounds.min.x - margin, low_.x, size_.x),
                           right = cellOf(bounds.max.x + margin, low_.x, size_.x),
                           bottom = cellOf(bounds.min.y - margin, low_.y, size_.y),
                           top = cellOf(bounds.max.y + margin, low_.y, size_.y);
        for (std::int32_t j = bottom; j <= top; ++j)
            for (std::int32_t i = left; i <= right; ++i)
                inCell_[static_cast<std::size_t>(j) * kCells + i].push_back(static_cast<std::int32_t>(t));
    }
}

std::int32_t MeshLocator::cellOf(double along, double low, double size) const {
    if (!(size > 0.0)) return 0;
    return static_cast<std::int32_t>(std::clamp((along - low) / size * kCells, 0.0, kCells - 1.0));
}

MeshPoint MeshLocator::locate(Vec2 p) const {
    const std::int32_t i = cellOf(p.x, low_.x, size_.x), j = cellOf(p.y, low_.y, size_.y);
    for (const std::int32_t t : inCell_[static_cast<std::size_t>(j) * kCells + i]) {
        const Triangle& triangle = triangles_[t];
        const Vec2 a = vertices_[triangle[0]], b = vertices_[triangle[1]], c = vertices_[triangle[2]];
        const std::array<double, 3> weight = barycentric(a, b, c, p);
        if (weight[0] >= 0.0 && weight[1] >= 0.0 && weight[2] >= 0.0 && cross(b - a, c - a) != 0.0)
            return {t, weight};
    }
    return muster::locate(triangles_, vertices_, p);
}

}  // namespace muster
