// The costs of a step, as plans ask for them.
#pragma once

#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/fields/geodesics/shared_far_fields.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/routes/route_graph.h"

namespace muster {

/// The costs that a step offers to plans. Each part is brought up to date when it is first asked for in a
/// step, so that nobody needs to know which plan reads what. References stay valid; their contents change
/// with the next step's first request, which comes after all background work.
class PlanCosts {
public:
    virtual ~PlanCosts() = default;

    virtual const Environment& environment() const = 0;  ///< Obstacles and patches.
    virtual const UnitCost& unitCost() = 0;              ///< Unit cost of all ground cells, with the crowd.
    virtual const StaticGround& staticGround() = 0;      ///< Static ground.
    virtual const DynamicCost& dynamicCost() = 0;        ///< Dynamic cost of crowd and moving things.
    virtual RouteGraph* routes() { return nullptr; }     ///< Routes of characters; null for unknown.
    /// Far fields that all groups share on the static ground; null for none.
    virtual SharedFarFields* farFields() { return nullptr; }
    /// The costs for larger or smaller bodies; 0 for the usual size. Valid as long as these.
    virtual PlanCosts& ofClass(std::int32_t /*groundClass*/) { return *this; }
};

}  // namespace muster
