// Square tiles of ground cells.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/cell_rect.h"

namespace muster {

/// True where the cell is one of the rectangle's.
inline bool contains(const CellRect& cells, Cell c) {
    return c.x >= cells.low.x && c.y >= cells.low.y && c.x <= cells.high.x && c.y <= cells.high.y;
}

/// Edge of a tile [cells].
inline constexpr std::int32_t kTileCells = 32;
/// Cells of a whole tile.
inline constexpr std::int32_t kTileArea = kTileCells * kTileCells;
/// Directions to the neighbours of a tile: east, north, north-east, north-west, and the opposite ones, each
/// four after its own.
inline constexpr std::int32_t kDirections = 8;
/// The offset of the neighbour in each direction [tiles or cells].
inline constexpr std::array<Cell, kDirections> kOffsets{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}, {1, -1}}};

/// A grid divided into tiles; tiles at the right and upper edge may be smaller.
struct TileGrid {
    Grid cells;                          ///< The ground cells.
    std::int32_t width = 0, height = 0;  ///< Size in tiles.

    /// The tiles of a grid.
    static TileGrid over(const Grid& grid) {
        return {grid, (grid.width + kTileCells - 1) / kTileCells,
                (grid.height + kTileCells - 1) / kTileCells};
    }
    std::int32_t count() const { return width * height; }  ///< Number of tiles.
    /// The tile that holds a cell of the grid.
    std::int32_t tileOf(Cell c) const { return (c.y / kTileCells) * width + c.x / kTileCells; }
    /// The cells of a tile.
    CellRect cellsOf(std::int32_t tile) const {
        const Cell low{tile % width * kTileCells, tile / width * kTileCells};
        return {
            low,
            {std::min(low.x + kTileCells, cells.width) - 1, std::min(low.y + kTileCells, cells.height) - 1}};
    }
    /// Index of a cell within its tile.
    static std::int32_t localOf(Cell c) { return c.y % kTileCells * kTileCells + c.x % kTileCells; }
    /// The neighbour of a tile in a direction; -1 where there is none.
    std::int32_t neighbour(std::int32_t tile, std::int32_t direction) const {
        const std::int32_t x = tile % width + kOffsets[direction].x, y = tile / width + kOffsets[direction].y;
        return x >= 0 && y >= 0 && x < width && y < height ? y * width + x : -1;
    }
    /// The tiles that a rectangle of cells meets, as a rectangle.
    CellRect tilesOf(const CellRect& rect) const {
        if (rect.empty()) return {};
        return CellRect{{rect.low.x / kTileCells, rect.low.y / kTileCells},
                        {rect.high.x / kTileCells, rect.high.y / kTileCells}}
            .common({{0, 0}, {width - 1, height - 1}});
    }
};

}  // namespace muster
