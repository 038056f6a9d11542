// Summed-area table (Crow 1984) over a set of grid cells.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/cell_rect.h"
#include "base/cell_set.h"
#include "base/grid.h"

namespace muster {

/// Answers in constant time whether a rectangle of cells holds a member of a set. Covers the bounding
/// rectangle of the members only.
class SummedAreaTable {
public:
    /// Sums up the members of `cells`, which are cells of `grid`.
    void build(const Grid& grid, const CellSet& cells);
    /// Allocates for grids of up to this size.
    void reserve(const Grid& grid) {
        sums_.reserve(static_cast<std::size_t>(grid.width + 1) * (grid.height + 1));
    }
    /// True where a member lies in `rect`.
    bool any(const CellRect& rect) const {
        const std::int32_t left = std::max(rect.low.x, bounds_.low.x);
        const std::int32_t low = std::max(rect.low.y, bounds_.low.y);
        const std::int32_t right = std::min(rect.high.x, bounds_.high.x) + 1;
        const std::int32_t high = std::min(rect.high.y, bounds_.high.y) + 1;
        if (left >= right || low >= high) return false;
        return sum(right, high) - sum(left, high) - sum(right, low) + sum(left, low) > 0;
    }

private:
    // Number of members with a column below x and a row below y.
    std::int32_t sum(std::int32_t x, std::int32_t y) const {
        return sums_[static_cast<std::size_t>(y - bounds_.low.y) * stride_ + (x - bounds_.low.x)];
    }

    CellRect bounds_;                 // Bounding rectangle of the members.
    std::int32_t stride_ = 0;         // Length of a row of sums_.
    std::vector<std::int32_t> sums_;  // One row and one column more than bounds_, which hold zeros.
};

}  // namespace muster
