// Validation of what a plan is started with.
#pragma once

#include "engine/assignment/planning/assigner.h"

namespace muster {

/// Refuses what Assigner::start() must refuse, with InvalidArgument and the value that is wrong. The costs
/// are not looked at.
Status validatePlan(const PlanDef& def, const PlanInput& input);
/// Refuses a unit cost that does not fill its grid, with InvalidArgument.
Status validateUnitCost(const UnitCost& cost);

}  // namespace muster
