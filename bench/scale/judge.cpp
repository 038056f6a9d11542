#include "scale/judge.h"

#include <algorithm>

#include "base/maths.h"
#include "engine/assignment/planning/fixed_costs.h"
#include "engine/assignment/planning/plan.h"

namespace muster::scale {

double Verdict::gap(double exponent) const {
    const double least = matched * power(0.25, exponent);
    return matched > 0 ? std::max(0.0, committed - bound) / std::max(bound, least) : 0.0;
}

// With a threshold that no exchange passes, the exact plan commits the incumbents, and its bound is the
// optimum.
Result<Verdict> judgeExactly(const UnitCost& cost, const Committed& plan, ThreadPool& pool) {
    std::vector<std::uint8_t> usable(plan.places.size(), 0);
    for (const std::int32_t place : plan.placeOf)
        if (place >= 0) usable[place] = 1;
    PlanDef def{.exponent = plan.exponent, .commitThreshold = 1e30};
    FixedCosts costs;
    costs.unit = &cost;
    const PlanInput input{plan.characters, {}, plan.places, {}, usable, plan.placeOf, &costs};
    const auto exact = makeExactPlan();
    if (Status status = exact->start(def, input); !status.ok()) return status.within("judge");
    PlanResult result;
    if (Status status = exact->finish(pool, result); !status.ok()) return status.within("judge");
    Verdict verdict;
    verdict.committed = result.objective;
    verdict.bound = result.objective - result.gapBound;
    verdict.matched = static_cast<std::int32_t>(result.flows.size());
    verdict.rounds = 1;
    verdict.pairs = static_cast<std::int64_t>(plan.characters.size()) *
                    static_cast<std::int64_t>(plan.places.size());
    return verdict;
}

}  // namespace muster::scale
