// Rectangles of grid cells.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/grid.h"

namespace muster {

/// The cells from `low` to `high`, both included; none where `high` lies below or left of `low`.
struct CellRect {
    Cell low{0, 0};     ///< Lower left cell.
    Cell high{-1, -1};  ///< Upper right cell.

    /// True where it contains no cell.
    bool empty() const { return high.x < low.x || high.y < low.y; }
    /// The intersection of two rectangles.
    CellRect common(const CellRect& other) const {
        return {{std::max(low.x, other.low.x), std::max(low.y, other.low.y)},
                {std::min(high.x, other.high.x), std::min(high.y, other.high.y)}};
    }
    /// The cells of `grid` that `box` touches.
    static CellRect touching(const Grid& grid, const Box& box) {
        const Cell low = grid.cellOf(box.min), high = grid.cellOf(box.max);
        return CellRect{low, high}.common({{0, 0}, {grid.width - 1, grid.height - 1}});
    }
};

}  // namespace muster
