// Points sorted into square cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Points by the cell they lie in, each cell's in ascending order. Reuses its memory: for the same number of
/// points it allocates nothing once warm, wherever they are.
class CellList {
public:
    /// Sorts points into cells of edge `least` [m] > 0, or larger where there would be many more cells than
    /// points.
    void sort(std::span<const Vec2> points, double least);

    const Grid& grid() const { return grid_; }  ///< Covers the points; no cells where there are none.
    /// The cell of a point.
    std::int32_t cellOf(std::size_t point) const { return cellOf_[point]; }
    /// Calls `visit(i, j)`, i < j, once for every pair of points nearer than `reach`, at most the edge that
    /// sort() was given [m], in a fixed order.
    template <class Visit>
    void forPairs(double reach, const Visit& visit) const {
        for (std::int32_t y = 0; y < grid_.height; ++y) forPairsOfRow(y, reach * reach, visit);
    }
    /// Points in the cells from `first` to `last`, both included, of one row or of the whole grid.
    std::span<const std::int32_t> within(std::int32_t first, std::int32_t last) const {
        const auto begin = static_cast<std::size_t>(start_[first]);
        const auto end = static_cast<std::size_t>(start_[static_cast<std::size_t>(last) + 1]);
        return {item_.data() + begin, end - begin};
    }

private:
    std::int32_t begin(std::int32_t cell) const { return start_[cell]; }

    // Of each point's neighbours those that lie behind it in the order of cells: the rest of its cell and the
    // one to the right, which follow each other in memory, and three cells of the row above, which do so too.
    template <class Visit>
    void forPairsOfRow(std::int32_t y, double reach2, const Visit& visit) const {
        const auto test = [&](std::int32_t u, std::int32_t from, std::int32_t to) {
            const Vec2 p = sorted_[u];
            for (auto v = static_cast<std::size_t>(from); v < static_cast<std::size_t>(to); ++v) {
                if (!(lengthSquared(sorted_[v] - p) < reach2)) continue;
                const std::int32_t i = item_[u], j = item_[v];
                visit(i < j ? i : j, i < j ? j : i);
            }
        };
        const std::int32_t first = grid_.index({0, y}), last = first + grid_.width - 1;
        const bool top = y + 1 == grid_.height;
        // By points, not by cells: most cells may be empty.
        for (std::int32_t u = begin(first), end = begin(last + 1); u < end; ++u) {
            const std::int32_t cell = cellOf_[item_[u]];
            const std::int32_t left = cell > first ? cell - 1 : cell;
            const std::int32_t right = cell < last ? cell + 1 : cell;
            test(u, u + 1, begin(right + 1));
            if (!top) test(u, begin(left + grid_.width), begin(right + grid_.width + 1));
        }
    }

    Grid grid_;
    std::vector<Vec2> sorted_;          // Points, cell by cell.
    std::vector<std::int32_t> start_;   // Of each cell in item_, and the end.
    std::vector<std::int32_t> item_;    // Points, cell by cell.
    std::vector<std::int32_t> cellOf_;  // Of each point.
};

}  // namespace muster
