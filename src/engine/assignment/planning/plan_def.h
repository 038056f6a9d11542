// The objective of a plan.
#pragma once

#include "muster/generated/parameters.h"

namespace muster {

/// The objective of a plan, and the rule by which exchanges are committed. Each plan freezes and archives its
/// own, so that later changes of parameters do not reach it.
struct PlanDef {
    /// Exponent p of the objective sum c^p f, in [1, 16].
    double exponent = Parameters::Plan{}.exponent;
    /// An exchange (a cycle or a path of moves) is committed only where it lowers the objective by more than
    /// this [cost^p] >= 0.
    double commitThreshold = Parameters::Plan{}.threshold;
    /// The gain of an exchange must also exceed this share of the objective of the characters that it moves
    /// >= 0.
    double commitThresholdShare = Parameters::Plan{}.thresholdShare;
    /// Lexicographic objective: the least bottleneck (cost of the costliest pair) comes first, then the sum
    /// above among the matchings that attain it.
    bool bottleneck = false;
    /// True for geodesic costs; false for straight-line distances (paths still follow the cost field).
    bool geodesic = Parameters::Plan{}.geodesic;
    std::int32_t groups = 1;         ///< Groups whose plans share the fields that a step solves >= 1.
    std::int32_t groupRank = 0;      ///< Number of this group among them >= 0.
    std::int32_t firstPlans = 1;     ///< Groups whose first plans share the budget of this step >= 1.
    std::int32_t firstPlanRank = 0;  ///< Number of this group among them >= 0.
    std::int32_t starts = 1;  ///< Groups whose plans go on from other places than before, at once >= 1.
    /// False keeps every incumbent place that is usable (assigned once, fixed places): only paths are
    /// planned.
    bool reassign = true;

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(exponent, commitThreshold, commitThresholdShare, bottleneck, geodesic, groups, groupRank,
                firstPlans, firstPlanRank, starts, reassign);
    }
};

}  // namespace muster
