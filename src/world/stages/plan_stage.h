// The stage of plans: who goes to which place (SPEC A1 to A3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "cost/dynamic_cost.h"
#include "cost/static_ground.h"
#include "muster/event.h"
#include "planning/plan.h"
#include "world/stages/cost_stage.h"
#include "world/stages/member_arrays.h"
#include "world/state/world_state.h"

namespace muster {

/// Starts, advances and finishes the plans of all groups. Exact plans are cut into shares, one per step; fast
/// plans are made in one step, and part of their work goes on in the background until the next.
class PlanStage {
public:
    /// Prepares what plans read of the ground before the first step.
    void prepare(const WorldState& state);
    /// Allocates memory for the first plans of a new world.
    void reserve(WorldState& state, const DensityField& density);
    /// Writes places of characters, and appends Swap events to `events`.
    void run(WorldState& state, CostStage& cost, ThreadPool& pool, std::vector<Event>& events);

    const StaticGround& ground() const { return ground_; }           ///< What stands still.
    const DynamicCost& dynamicCost() const { return dynamicCost_; }  ///< Of the crowd and moving things.

private:
    void update(const WorldState& state, const DensityField& density);
    void start(const WorldState& state, CostStage& cost, Group& group);
    void finish(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events);
    void findConnected(const WorldState& state, const Group& group);
    void launch(ThreadPool& pool);

    StaticGround ground_;
    DynamicCost dynamicCost_;
    std::vector<Plan*> background_;  // Plans whose work goes on until the next run.
    MemberArrays members_;
    std::vector<std::uint8_t> connected_;
    PlanResult result_;
};

}  // namespace muster
