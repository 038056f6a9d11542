// Rasters with few cells that differ from zero.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace muster {

/// One value per cell, in memory only where one was set: square tiles from a pool that grows as needed. All
/// other tiles share one of zeros. Clearing costs as much as there are tiles in use.
template <class Value>
class SparseRaster {
public:
    /// Sets the size, and all values to zero.
    void reset(const Grid& grid) {
        tilesAcross_ = (grid.width + kEdge - 1) / kEdge;
        tile_.assign(static_cast<std::size_t>(tilesAcross_) * ((grid.height + kEdge - 1) / kEdge), 0);
        values_.assign(kCells, Value{});
        used_.clear();
    }
    /// Sets all values to zero; keeps the memory.
    void clear() {
        for (std::size_t k = 0; k < used_.size(); ++k) {
            tile_[used_[k]] = 0;
            std::fill_n(values_.begin() + static_cast<std::ptrdiff_t>((k + 1) * kCells), kCells, Value{});
        }
        used_.clear();
    }
    /// The value of a cell of the grid.
    Value operator[](Cell c) const { return tileOf(c)[within(c)]; }
    /// The value of a cell of the grid, to be written.
    Value& touch(Cell c) {
        const std::size_t number = tileNumber(c);
        if (tile_[number] == 0) {
            used_.push_back(static_cast<std::int32_t>(number));
            tile_[number] = static_cast<std::int32_t>(used_.size());
            values_.resize(std::max(values_.size(), (used_.size() + 1) * kCells), Value{});
        }
        return values_[static_cast<std::size_t>(tile_[number]) * kCells + within(c)];
    }
    /// The values of a square of cells from `low` to `high`, which lie at most one cell apart along each
    /// axis: lower left, lower right, upper left, upper right.
    struct Square {
        Value value[4];
    };
    /// Reads a square of cells of the grid.
    Square square(Cell low, Cell high) const {
        if (((low.x ^ high.x) | (low.y ^ high.y)) >> kShift == 0) {
            const Value* first = tileOf(low) + within(low);
            const std::int32_t right = high.x - low.x, up = (high.y - low.y) << kShift;
            return {{first[0], first[right], first[up], first[up + right]}};
        }
        return {{(*this)[low], (*this)[{high.x, low.y}], (*this)[{low.x, high.y}], (*this)[high]}};
    }
    /// Number of tiles in memory, with the tile of zeros.
    std::size_t tiles() const { return values_.size() / kCells; }

private:
    static constexpr std::int32_t kShift = 5;           // Shift from cells to tiles.
    static constexpr std::int32_t kEdge = 1 << kShift;  // Edge of a tile [cells].
    static constexpr std::size_t kCells = static_cast<std::size_t>(kEdge) * kEdge;

    std::size_t tileNumber(Cell c) const {
        return static_cast<std::size_t>((c.y >> kShift) * tilesAcross_ + (c.x >> kShift));
    }
    const Value* tileOf(Cell c) const {
        return values_.data() + static_cast<std::size_t>(tile_[tileNumber(c)]) * kCells;
    }
    static std::size_t within(Cell c) {
        return static_cast<std::size_t>(((c.y & (kEdge - 1)) << kShift) + (c.x & (kEdge - 1)));
    }

    std::int32_t tilesAcross_ = 0;
    std::vector<std::int32_t> tile_;  // Per tile of the grid: its number in memory, 0 for zeros.
    std::vector<Value> values_;       // Values tile by tile; tiles beyond the used ones hold zeros.
    std::vector<std::int32_t> used_;  // Tiles of the grid that have memory, in the order of their numbers.
};

}  // namespace muster
