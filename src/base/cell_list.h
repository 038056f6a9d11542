// Cell list (Hockney and Eastwood 1981): points sorted by grid cell.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Points sorted by the square cell that contains them, within a cell in ascending order of index. The memory
/// is reused: for the same number of points, wherever they are, sort() does not allocate once warm.
class CellList {
public:
    /// Sorts points into cells of edge `minEdge` [m], > 0, or larger ones where there would be many more
    /// cells than points.
    void sort(std::span<const Vec2> points, double minEdge);

    /// The grid that covers the points; without cells where there are none.
    const Grid& grid() const { return grid_; }
    /// Index of the cell of a point.
    std::int32_t cellOf(std::size_t point) const { return cellOf_[point]; }
    /// Calls `visit(i, j)`, i < j, once for every pair of points nearer to each other than `reach` [m], in a
    /// fixed order. `reach` is at most the `minEdge` of sort().
    template <class Visit>
    void forPairs(double reach, const Visit& visit) const {
        Found found;
        for (std::int32_t y = 0; y < grid_.height; ++y) forPairsOfRow(y, reach * reach, found, visit);
        visitFound(found, visit);
    }
    /// Indices of the points in the cells from `first` to `last`, both included, in row-major order.
    std::span<const std::int32_t> within(std::int32_t first, std::int32_t last) const {
        return std::span(item_).subspan(start_[first], start_[last + 1] - start_[first]);
    }
    /// True where `accept(i)` holds for a point in the cell that is nearest to `p`, or in one beside it.
    template <class Accept>
    bool anyBeside(Vec2 p, const Accept& accept) const {
        const Cell at = grid_.nearestCell(p);
        const std::int32_t left = std::max(at.x - 1, 0), right = std::min(at.x + 1, grid_.width - 1);
        for (std::int32_t y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, grid_.height - 1); ++y)
            for (const std::int32_t i : within(grid_.index({left, y}), grid_.index({right, y})))
                if (accept(i)) return true;
        return false;
    }

private:
    std::int32_t begin(std::int32_t cell) const { return start_[cell]; }

    // Pairs of positions in item_ that were found and not visited yet.
    struct Found {
        static constexpr std::int32_t kRoom = 256, kAtOnce = 64;
        struct Pair {
            std::int32_t u, v;
        };
        Pair pair[kRoom];
        std::int32_t count = 0;
    };

    // Finds the pairs of each point of a row with the points after it in the order of cells: the rest of its
    // cell and the cell to the right, which are contiguous in memory, and three cells of the row above, which
    // are so too.
    template <class Visit>
    void forPairsOfRow(std::int32_t y, double reach2, Found& found, const Visit& visit) const {
        const std::int32_t first = grid_.index({0, y}), last = first + grid_.width - 1;
        const bool top = y + 1 == grid_.height;
        // Iterates over points instead of cells, most of which may be empty.
        for (std::int32_t u = begin(first), end = begin(last + 1); u < end; ++u) {
            const std::int32_t cell = cellOf_[item_[u]];
            const std::int32_t left = cell > first ? cell - 1 : cell;
            const std::int32_t right = cell < last ? cell + 1 : cell;
            find(u, u + 1, begin(right + 1), reach2, found, visit);
            if (!top)
                find(u, begin(left + grid_.width), begin(right + grid_.width + 1), reach2, found, visit);
        }
    }

    // Finds the points of a range that are near a point. The outcome is as good as random, so there is no
    // branch.
    template <class Visit>
    void find(std::int32_t u, std::int32_t from, std::int32_t to, double reach2, Found& found,
              const Visit& visit) const {
        const Vec2 p = sorted_[u];
        while (from < to) {
            const std::int32_t end = std::min(to, from + Found::kAtOnce);
            std::int32_t count = found.count;
            for (; from < end; ++from) {
                found.pair[count] = {u, from};
                count += lengthSquared(sorted_[from] - p) < reach2 ? 1 : 0;
            }
            found.count = count;
            if (count > Found::kRoom - Found::kAtOnce) visitFound(found, visit);
        }
    }

    template <class Visit>
    void visitFound(Found& found, const Visit& visit) const {
        for (std::int32_t k = 0; k < found.count; ++k) {
            const std::int32_t i = item_[found.pair[k].u], j = item_[found.pair[k].v];
            visit(std::min(i, j), std::max(i, j));
        }
        found.count = 0;
    }

    Grid grid_;
    std::vector<Vec2> sorted_;          // Positions, cell by cell [m].
    std::vector<std::int32_t> start_;   // Per cell: its first position in item_; then the end.
    std::vector<std::int32_t> item_;    // Indices of points, cell by cell.
    std::vector<std::int32_t> cellOf_;  // Per point: its cell.
};

}  // namespace muster
