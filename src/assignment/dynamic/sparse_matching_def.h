// What the sparse matching is asked, and what all its parts read during a step.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "assignment/dynamic/pair_costs.h"
#include "base/maths.h"
#include "base/parallel.h"
#include "muster/vec2.h"

namespace muster {

/// The objective, when changes are committed, and how much work a step may do (counts, never time).
struct MatchingDef {
    double exponent = 2.0;  ///< p of the objective sum c^p, 1 to 16.
    /// A change (one cycle of exchanges) must gain more than this [cost^p] >= 0.
    double threshold = 0.1;
    /// ... and more than this share of the objective of those it concerns >= 0.
    double thresholdShare = 0.001;
    /// Every so many steps a row of arcs asks for its costs again, >= 1.
    std::int32_t refreshPeriod = 4;
    std::int32_t farRefreshPeriod = 16;  ///< ... where the mean cost is above `farCost`.
    /// ... where it is below `nearCost`: of what little is left small changes are much.
    std::int32_t nearRefreshPeriod = 2;
    std::int32_t retargetPeriod = 32;  ///< Every so many steps a row looks for its neighbours anew.
    double farCost = 15.0;             ///< [m]
    double nearCost = 1.0;             ///< [m]
    double searchShare = 3.0;          ///< Nodes settled in all searches of a step, per seat.
    /// ... where the mean cost is above `farCost`: changes are slow then.
    double farSearchShare = 0.4;
    /// Steps, at most 255, for which a change that gained too little is not tried again...
    std::int32_t rest = 5;
    std::int32_t farRest = 16;       ///< ... where the mean cost is above `farCost`.
    std::int32_t searchLimit = 600;  ///< Nodes settled in one search.
    /// A place whose cost has changed by so much since asks at once for arcs to it [m].
    double jump = 0.3;
    std::int32_t coldRounds = 3;  ///< Repairs after a cold start.
    /// Calls over which one round of asking and repairing is spread, >= 1. Periods are about twice as long
    /// then.
    std::int32_t turns = 1;

    /// Of these calls the last ones repair...
    std::int32_t repairTurns() const { return std::max(1, (turns + 1) / 3); }
    /// ... and those before ask for costs; a single call does both.
    std::int32_t refreshTurns() const { return std::max(1, turns - repairTurns()); }
    /// A period of so many steps, in rounds.
    std::int32_t rounds(std::int32_t steps) const {
        return std::max(1, turns <= 1 ? steps : (2 * steps + turns - 1) / turns);
    }
};

/// What a matching reads. Spans stay valid during the call only.
struct MatchingInput {
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
        if (p > 8.0) unit_ = PairCosts::kNoWay / power(10.0, 32.0 / p);
        whole_ = static_cast<std::int32_t>(p);
        if (p != whole_) whole_ = 0;
    }
    /// `cost` [m] to the power, in units of metre^p divided by units().
    double operator()(double cost) const {
        const double c = std::min(cost, static_cast<double>(PairCosts::kNoWay)) / unit_;
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
struct MatchingContext {
    const MatchingDef& def;
    const MatchingInput& input;
    PairCosts& costs;
    ThreadPool& pool;
    CostPower power;
    /// Of the prices' frame: the true price of a seat is its price + slope . position.
    Vec2 slope;
    Vec2 anchor;           ///< Stands for the position of seats without a place [m].
    double threshold = 0;  ///< def.threshold in the units of `power`.
};

}  // namespace muster
