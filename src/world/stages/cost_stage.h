// The stage of density and unit cost (SPEC A3 to A5).
#pragma once

#include "cost/density.h"
#include "cost/unit_cost_builder.h"
#include "world/state/world_state.h"

namespace muster {

/// Owns the density of the crowd, and the unit cost for the plans that read it.
class CostStage {
public:
    /// Prepares the density for a world before its first step.
    void reset(const WorldState& state);
    /// Computes the density, and the unit cost where a plan of this step reads it.
    void run(const WorldState& state);

    /// Density and average velocity by the last run.
    const DensityField& density() const { return density_; }
    /// The unit cost by the last run; computed now where no plan read it.
    const UnitCost& unitCost(const WorldState& state);

private:
    void build(const WorldState& state);

    Parameters::Density def_;  // The density is made for its cell and lambda.
    DensityField density_;
    UnitCostBuilder builder_;
    bool built_ = false;  // For the density as it is.
};

}  // namespace muster
