// What the sparse matching is asked, and what all its parts read during a step.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "assignment/dynamic/cost_oracle.h"
#include "base/maths.h"
#include "base/parallel.h"
#include "muster/vec2.h"

namespace muster {

/// The objective, the commit threshold, and the work of one step. Work is limited by counts, never by time,
/// so that results do not depend on the machine. "Far" and "near" compare the mean cost of all nodes with
/// `farCost` and `nearCost`.
struct DynamicAssignmentDef {
    double exponent = 2.0;  ///< p of the objective sum c^p, 1 to 16.
    /// An exchange must lower the objective by more than this [cost^p] >= 0. The plan sets it (PlanDef).
    double threshold = 0.0;
    /// An exchange must lower the objective of its assignees by more than this share of it >= 0. The plan
    /// sets it (PlanDef).
    double thresholdShare = 0.0;
    std::int32_t refreshPeriod = 4;      ///< Steps between two refreshes of a node's arcs, >= 1.
    std::int32_t farRefreshPeriod = 16;  ///< The same while the crowd is far, >= 1 [steps].
    std::int32_t nearRefreshPeriod = 2;  ///< The same while the crowd is near, >= 1 [steps].
    std::int32_t candidatePeriod = 32;   ///< Steps between two searches for the heads of a node's arcs, >= 1.
    double farCost = 15.0;               ///< Mean cost above which the crowd is far [m].
    double nearCost = 1.0;               ///< Mean cost below which the crowd is near [m].
    double settledPerNode = 3.0;         ///< Nodes that the searches of a step may settle, per node.
    double farSettledPerNode = 0.4;      ///< The same while the crowd is far.
    std::int32_t searchLimit = 600;      ///< Nodes that one search may settle.
    std::int32_t
        retryDelay = 5;  ///< Steps before a node whose cycle gained too little is tried again, <= 255.
    std::int32_t farRetryDelay = 16;  ///< The same while the crowd is far, <= 255 [steps].
    double invalidatingChange = 0.3;  ///< Change of a matched cost that invalidates all arcs of its node [m].
    std::int32_t initialRounds = 3;   ///< Repairs after a cold start.
    std::int32_t stepsPerRound = 1;   ///< Steps over which one round of refresh and repair is spread, >= 1.

    /// Steps at the end of a round that repair. A round of one step refreshes and repairs in it.
    std::int32_t repairSteps() const { return std::max(1, (stepsPerRound + 1) / 3); }
    /// Steps at the beginning of a round that refresh arcs.
    std::int32_t refreshSteps() const { return std::max(1, stepsPerRound - repairSteps()); }
    /// A period of so many steps, in rounds; about twice as long where rounds take several steps.
    std::int32_t rounds(std::int32_t steps) const {
        return std::max(1, stepsPerRound <= 1 ? steps : (2 * steps + stepsPerRound - 1) / stepsPerRound);
    }
};

/// What an assignment reads. Spans stay valid during the call only.
struct AssignmentInput {
    std::span<const Vec2> characters;      ///< Positions [m].
    std::span<const Vec2> places;          ///< Positions [m].
    std::span<const std::uint8_t> usable;  ///< Per place, 0 for one nobody may take; empty for all.
    /// Per character, 0 for one that takes part in nothing; empty for all.
    std::span<const std::uint8_t> present;

    /// True where somebody may take the place.
    bool mayTake(std::size_t place) const { return usable.empty() || usable[place] != 0; }
    /// True where the character takes part.
    bool takesPart(std::size_t character) const { return present.empty() || present[character] != 0; }
};

/// Costs to the power of the objective, in a unit that keeps them within single precision.
class CostPower {
public:
    /// For the exponent `p`, 1 to 16.
    explicit CostPower(double p = 2.0) : exponent_(p) {
        if (p > 8.0) unit_ = CostOracle::kUnreachable / power(10.0, 32.0 / p);
        whole_ = static_cast<std::int32_t>(p);
        if (p != whole_) whole_ = 0;
    }
    /// `cost` [m] to the power, in units of metre^p divided by units().
    double operator()(double cost) const {
        const double c = std::min(cost, static_cast<double>(CostOracle::kUnreachable)) / unit_;
        if (whole_ == 2) return c * c;
        if (whole_ == 0) return power(c, exponent_);
        double product = c;
        for (std::int32_t k = 1; k < whole_; ++k) product *= c;
        return product;
    }
    double exponent() const { return exponent_; }             ///< p
    double units() const { return power(unit_, exponent_); }  ///< Multiplies results back to metre^p.

private:
    double exponent_ = 2.0;
    double unit_ = 1.0;       // [m]
    std::int32_t whole_ = 2;  // The exponent where it is a whole number, else 0.
};

/// What the parts of a matching read during one call.
struct AssignmentStep {
    const DynamicAssignmentDef& def;
    const AssignmentInput& input;
    CostOracle& costs;
    ThreadPool& pool;
    CostPower power;
    /// Of the prices' frame: the true price of a seat is its price + slope . position.
    Vec2 slope;
    Vec2 anchor;           ///< Stands for the position of seats without a place [m].
    double threshold = 0;  ///< def.threshold in the units of `power`.
};

}  // namespace muster
