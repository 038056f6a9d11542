// The k nearest of some points, by rings of cells around a centre.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/cell_list.h"

namespace muster {

/// The result of a search for nearest points, nearest first. Points of equal distance are ordered by index;
/// where not all of these fit, the ones met first are in. A search visits at most kVisited points, so in an
/// extremely dense crowd some nearest points may be missed.
class NearestPoints {
public:
    static constexpr std::int32_t kCapacity = 16;  ///< Points that a search can find.

    /// Edge of cells that hold about one and a half points each [m].
    static double cellEdge(std::span<const Vec2> points) {
        if (points.empty()) return 1.0;
        Box box{points[0], points[0]};
        for (const Vec2 p : points) {
            box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
            box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
        }
        const double area = std::max(box.width(), 0.1) * std::max(box.height(), 0.1);
        return std::max(0.1, std::sqrt(1.5 * area / static_cast<double>(points.size())));
    }
    /// Finds the `count` (at most kCapacity) points nearest to `centre` [m] that `accept(point)`.
    template <class Accept>
    void find(const CellList& cells, std::span<const Vec2> points, Vec2 centre, std::int32_t count,
              Accept accept);

    std::int32_t size() const { return size_; }                          ///< Points found.
    std::int32_t operator[](std::int32_t k) const { return point_[k]; }  ///< Index of the k-th nearest point.

private:
    static constexpr std::int32_t kVisited = 192;

    void insert(std::int32_t point, double distanceSquared, std::int32_t count) {
        if (size_ == count && !(distanceSquared < distance_[size_ - 1])) return;
        std::int32_t k = size_ < count ? size_++ : size_ - 1;
        for (; k > 0 && (distance_[k - 1] > distanceSquared ||
                         (distance_[k - 1] == distanceSquared && point_[k - 1] > point));
             --k) {
            distance_[k] = distance_[k - 1];
            point_[k] = point_[k - 1];
        }
        distance_[k] = distanceSquared;
        point_[k] = point;
    }

    std::int32_t size_ = 0;
    std::array<double, kCapacity> distance_{};  // Squared distances [m^2].
    std::array<std::int32_t, kCapacity> point_{};
};

template <class Accept>
void NearestPoints::find(const CellList& cells, std::span<const Vec2> points, Vec2 centre, std::int32_t count,
                         Accept accept) {
    size_ = 0;
    const Grid& grid = cells.grid();
    if (points.empty() || count <= 0) return;
    const Cell middle = grid.nearestCell(centre);
    const std::int32_t rings = std::max(grid.width, grid.height);
    std::int32_t visited = 0;
    const auto visitCells = [&](std::int32_t x0, std::int32_t x1, std::int32_t y) {
        x0 = std::max(x0, 0);
        x1 = std::min(x1, grid.width - 1);
        if (y < 0 || y >= grid.height || x0 > x1) return;
        for (const std::int32_t p : cells.within(grid.index({x0, y}), grid.index({x1, y}))) {
            if (++visited > kVisited) return;
            if (accept(p)) insert(p, lengthSquared(points[p] - centre), count);
        }
    };
    for (std::int32_t r = 0; r <= rings && visited <= kVisited; ++r) {
        // Points in this and farther rings are at least this far away.
        const double reach = (r - 1) * grid.cell;
        if (size_ == count && r > 1 && distance_[count - 1] <= reach * reach) break;
        visitCells(middle.x - r, middle.x + r, middle.y - r);
        for (std::int32_t y = middle.y - r + 1; y < middle.y + r; ++y) {
            visitCells(middle.x - r, middle.x - r, y);
            if (r > 0) visitCells(middle.x + r, middle.x + r, y);
        }
        if (r > 0) visitCells(middle.x - r, middle.x + r, middle.y + r);
    }
}

}  // namespace muster
