// The stage of orders: it begins the orders of groups, moves their meshes along their routes, and ends them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "engine/state/shared_places.h"
#include "engine/state/world_state.h"
#include "engine/systems/orders/flow_marches.h"
#include "engine/systems/orders/march_pace.h"
#include "engine/systems/orders/mesh_avoidance.h"
#include "engine/systems/orders/order_ways.h"
#include "muster/event.h"

namespace muster {

/// Carries orders out.
class OrderStage {
public:
    /// Takes a new or restored state; call before its first step.
    void reset(const WorldState& state) { ways_.update(state); }
    /// Moves the formations of groups without places to where their people are.
    static void followPeople(WorldState& state, ThreadPool& pool);
    /// One step of all queues; appends what happened to `events`.
    void run(WorldState& state, ThreadPool& pool, std::vector<Event>& events);
    /// The forecast of an order; `from`: the pose that an earlier order would have brought the formation to,
    /// null for its present pose. Changes nothing but caches.
    OrderForecast forecast(WorldState& state, const Group& group, const Order& order,
                           const Pose* from = nullptr);

private:
    /// The pose and velocity of the group or character that a group follows.
    struct Lead {
        bool found = false;
        Vec2 position;
        Vec2 facing{1.0, 0.0};
        Vec2 velocity;
    };
    /// Result of one step of an order.
    enum class Outcome : std::uint8_t { GoesOn, Done, Skipped };

    void runQueue(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events);
    void runGroup(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events);
    void findGoal(WorldState& state, Group& group);
    static bool isClear(const WorldState& state, const Group& group);
    void judgeAgain(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events);
    Outcome begin(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events);
    static void beginWay(WorldState& state, Group& group, std::int32_t region);
    bool staysNear(WorldState& state, Group& group);
    void restart(WorldState& state, Group& group);
    Outcome advance(WorldState& state, Group& group, ThreadPool& pool);
    Pose endPose(const Group& group) const;
    void flow(WorldState& state, Group& group, MarchDef def);
    void beginMarch(WorldState& state, Group& group);
    bool searchWay(WorldState& state, Group& group, bool drawn);
    void goOn(WorldState& state, Group& group, const MarchDef& def);
    static Vec2 besideLead(const WorldState& state, const Group& group, const Lead& lead, Vec2 offset);
    static Pose stepBeside(const MarchDef& def, const Pose& pose, const Lead& lead, Vec2 goal, double dt);
    Outcome follow(WorldState& state, Group& group, const MarchDef& def);
    void followAlong(WorldState& state, Group& group, const MarchDef& def, const Pose& end);
    Outcome guard(WorldState& state, Group& group);
    Outcome gather(WorldState& state, Group& group);
    static Vec2 goalPoint(const WorldState& state, const Order& order, Vec2 from);
    static Outcome beginBare(WorldState& state, Group& group, const Order& order, std::uint32_t id,
                             ThreadPool& pool, std::vector<Event>& events);
    static void goBare(WorldState& state, Group& group, const Order& order, ThreadPool& pool);
    static void endBare(WorldState& state, Group& group, ThreadPool& pool);
    static Outcome goWithout(WorldState& state, Group& group, ThreadPool& pool);
    bool isDone(const WorldState& state, Group& group);
    std::int32_t regionOf(WorldState& state, const Group& group);
    static void leadByPeople(const WorldState& state, const Group& group, Lead& lead);
    static Lead leadOf(const WorldState& state, const Order& order);

    WayFinder ways_;
    MarchPace pace_;
    FlowMarches flows_;
    SharedPlaces shared_;
    MeshAvoidance avoidance_;
    std::uint32_t searching_ = 0;  // Group whose search is under way; 0 for none.
    std::size_t lookedAt_ = 0;     // Groups and characters looked at by the orders that began in this step.
    std::int32_t budget_ = 0;      // Cells that may be searched in this step.
    std::vector<double> speeds_;   // Top speeds of the members of one group.
    std::vector<std::int32_t> regions_;  // Members of one group by region.
};

}  // namespace muster
