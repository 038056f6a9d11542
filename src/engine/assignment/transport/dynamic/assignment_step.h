// Inputs of the phases of one step of a dynamic assignment.
#pragma once

#include "base/parallel.h"
#include "engine/assignment/transport/dynamic/cost_oracle.h"
#include "engine/assignment/transport/dynamic/cost_power.h"
#include "engine/assignment/transport/dynamic/dynamic_assignment_def.h"
#include "muster/vec2.h"

namespace muster {

/// The arguments of one call of DynamicAssignment.
struct AssignmentProblem {
    const DynamicAssignmentDef& def;  ///< Objective and limits.
    const AssignmentInput& input;     ///< Positions of characters and places.
    CostOracle& costs;                ///< Costs of pairs.
    ThreadPool& pool;                 ///< Threads that evaluate costs.
};

/// A problem with the exponent and the dual shift of this step. Only ExchangeGraph makes one, once its nodes
/// are those of the problem. All later phases take it, so none of them can run before.
class AssignmentStep : public AssignmentProblem {
public:
    const CostPower power;   ///< Raises costs to the exponent of the objective.
    const double threshold;  ///< The commit threshold in the units of `power`.
    /// The dual shift: the dual of a node is its stored dual + dualSlope . position [units of `power` per
    /// metre].
    const Vec2 dualSlope;
    const Vec2 dummyPosition;  ///< Position that stands for dummy nodes [m].

private:
    friend class ExchangeGraph;
    AssignmentStep(const AssignmentProblem& problem, const CostPower& costPower, Vec2 slope, Vec2 dummy)
        : AssignmentProblem(problem),
          power(costPower),
          threshold(problem.def.threshold / costPower.units()),
          dualSlope(slope),
          dummyPosition(dummy) {}
};

}  // namespace muster
