// The stages of plans: which character goes to which place (SPEC A1 to A3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/assignment/planning/plan.h"
#include "engine/state/world_state.h"
#include "engine/systems/passages/way_stage.h"
#include "engine/systems/steering/group_members.h"
#include "muster/event.h"

namespace muster {

/// Steps from plan to plan: `period`, or the default of the solver where that is 0.
std::int32_t planPeriod(const Parameters::Plan& plan);
/// Steps from plan to plan for a number of groups and characters: fast plans of many groups take turns.
std::int32_t planPeriod(const Parameters::Plan& plan, std::size_t groups, std::size_t characters);

/// Starts, advances and finishes the plans of all groups. The work of a plan is cut into shares, one per
/// step; the rest after the last share goes on in the background until the next step.
class PlanStage {
public:
    /// Allocates memory for the first plans of a new world.
    void reserve(WorldState& state, PlanCosts& costs);

    // Called once in each step, in this order.

    /// Waits until the work of the last step is done.
    void endBackgroundWork(ThreadPool& pool);
    /// Takes the places of groups that go by a field; a new plan is made when places count again.
    void takePlaces(WorldState& state);
    /// Writes places of characters and of `members`, and appends Swap events to `events`.
    void run(WorldState& state, PlanCosts& costs, const WayStage& ways, GroupMembers& members,
             ThreadPool& pool, std::vector<Event>& events);

private:
    void start(const WorldState& state, PlanCosts& costs, const PlannedWays& ways, Group& group,
               const MemberArrays& members);
    void advance(WorldState& state, Group& group, MemberArrays& members, ThreadPool& pool,
                 std::vector<Event>& events);
    void finish(WorldState& state, Group& group, MemberArrays& members, ThreadPool& pool,
                std::vector<Event>& events);
    bool waitsForFirstPlan(const WorldState& state, const Group& group);
    bool goesWithout(WorldState& state, Group& group);
    void findPeriod(const WorldState& state);
    void gatherKnown(const WorldState& state, const Group& group);
    void gatherSlowness(const WorldState& state, const Group& group);
    void findConnected(const WorldState& state, const Group& group, std::span<const Vec2> positions);
    void findClasses(const WorldState& state, Group& group);
    void gatherAmounts(const WorldState& state, const Group& group);
    void launch(ThreadPool& pool);

    std::vector<Assigner*> background_;  // Plans whose work goes on until the next run.
    std::int32_t period_ = 1;            // Steps from plan to plan.
    std::int32_t groups_ = 0;            // Groups with plans,
    std::int32_t groupRank_ = 0;         // and the number of the present one among them.
    std::int32_t firstPlans_ = 0;        // Groups whose first plan is not made, or provisional.
    std::int32_t starts_ = 0;            // Groups whose plans go on from other places than before.
    std::int32_t firstPlanRank_ = 0;     // Number of these groups that came before in this step.
    std::size_t firstCharacters_ = 0;    // Characters whose first plans were made in this step.
    std::uint32_t edits_ = 0;            // Version of the ground in this step, as in PlanInput.
    std::vector<std::uint8_t> without_;  // By group: 1 where its members have no places.
    std::vector<std::uint8_t> connected_;
    std::vector<double> exact_;  // By member of one group: cost to its place by the exact ground [m].
    std::vector<float> known_;   // These costs as in PlanInput [m].
    std::vector<float> slowness_;
    std::vector<std::uint8_t> class_;      // By member of one group; empty without roles.
    std::vector<double> supply_, demand_;  // Amounts of one group; both empty where all are 1.
    std::vector<std::int32_t> incumbent_;  // By member of one group, -1 for none.
    std::vector<std::int32_t> places_;     // By member of one group: its place by the new plan.
    PlanResult result_;
};

}  // namespace muster
