// Points sorted into square cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/base/grid.h"

namespace muster {

/// Points by the cell they lie in, each cell's in ascending order. Reuses its memory: for the same number of points
/// it allocates nothing once warm, wherever they are.
class CellList {
public:
    /// Sorts points into cells of edge `least` [m] > 0, or larger where there would be many more cells than points.
    void sort(std::span<const Vec2> points, double least);

    const Grid& grid() const { return grid_; }  ///< Covers the points; no cells where there are none.
    /// The cell of a point.
    std::int32_t cellOf(std::size_t point) const { return cellOf_[point]; }
    /// All points, cell by cell.
    std::span<const std::int32_t> items() const { return item_; }
    /// Where a cell's points begin among items(); cell grid().count() is the end.
    std::int32_t begin(std::int32_t cell) const { return start_[static_cast<std::size_t>(cell)]; }
    /// Points in the cells from `first` to `last`, both included, of one row or of the whole grid.
    std::span<const std::int32_t> within(std::int32_t first, std::int32_t last) const {
        const auto begin = static_cast<std::size_t>(start_[static_cast<std::size_t>(first)]);
        const auto end = static_cast<std::size_t>(start_[static_cast<std::size_t>(last) + 1]);
        return {item_.data() + begin, end - begin};
    }

private:
    Grid grid_;
    std::vector<std::int32_t> start_;   // Of each cell in item_, and the end.
    std::vector<std::int32_t> item_;    // Points, cell by cell.
    std::vector<std::int32_t> cellOf_;  // Of each point.
};

}  // namespace muster
