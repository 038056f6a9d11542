// Connected components of the free cells of one tile, and the crossings between neighbouring tiles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_ground.h"
#include "engine/ground/routes/tile_grid.h"

namespace muster {

/// The components of a tile: sets of cells with a point to stand at that clear steps within the tile join.
/// They are numbered from 0 in row-major order of their first cells.
struct TileComponents {
    std::int32_t count = 0;  ///< Number of components; 0 where nobody can stand.
    bool open = false;       ///< True where all lines between points of the tile are clear.
    /// With one component that is not open: a bit per cell, row by row.
    std::vector<std::uint32_t> rows;
    /// With more components: the label of each cell, kNone for no label.
    std::vector<std::uint16_t> labels;

    static constexpr std::uint16_t kNone = 0xffff;
    /// The component of a cell, given by its index within the tile; -1 for none.
    std::int32_t at(std::int32_t local) const {
        if (open) return 0;
        if (count == 1) return (rows[local / kTileCells] >> (local % kTileCells)) & 1u ? 0 : -1;
        return count == 0 || labels[local] == kNone ? -1 : labels[local];
    }
};

/// A step from one tile to a neighbour.
struct BorderCrossing {
    Cell from;                       ///< Cell of the first tile.
    Cell to;                         ///< Cell of the second tile.
    std::int32_t fromComponent = 0;  ///< Component in the first tile.
    std::int32_t toComponent = 0;    ///< Component in the second tile.
};

/// Computes components, with memory of its own.
class TileLabeller {
public:
    /// Finds the components of the tile of these cells. Memory of `result` is reused.
    void run(const RouteGround& ground, const CellRect& cells, TileComponents& result);

private:
    std::int32_t rootOf(std::int32_t k);
    void joinSets(std::int32_t a, std::int32_t b);
    void joinByRaster(const RouteGround& ground, const CellRect& cells);
    void joinByGeometry(const RouteGround& ground, const CellRect& cells);
    void number(const CellRect& cells, TileComponents& result);

    std::array<std::int32_t, kTileArea> parent_{};  // Disjoint sets of cells; -1 where nobody can stand.
    std::array<Vec2, kTileArea> point_{};           // Points where a disc can stand [m].
};

/// One side of a tile border.
struct BorderTile {
    CellRect cells;                    ///< Cells of the tile.
    const TileComponents* components;  ///< Components of the tile.
};

/// Appends the crossings from `tile` to its neighbour in one of the first four directions: of each maximal
/// run of steps between one pair of components the steps at its ends and some between, or the middle one of a
/// short run. Steps to the neighbour's next cell but one count where no straight step joins the pair.
void findCrossings(const RouteGround& ground, const BorderTile& tile, const BorderTile& neighbour,
                   std::int32_t direction, std::vector<BorderCrossing>& crossings);

}  // namespace muster
