// How far a committed plan is from the optimum.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "cost/unit_cost.h"
#include "muster/status.h"

namespace muster::scale {

/// A plan as committed, to be judged on this ground.
struct Committed {
    std::vector<Vec2> characters;       ///< Positions [m].
    std::vector<Vec2> places;           ///< Positions [m].
    std::vector<std::int32_t> placeOf;  ///< Of each character; -1 for none. No two have the same.
    double exponent = 2.0;              ///< p of the objective.
};

/// What a judge says. Only places that somebody holds are to be filled, by anybody.
struct Verdict {
    double committed = 0.0;   ///< Objective of the plan [cost^p].
    double bound = 0.0;       ///< The optimum, or a proven lower bound of it [cost^p].
    std::int32_t held = 0;    ///< Characters that hold a place and can come to it.
    std::int32_t rounds = 0;  ///< Solves that it took.
    std::int64_t pairs = 0;   ///< Pairs whose cost was worked out.

    /// (committed - bound) / max(bound, n 0.25^p), as the specification has it.
    double gap(double exponent) const;
};

/// By the exact plan. Fails as that does.
Result<Verdict> judgeExactly(const UnitCost& cost, const Committed& plan, ThreadPool& pool);

/// By a certificate: costs of pairs near by, at least the straight line at the lowest unit cost for all
/// others, and prices that prove the bound. Pairs that spoil the bound get their true costs, in at most
/// `rounds` rounds.
Verdict judgeByBound(const UnitCost& cost, const Committed& plan, ThreadPool& pool, std::int32_t rounds = 5);

}  // namespace muster::scale
