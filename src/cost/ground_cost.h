// What the empty ground costs.
#pragma once

#include <span>
#include <vector>

#include "base/grid.h"
#include "cost/unit_cost.h"

namespace muster {

/// What the empty ground is made of, one value per cell.
struct GroundRasters {
    const Grid& grid;
    std::span<const float> clearance;    ///< [m] From the cell's centre to the nearest obstacle.
    std::span<const float> travelSpeed;  ///< > 0
};

/// How far away a change of the clearance can change what a cell costs [cells].
inline constexpr std::int32_t kGroundReach = 2;
/// Clearances this much above or below the radius all price the ground alike [cells].
inline constexpr double kGroundBand = 3.0;

/// The cost of ground without crowd and discomfort.
struct GroundCosts {
    std::vector<CellCost>& cells;  ///< Cost of a metre over each edge.
    std::vector<float>& unit;      ///< Cost of a true metre in each cell; infinite in walls.
    std::vector<WallNode>& nodes;  ///< Cells beside walls are appended here.
};

/// Prices the cells `first` to `last` - 1: `price` over the travel speed, infinite where a character of
/// `radius` [m] cannot be and into such cells. Beside walls the cost of an edge holds its true length (see
/// docs/method/unit-cost.md).
void priceGround(const GroundRasters& ground, double radius, double price, std::int32_t first,
                 std::int32_t last, const GroundCosts& costs);
/// The same for the cells listed.
void priceGround(const GroundRasters& ground, double radius, double price,
                 std::span<const std::int32_t> cells, const GroundCosts& costs);

}  // namespace muster
