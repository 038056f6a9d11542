// Duality gap of a committed plan, by an exact and by a bounding method.
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "engine/fields/cost/unit_cost.h"
#include "muster/status.h"

namespace muster::scale {

/// A committed plan to be judged.
struct Committed {
    std::vector<Vec2> characters;       ///< Positions [m].
    std::vector<Vec2> places;           ///< Positions [m].
    std::vector<std::int32_t> placeOf;  ///< Place of each character, unique; -1 for none.
    double exponent = 2.0;              ///< Exponent p of the objective.
};

/// The result of a judge. The optimum fills the same places as the plan, with any characters.
struct Verdict {
    double committed = 0.0;    ///< Objective of the plan [cost^p].
    double bound = 0.0;        ///< The optimum, or a proven lower bound of it [cost^p].
    std::int32_t matched = 0;  ///< Characters with a place that they can reach.
    std::int32_t rounds = 0;   ///< Number of assignment problems solved.
    std::int64_t pairs = 0;    ///< Number of pairs whose cost was evaluated.

    /// Relative gap (committed - bound) / max(bound, n 0.25^p), as SPEC defines it.
    double gap(double exponent) const;
};

/// Finds the optimum by the exact plan. Fails as ExactPlan does.
Result<Verdict> judgeExactly(const UnitCost& cost, const Committed& plan, ThreadPool& pool);

/// Finds a lower bound by duality. Near pairs have their exact costs; all others are bounded by the straight
/// line at the lowest unit cost. Pairs that weaken the bound get their exact costs, in at most `rounds`
/// rounds.
Verdict judgeByBound(const UnitCost& cost, const Committed& plan, ThreadPool& pool, std::int32_t rounds = 5);

}  // namespace muster::scale
