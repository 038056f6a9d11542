// The static ground on cells of one size.
#pragma once

#include <cstdint>
#include <vector>

#include "cost/unit_cost.h"

namespace muster {

/// Unit cost and clearance of the static ground on one level of a grid hierarchy.
struct GroundLevel {
    UnitCost cost;  ///< Unit cost of the static ground.
    /// Per cell: distance from the centre to the nearest obstacle less the characters' radius [m]; negative
    /// in walls.
    std::vector<float> clearance;
    /// Per cell: lower bound of the distance to the nearest wall or ground of another unit cost, less the
    /// radius for walls [m].
    std::vector<float> uniformClearance;

    /// True where no character of this radius can stand at the centre of the cell.
    bool blocked(std::int32_t cell) const { return clearance[cell] < 0.0f; }
    /// The free cell whose centre is nearest to `p` within two cells; -1 where there is none.
    std::int32_t freeCellNear(Vec2 p) const;
};

}  // namespace muster
