// The ground that a plan has read, so that edits elsewhere leave the plan as it is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/cell_rect.h"
#include "base/grid.h"

namespace muster {

/// A set of square tiles of ground cells, at most 32 x 32 for the whole ground.
class AskedTiles {
public:
    /// Becomes empty, for the ground cells of `grid`.
    void reset(const Grid& grid) {
        grid_ = grid;
        shift_ = 0;
        while ((std::max(grid.width, grid.height) - 1) >> shift_ >= kSide) ++shift_;
        rows_.assign(static_cast<std::size_t>(((std::max(grid.height, 1) - 1) >> shift_) + 1), 0);
    }
    /// Adds the tile in which the cell nearest to `p` lies.
    void add(Vec2 p) {
        const Cell cell = grid_.nearestCell(p);
        rows_[static_cast<std::size_t>(cell.y >> shift_)] |= std::uint32_t{1} << (cell.x >> shift_);
    }
    /// True where one of the tiles contains a cell of the area.
    bool meets(const CellRect& area) const {
        const CellRect cells = area.common({{0, 0}, {grid_.width - 1, grid_.height - 1}});
        if (cells.empty()) return false;
        const std::uint32_t above = ~std::uint32_t{0} << (cells.low.x >> shift_);
        const std::uint32_t below = ~std::uint32_t{0} >> (kSide - 1 - (cells.high.x >> shift_));
        const auto isAsked = [&](std::uint32_t row) { return (row & above & below) != 0; };
        return std::any_of(rows_.begin() + (cells.low.y >> shift_),
                           rows_.begin() + (cells.high.y >> shift_) + 1, isAsked);
    }
    /// True where it fits a ground of that many cells; for tiles read from a file.
    bool fits(const Grid& grid) const {
        AskedTiles fresh;
        fresh.reset(grid);
        return grid_ == grid && shift_ == fresh.shift_ && rows_.size() == fresh.rows_.size();
    }

    /// Lets an archive read or write the tiles.
    template <class Archive>
    void visit(Archive& archive) {
        archive(grid_, shift_, rows_);
    }

private:
    static constexpr std::int32_t kSide = 32;  // Tiles of a row; bits of a word.

    Grid grid_;
    std::int32_t shift_ = 0;           // A tile has 2^shift cells along its edge.
    std::vector<std::uint32_t> rows_;  // A bit for each tile.
};

}  // namespace muster
