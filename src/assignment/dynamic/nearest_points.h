// The few points nearest to a spot.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/cell_list.h"

namespace muster {

/// The nearest of some sorted points, nearest first; of equal distance the lower number first, though of
/// several equally far ones that do not all fit those are kept that were met first. Looks at so many points
/// only, so where points are crowded beyond measure some nearest may be missed.
class NearestPoints {
public:
    static constexpr std::int32_t kMost = 16;  ///< Can be asked for.

    /// Looks for `count` (at most kMost) points around `centre` for which `keep(point)`.
    template <class Keep>
    void find(const CellList& cells, std::span<const Vec2> points, Vec2 centre, std::int32_t count,
              Keep keep);

    std::int32_t size() const { return size_; }                          ///< Found.
    std::int32_t operator[](std::int32_t k) const { return point_[k]; }  ///< The k-th nearest.

private:
    static constexpr std::int32_t kLookedAt = 192;

    void insert(std::int32_t point, double distanceSquared, std::int32_t count) {
        if (size_ == count && !(distanceSquared < distance_[size_ - 1])) return;
        auto k = static_cast<std::size_t>(size_ < count ? size_++ : size_ - 1);
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
    std::array<double, kMost> distance_{};
    std::array<std::int32_t, kMost> point_{};
};

template <class Keep>
void NearestPoints::find(const CellList& cells, std::span<const Vec2> points, Vec2 centre, std::int32_t count,
                         Keep keep) {
    size_ = 0;
    const Grid& grid = cells.grid();
    if (points.empty() || count <= 0) return;
    const Cell middle = grid.nearestCell(centre);
    const std::int32_t rings = std::max(grid.width, grid.height);
    std::int32_t looked = 0;
    const auto look = [&](std::int32_t x0, std::int32_t x1, std::int32_t y) {
        x0 = std::max(x0, 0);
        x1 = std::min(x1, grid.width - 1);
        if (y < 0 || y >= grid.height || x0 > x1) return;
        for (const std::int32_t p : cells.within(grid.index({x0, y}), grid.index({x1, y}))) {
            if (++looked > kLookedAt) return;
            if (keep(p)) insert(p, lengthSquared(points[p] - centre), count);
        }
    };
    for (std::int32_t r = 0; r <= rings && looked <= kLookedAt; ++r) {
        // Whatever lies in farther rings is at least so far away.
        const double reach = (r - 1) * grid.cell;
        if (size_ == count && r > 1 && distance_[count - 1] <= reach * reach) break;
        look(middle.x - r, middle.x + r, middle.y - r);
        for (std::int32_t y = middle.y - r + 1; y < middle.y + r; ++y) {
            look(middle.x - r, middle.x - r, y);
            if (r > 0) look(middle.x + r, middle.x + r, y);
        }
        if (r > 0) look(middle.x - r, middle.x + r, middle.y + r);
    }
}

}  // namespace muster
