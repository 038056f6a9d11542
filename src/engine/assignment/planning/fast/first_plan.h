// The course of a first plan over several steps.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/assignment/planning/plan_def.h"

namespace muster {

/// A first plan is made from nothing in its first step, by the costs that are known then. Where these lack
/// far fields it is provisional: the fields come within a budget of each step, and then the plan is made from
/// nothing again, for one group in a step. Repairs follow, one in each step. All changes of places in this
/// time belong to the first plan.
class FirstPlan {
public:
    /// Act of a step for a first plan.
    enum class Action : std::uint8_t {
        None,    ///< The first plan is made; exchanges follow.
        Start,   ///< Starts cold.
        Wait,    ///< Keeps the provisional plan.
        Repair,  ///< Repairs without a threshold.
    };

    /// Begins a plan; `nobody` has a place, or the incumbents are those of the `last` plan. True where far
    /// fields are to be solved now.
    bool begin(bool nobody, bool last) {
        first_ = nobody;
        if (!nobody && !last) stepsLeft_ = repairsLeft_ = 0;
        if (nobody) cells_ = 0;
        // In its last step it starts cold, whatever is missing.
        return nobody || stepsLeft_ > 1;
    }
    /// Cells of far fields that may be solved now; the caller subtracts those that were.
    std::int64_t& cells(const PlanDef& def, std::size_t characters) {
        const std::int64_t budget = std::max(kCells, kCellsEach * static_cast<std::int64_t>(characters));
        const std::int64_t own = budget / std::max(1, def.firstPlans);
        // Groups come to a field one after the other; otherwise all would in one step.
        cells_ += first_ ? own / kFirstShare - own * rankOf(def) : own;
        return cells_;
    }
    /// True where all missing fields are to be looked for. With many groups only where decide() would start
    /// cold if none were missing.
    bool looksThoroughly(const PlanDef& def) const {
        return first_ || def.firstPlans <= kFewGroups || isRound(def, stepsLeft_ - 1);
    }
    /// Decides the act of the step; `whole` where no far field is missing.
    void decide(const PlanDef& def, bool whole, std::size_t characters) {
        action_ = next(def, whole);
        if (action_ != Action::Start) return;
        repairsLeft_ = characters <= kSmallCrowd ? kRepairs : kLargeRepairs;
    }

    /// Number of repairs in the step that starts cold; in a large crowd they would take too long.
    static std::int32_t roundsAtOnce(std::size_t characters) { return characters <= kAtOnce ? 3 : 0; }

    Action action() const { return action_; }            ///< Act of this step.
    bool provisional() const { return stepsLeft_ > 0; }  ///< True where it will start cold again.
    /// True while changes of places are no exchanges.
    bool unfinished() const { return action_ != Action::None; }

    /// Lets an archive read or write the plan.
    template <class Archive>
    void visit(Archive& archive) {
        archive(action_, stepsLeft_, repairsLeft_, cells_, first_);
    }

private:
    static std::int32_t rankOf(const PlanDef& def) { return std::clamp(def.firstPlanRank, 0, 200); }
    // True in the step in which a round serves the group.
    static bool isRound(const PlanDef& def, std::int32_t stepsLeft) {
        return stepsLeft % std::max(1, def.firstPlans) == rankOf(def);
    }
    Action next(const PlanDef& def, bool whole) {
        if (first_) {
            stepsLeft_ = whole ? 0 : static_cast<std::uint8_t>(kSteps + rankOf(def));
            return Action::Start;
        }
        if (stepsLeft_ > 0) {
            --stepsLeft_;
            if (whole && isRound(def, stepsLeft_)) stepsLeft_ = 0;
            return stepsLeft_ == 0 ? Action::Start : Action::Wait;
        }
        if (repairsLeft_ == 0) return Action::None;
        --repairsLeft_;
        return Action::Repair;
    }

    // Number of cells of far fields solved in a step for first plans.
    static constexpr std::int64_t kCells = 40000;
    // Number of these cells for each character of a large crowd.
    static constexpr std::int64_t kCellsEach = 40;
    // Number of groups up to which each looks for missing fields in each step.
    static constexpr std::int32_t kFewGroups = 4;
    static constexpr std::int64_t kFirstShare = 4;    // Inverse share of these cells in the first step.
    static constexpr std::int32_t kSteps = 24;        // Number of steps in which the far fields should come.
    static constexpr std::uint8_t kRepairs = 21;      // Steps of repairs after the start, up to kSmallCrowd.
    static constexpr std::uint8_t kLargeRepairs = 4;  // Steps of repairs after the start of a larger crowd.
    static constexpr std::size_t kSmallCrowd = 3000;  // Number of characters of a small crowd.
    // Number of characters up to which repairs are made in the first step, too.
    static constexpr std::size_t kAtOnce = 500;

    Action action_ = Action::None;
    std::uint8_t stepsLeft_ = 0;    // Number of steps until it starts cold again.
    std::uint8_t repairsLeft_ = 0;  // Number of steps that repair it.
    bool first_ = false;            // True if nobody had a place in this step.
    std::int64_t cells_ = 0;        // Cells of far fields that may be solved for it now.
};

}  // namespace muster
