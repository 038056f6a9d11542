// Unit cost of the ground alone, without crowd and discomfort, with walls placed to a fraction of a cell
// (docs/method/unit-cost.md).
#pragma once

#include <span>
#include <vector>

#include "base/cell_rect.h"
#include "base/grid.h"
#include "engine/fields/cost/ground_node.h"
#include "engine/fields/cost/narrow_ways.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/ground/environment/environment.h"

namespace muster {

/// Distance at which a change of the clearance can still change the cost of a cell [cells].
inline constexpr std::int32_t kGroundReach = 2;
/// Difference from the radius beyond which all clearances give the same cost [cells].
inline constexpr double kGroundBand = 3.0;

/// Arrays to which the ground cost is written.
struct GroundCosts {
    std::vector<CellCost>& cells;  ///< Unit cost times the length of the edge to the neighbour in cells.
    std::vector<float>& unit;      ///< Cost of a true metre in each cell; infinite in walls.
    std::vector<WallNode>& nodes;  ///< Wall nodes are appended here.
};

/// Computes the cells from `first` to `last` - 1: `openCost`, the unit cost of open ground, over the travel
/// speed; infinite where a character of `radius` [m] cannot be, and towards such cells. Near walls edges lead
/// from wall node to wall node and hold their true length.
void computeGroundCost(const GroundRasters& ground, double radius, double openCost, std::int32_t first,
                       std::int32_t last, const GroundCosts& costs);
/// Computes the ground cost of the listed cells.
void computeGroundCost(const GroundRasters& ground, double radius, double openCost,
                       std::span<const std::int32_t> cells, const GroundCosts& costs);

/// Computes the ground cost of small areas: each node is found once.
class GroundCostCrop {
public:
    /// Writes the cost of the cells in `area` to `cost`, whose cells are walls so far: that of cell c to cell
    /// c + `shift`; appends their wall nodes. The rasters must reach kGroundReach cells beyond the area, or
    /// to the edge of the ground. The cells that the `gaps` cross become walls; those of the list `narrow`,
    /// whose numbers are those of the rasters, are open where it says.
    void compute(const GroundRasters& ground, double radius, double openCost, const CellRect& area,
                 Cell shift, std::span<const ClosedGap> gaps, std::span<const NarrowCell> narrow,
                 UnitCost& cost);

private:
    void findNodes(const GroundRasters& ground, double radius, const CellRect& area);
    void closeGaps(const Grid& grid, std::span<const ClosedGap> gaps);
    void openNarrow(const Grid& grid, std::span<const NarrowCell> narrow);
    bool closeEdges(const Grid& grid, Cell cell, CellCost& cost) const;

    std::vector<GroundNode> nodes_;  // Nodes per cell of the rasters.
    // Open edges per cell of the rasters, by NarrowCell, and kNarrow; empty without narrow cells.
    std::vector<std::uint8_t> open_;
};

}  // namespace muster
