// The stages of ways: which character goes through which passage where more come than it lets through (SPEC
// A8).
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "engine/assignment/planning/plan_costs.h"
#include "engine/assignment/planning/planned_ways.h"
#include "engine/passages/passage_survey.h"
#include "engine/passages/way_choice.h"
#include "engine/state/world_state.h"
#include "engine/systems/passages/crossers.h"
#include "engine/systems/passages/group_ways.h"
#include "engine/systems/passages/passage_guide.h"
#include "engine/systems/passages/survey_trigger.h"
#include "engine/systems/passages/way_fields.h"
#include "engine/systems/passages/way_spread.h"

namespace muster {

/// Finds passages, chooses ways, and gives them to plans and steering.
class WayStage {
public:
    /// Takes a new or restored state; call before its first step. Fields that still hold are kept.
    void reset(const WorldState& state);

    // Called once in each step, in this order.

    /// Forgets passages where the ground has changed, and ends the ways of characters that have passed.
    void leavePassages(WorldState& state, PlanCosts& costs, ThreadPool& pool);
    /// Writes passages and chosen ways when that is due.
    void chooseWays(WorldState& state, ThreadPool& pool);
    /// Prepares the tables of chosen ways for plans and steering in this step.
    void prepareWays(const WorldState& state, ThreadPool& pool);

    /// The ways of a group, for its plan. Valid until the next run.
    PlannedWays waysOf(std::size_t group) const;
    /// True where a member of a group heads for a passage in this step, because its place is beyond; then
    /// writes the unit vector of its desired direction and the cost of its route [m].
    bool guide(const WorldState& state, std::size_t group, std::size_t member, std::int32_t place,
               Vec2& direction, double& cost) const;

private:
    bool groundChanged(const WorldState& state);
    static void clear(WorldState& state);
    static bool due(const WorldState& state);
    void look(WorldState& state);
    bool survey(WorldState& state);
    void decide(WorldState& state, ThreadPool& pool);
    static void dropIfPassed(WorldState& state, std::size_t character, bool behind);
    void dropPassed(WorldState& state, ThreadPool& pool);
    void choose(WorldState& state);
    bool keepCrossers(WorldState& state);
    void dropUnneeded(WorldState& state) const;
    void readChosen(const WorldState& state);
    void commit(WorldState& state);

    static constexpr std::size_t kMaxPassages = 12;  // Greatest number of passages of all groups together.

    bool waits_ = false;  // True if characters may have to wait before a passage in this step.
    // Inputs of walks in the last step.
    std::uint64_t staticVersion_ = 0;
    double radius_ = 0.0, openCost_ = 0.0;
    WayFields fields_;
    SurveyTrigger trigger_;
    PassageSurvey survey_{kMaxPassages};
    Crossers crossers_;
    WayChoice choice_;
    WaySpread spread_;
    mutable PassageGuide guide_;
    std::vector<GroupWays> groups_;
    std::vector<float> reach_;  // By character with a way: cost to its passage [m].
    // Tables of one choice.
    std::vector<double> slot_, capacity_;
    std::vector<std::int32_t> way_;  // Per crosser: index of its passage among the used ones.
    std::vector<std::uint8_t> movable_, marked_;
};

}  // namespace muster
