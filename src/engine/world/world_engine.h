// The engine behind World: its state, the memory of each stage, and the reports of the last step.
#pragma once

#include <memory>
#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "engine/systems/events/event_stage.h"
#include "engine/systems/events/patch_stage.h"
#include "engine/systems/fields/cost_stage.h"
#include "engine/systems/goals/area_stage.h"
#include "engine/systems/orders/order_stage.h"
#include "engine/systems/passages/way_stage.h"
#include "engine/systems/places/place_stage.h"
#include "engine/systems/plans/plan_stage.h"
#include "engine/systems/steering/contact_stage.h"
#include "engine/systems/steering/steering_stage.h"
#include "muster/world.h"

namespace muster {

/// A world. All members but `state` can be dropped without changing a later bit.
struct WorldEngine {
    WorldState state;

    std::vector<Event> events;          ///< Events of the last step.
    std::vector<Rejection> rejections;  ///< Rejections of the last step.
    ContactReport contactReport;        ///< Contacts after the last step.
    StageTimes times;                   ///< Times of the last step.
    std::int32_t move = 0;              ///< Index of the move that is being made, from 0.

    AreaStage areas;
    OrderStage orders;
    PlaceStage places;
    CostStage cost;
    WayStage ways;
    GroupMembers members;
    PlanStage plans;
    SteeringStage steering;
    ContactStage contacts;
    PatchStage patches;
    EventStage happenings;

    /// Declared last: its destructor waits for background work, which reads the members above.
    std::unique_ptr<ThreadPool> pool;

    /// Makes one time step (step.cpp).
    void step();
    /// Length of the moves into which a step is divided [s].
    double moveTime() const {
        const double stepTime = state.parameters.stepTime;
        return stepTime / movesOf(stepTime);
    }
    /// Prepares to go on from a state that was just read, with the memory that the stages have. No background
    /// work may be running.
    void goOnFromState() {
        orders.reset(state);
        cost.reset(state);
        ways.reset(state);
        steering.reset();
        for (const Group& group : state.groups) group.plan->bind(cost.ofClass(group.groundClass));
        events.clear();
        rejections.clear();
        contactReport = {};
    }
    /// Waits for background work, which writes parts of the state.
    void finishBackgroundWork() const { pool->wait(); }
};

/// Lets Muster's own code into a world.
struct WorldAccess {
    static WorldEngine& of(const World& world) { return *world.engine_; }  ///< The whole engine of a world.
};

}  // namespace muster
