// Commit rule: the exchanges between the incumbent and the optimal flows that are made (SPEC A1: a threshold
// against endless swapping).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "engine/assignment/planning/plan.h"

namespace muster {

/// Cost of a unit of a flow.
struct FlowCost {
    double cost = 0.0;    ///< Cost to the power of the objective, finite.
    bool inClass = true;  ///< True if the character and the place are of one class.
};
/// The cost of a unit from a character to a place.
using FlowCostOf = FunctionRef<FlowCost(std::int32_t character, std::int32_t place)>;

/// The difference between the two lists of flows falls into exchanges that share no character and no place:
/// the connected components of the symmetric difference, found by union-find (with unit amounts: cycles, and
/// paths that end at an unmatched character or an unused place). Each exchange is committed or dropped as a
/// whole, so that any choice is feasible. Owns its working memory.
class CommitRule {
public:
    /// `costOf` is asked for every flow. Both lists of flows are ordered by character, then place. Writes the
    /// flows to be committed in the same order.
    void choose(const PlanDef& def, std::int32_t characters, std::int32_t places, FlowCostOf costOf,
                std::span<const Flow> incumbent, std::span<const Flow> optimal, std::vector<Flow>& committed);

private:
    /// One component of the difference. Costs are to the power of the objective.
    struct Exchange {
        double moreMatched = 0.0;          // Amount that the optimal flows send beyond the incumbent ones.
        double moreInClass = 0.0;          // Amount beyond the incumbent flows within classes.
        double incumbentCost = 0.0;        // Sum over its incumbent flows.
        double optimalCost = 0.0;          // Sum over its optimal flows.
        double incumbentBottleneck = 0.0;  // Cost of its costliest incumbent pair.
        bool commit = false;
    };
    bool isWorthwhile(const PlanDef& def, const Exchange& exchange, double bottleneck) const;
    std::int32_t find(std::int32_t node);
    void unite(std::int32_t a, std::int32_t b);
    template <class Visit>
    void forEachPair(std::span<const Flow> incumbent, std::span<const Flow> optimal, Visit visit) const;

    double tolerance_ = 0.0;            // Amounts up to this count as zero.
    std::vector<std::int32_t> parent_;  // Union-find forest: characters, then places.
    std::vector<Exchange> exchanges_;   // Exchanges, at the representative of each component.
};

}  // namespace muster
