// Rectangles of grid cells.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/grid.h"

namespace muster {

/// Cells from `low` to `high`, both included; empty where high lies below low.
struct CellRect {
    Cell low{0, 0};     ///< Lower left.
    Cell high{-1, -1};  ///< Upper right.

    /// True where it holds no cell.
    bool empty() const { return high.x < low.x || high.y < low.y; }
    /// The cells that both hold.
    CellRect common(const CellRect& other) const {
        return {{std::max(low.x, other.low.x), std::max(low.y, other.low.y)},
                {std::min(high.x, other.high.x), std::min(high.y, other.high.y)}};
    }
    /// The existing cells that `box` touches.
    static CellRect touching(const Grid& grid, const Box& box) {
        const Cell low = grid.cellOf(box.min), high = grid.cellOf(box.max);
        return CellRect{low, high}.common({{0, 0}, {grid.width - 1, grid.height - 1}});
    }
};

}  // namespace muster
