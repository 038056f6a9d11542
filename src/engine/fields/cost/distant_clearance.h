// Clearances beyond the cap of the environment's raster.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_rect.h"
#include "base/grid.h"

namespace muster {

/// Tells by how much the clearance of a capped cell may at least be extended: the distance to the nearest
/// block of 4 x 4 cells with a smaller clearance, up to 16 blocks. An exact Euclidean distance transform
/// (Saito and Toriwaki 1994) whose bounded reach makes updates local.
class DistantClearance {
public:
    /// Lays blocks over the cells of `grid`; update() of all cells must follow.
    void reset(const Grid& grid);
    /// Computes the values that depend on the clearances in `area` [m], given for all cells.
    void update(std::span<const float> clearance, const CellRect& area);
    /// Lower bound of the clearance beyond the cap, for a capped cell [m] >= 0.
    float beyond(Cell c) const { return beyond_[(c.y / kBlock) * blocks_.width + c.x / kBlock]; }

    static constexpr std::int32_t kBlock = 4;  ///< Edge of a block [cells].

private:
    static constexpr std::int32_t kReach = 16;  // Reach of the distance transform [blocks].

    void findOccupied(std::span<const float> clearance, const CellRect& blocks);
    void transformRows(const CellRect& blocks);
    void transformColumns(const CellRect& blocks);

    Grid cells_;
    Grid blocks_;
    std::vector<std::uint8_t> occupied_;  // Per block: 1 where a cell has a clearance below the cap.
    // Per block: distance to the nearest occupied one of its row [blocks], at most kReach.
    std::vector<std::uint8_t> alongRow_;
    std::vector<float> beyond_;  // Clearance beyond the cap per block [m].
};

}  // namespace muster
