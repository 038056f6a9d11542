// Costs for plans outside a world: parts that the caller has made.
#pragma once

#include "engine/assignment/planning/plan_costs.h"
#include "muster/assert.h"

namespace muster {

/// Hands out parts that it was given, which must outlive it. A plan may only ask for these.
struct FixedCosts final : PlanCosts {
    const Environment* world = nullptr;     ///< Obstacles and patches.
    const UnitCost* unit = nullptr;         ///< Unit cost of all ground cells.
    const StaticGround* still = nullptr;    ///< Static ground.
    const DynamicCost* changing = nullptr;  ///< Dynamic cost of crowd and moving things.

    const Environment& environment() const override { return given(world); }
    const UnitCost& unitCost() override { return given(unit); }
    const StaticGround& staticGround() override { return given(still); }
    const DynamicCost& dynamicCost() override { return given(changing); }

private:
    template <class Part>
    static const Part& given(const Part* part) {
        MUSTER_ASSERT(part != nullptr);
        return *part;
    }
};

}  // namespace muster
