// What the empty ground costs.
#pragma once

#include <span>
#include <vector>

#include "muster/base/grid.h"
#include "muster/fields/unit_cost.h"

namespace muster {

/// What the empty ground is made of, one value per cell.
struct GroundRasters {
    const Grid& grid;
    std::span<const float> clearance;    ///< [m] From the cell's centre to the nearest obstacle.
    std::span<const float> travelSpeed;  ///< > 0
};

/// Writes to `cells` the cost of ground without crowd and discomfort: `price` over the travel speed, infinite where
/// a character of `radius` [m] cannot be and into such cells. Beside walls the cost of an
/// edge holds its true length (see docs/method/unit-cost.md). `nodes` lists the
/// cells beside walls. Returns the lowest cost of a true metre.
float priceGround(const GroundRasters& ground, double radius, double price, std::vector<CellCost>& cells,
                  std::vector<WallNode>& nodes);

}  // namespace muster
