// What the empty ground costs.
#pragma once

#include <vector>

#include "muster/environment/environment.h"
#include "muster/fields/unit_cost.h"

namespace muster {

/// Writes to `cells` the cost of ground without crowd and discomfort: `price` over the travel speed, infinite where
/// a character of `radius` [m] cannot be and into such cells. Returns the lowest finite cost, `price` where none is.
float priceGround(const Environment& environment, double radius, double price, std::vector<CellCost>& cells);

}  // namespace muster
