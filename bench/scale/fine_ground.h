// The unit cost of a world on cells of another size, for judges.
#pragma once

#include "engine/fields/cost/unit_cost_builder.h"
#include "muster/world.h"

namespace muster::scale {

/// Follows a world whose obstacles and patches are not edited while it runs.
class FineGround {
public:
    /// Copies the ground of `world`, with cells of `factor` times the edge. Fails where that makes too many
    /// cells.
    static Result<FineGround> create(const World& world, double factor = 0.5);
    /// The unit cost now: obstacles, patches and their time as in the last step, the crowd as it stands after
    /// it.
    const UnitCost& update(const World& world);

private:
    Environment environment_;
    DensityField density_;
    UnitCostBuilder builder_;
    UnitCost cost_;
};

}  // namespace muster::scale
