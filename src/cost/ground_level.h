// The still ground on cells of one size.
#pragma once

#include <cstdint>
#include <vector>

#include "cost/unit_cost.h"

namespace muster {

/// What a metre costs on each cell, and how far it is from there to the walls.
struct GroundLevel {
    UnitCost cost;  ///< Of the still ground.
    /// Per cell: what a character at its centre has to the walls [m]; negative in them.
    std::vector<float> clearance;
    /// The same to walls and to ground that costs something else, a lower bound [m].
    std::vector<float> uniformClearance;

    /// True where nobody of the radius can stand at the centre of the cell.
    bool blocked(std::int32_t cell) const { return clearance[cell] < 0.0f; }
    /// The free cell nearest to `p` within two cells, -1 where there is none.
    std::int32_t freeCellNear(Vec2 p) const;
};

}  // namespace muster
