// Unit cost of the ground alone, without crowd and discomfort, with walls placed to a fraction of a cell
// (docs/method/unit-cost.md).
#pragma once

#include <span>
#include <vector>

#include "base/grid.h"
#include "cost/unit_cost.h"

namespace muster {

/// What the ground cost depends on, one value per cell.
struct GroundRasters {
    const Grid& grid;
    std::span<const float> clearance;    ///< Distance from the cell's centre to the nearest obstacle [m].
    std::span<const float> travelSpeed;  ///< Speed relative to running, > 0.
};

/// Distance at which a change of the clearance can still change the cost of a cell [cells].
inline constexpr std::int32_t kGroundReach = 2;
/// Clearances beyond the radius plus or minus this all give the same cost [cells].
inline constexpr double kGroundBand = 3.0;

/// Where the ground cost is written.
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
/// The same for the listed cells.
void computeGroundCost(const GroundRasters& ground, double radius, double openCost,
                       std::span<const std::int32_t> cells, const GroundCosts& costs);

}  // namespace muster
