// Validation of what a plan is started with.
#pragma once

#include "planning/plan.h"

namespace muster {

/// Refuses what Plan::start() must refuse, with InvalidArgument and the value that is wrong.
Status validatePlan(const PlanDef& def, const PlanInput& input);

}  // namespace muster
