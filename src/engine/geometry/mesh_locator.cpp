#include "engine/geometry/mesh_locator.h"

#include <algorithm>
#include <array>

#include "engine/geometry/triangulation.h"

namespace muster {

MeshLocator::MeshLocator(const std::vector<Triangle>& triangles, const std::vector<Vec2>& vertices)
    : triangles_(triangles), vertices_(vertices), cellEnd_(static_cast<std::size_t>(kCells) * kCells, 0) {
    if (vertices.empty()) return;
    const Box box = boundsOf(vertices);
    low_ = box.min;
    size_ = box.max - box.min;
    std::vector<Cells> cells;
    cells.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        cells.push_back(cellsOf(triangle));
        forCells(cells.back(), [&](std::size_t cell) { ++cellEnd_[cell]; });
    }
    std::int32_t sum = 0;
    for (std::int32_t& end : cellEnd_) {
        const std::int32_t count = end;
        end = sum;
        sum += count;
    }
    inCell_.resize(static_cast<std::size_t>(sum));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        forCells(cells[t],
                 [&](std::size_t cell) { inCell_[cellEnd_[cell]++] = static_cast<std::int32_t>(t); });
}

std::int32_t MeshLocator::cellOf(double along, double low, double size) {
    if (!(size > 0.0)) return 0;
    return static_cast<std::int32_t>(std::clamp((along - low) / size * kCells, 0.0, kCells - 1.0));
}

// Cells are enlarged slightly on each side, so that rounding cannot lose a triangle.
MeshLocator::Cells MeshLocator::cellsOf(const Triangle& triangle) const {
    const std::array<Vec2, 3> corner{vertices_[triangle[0]], vertices_[triangle[1]], vertices_[triangle[2]]};
    const Box bounds = boundsOf(corner);
    const double margin = 1e-9 * (size_.x + size_.y);
    return {cellOf(bounds.min.x - margin, low_.x, size_.x), cellOf(bounds.max.x + margin, low_.x, size_.x),
            cellOf(bounds.min.y - margin, low_.y, size_.y), cellOf(bounds.max.y + margin, low_.y, size_.y)};
}

MeshPoint MeshLocator::locate(Vec2 p) const {
    const std::int32_t i = cellOf(p.x, low_.x, size_.x), j = cellOf(p.y, low_.y, size_.y);
    const std::size_t cell = static_cast<std::size_t>(j) * kCells + i;
    for (std::int32_t k = cell == 0 ? 0 : cellEnd_[cell - 1]; k < cellEnd_[cell]; ++k) {
        const Triangle& triangle = triangles_[inCell_[k]];
        std::array<double, 3> weight;
        if (holds({vertices_[triangle[0]], vertices_[triangle[1]], vertices_[triangle[2]]}, p, weight))
            return {inCell_[k], weight};
    }
    return muster::locate(triangles_, vertices_, p);
}

}  // namespace muster
