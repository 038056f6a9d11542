// The definitions of the layers, as they follow from a world's parameters.
#pragma once

#include "engine/assignment/planning/plan.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/formation/control/control_set.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/steering/contacts.h"
#include "muster/parameters.h"

namespace muster {

/// How touches become controls and how these move.
ControlDef controlDef(const Parameters& parameters);
/// How meshes relax and are displaced by obstacles.
FormationMeshDef meshDef(const Parameters& parameters);
/// How places travel.
PlaceDef placeDef(const Parameters& parameters);
/// Weights and thresholds of the unit cost.
UnitCostDef unitCostDef(const Parameters& parameters);
/// The objective of plans, and which exchanges they commit.
PlanDef planDef(const Parameters& parameters);
/// How contacts are resolved.
ContactDef contactDef(const Parameters& parameters);
/// Steps from plan to plan: `plan.period`, or what suits the solver where that is 0.
std::int32_t planPeriod(const Parameters& parameters);

}  // namespace muster
