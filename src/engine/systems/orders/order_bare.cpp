// Orders that members carry out without a formation (docs/method/goals.md).
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bounds.h"
#include "base/maths.h"
#include "engine/state/bare_groups.h"
#include "engine/systems/events/standstill.h"
#include "engine/systems/orders/order_stage.h"

namespace muster {
namespace {

/// True for a member that stands in its waiting area, or before it.
bool waits(const WorldState& state, const Gathering& gathering, std::int32_t i) {
    const Characters& c = state.characters;
    const StandingSpot* const spot = gathering.spotOf(c.id[i]);
    return spot != nullptr ? distance(c.position[i], spot->spot) <= kArrivedReach
                           : gathering.hasArrived(c.id[i]);
}

}  // namespace

// The point to which an order without places leads: the middle of the waiting area or of the nearest exit, or
// the side of the ground.
Vec2 OrderStage::goalPoint(const WorldState& state, const Order& order, Vec2 from) {
    const Box box = state.environment.def().box;
    if (order.kind == OrderKind::Walk) {
        const double facing = order.facing.value_or(0.0);
        return box.clamp(from + Vec2{cosine(facing), sine(facing)} * (box.width() + box.height()));
    }
    Vec2 best = from;
    double least = std::numeric_limits<double>::infinity();
    for (const Area& area : state.areas) {
        const bool named = order.kind == OrderKind::Wait
                               ? area.id == order.area
                               : area.def.kind == AreaKind::Exit && isOpen(area.def, state.time()) &&
                                     (order.exits.empty() || std::find(order.exits.begin(), order.exits.end(),
                                                                       area.id) != order.exits.end());
        const Vec2 middle = meanOf(area.def.polygon);
        if (!named || distance(middle, from) >= least) continue;
        least = distance(middle, from);
        best = middle;
    }
    return best;
}

// Begins an order to go to areas, for which members need no formation.
OrderStage::Outcome OrderStage::beginBare(WorldState& state, Group& group, const Order& order,
                                          std::uint32_t id, ThreadPool& pool, std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    if (order.kind == OrderKind::Wait && queue.orders.size() > 1 && state.findArea(order.area) == nullptr) {
        events.push_back({EventKind::NoPath, group.id.value, static_cast<std::uint32_t>(group.def.count),
                          group.mesh.pose().position});
        return Outcome::Skipped;
    }
    queue.begun = true;
    queue.begunAt = queue.stoodAt = state.stepCount;
    queue.arrived = 0;
    queue.reachable = true;
    queue.ground = state.groundEdits;
    group.controls.clear();
    if (order.formation) group.def.formation = *order.formation;
    goBare(state, group, order, pool);
    group.order.begin(state.stepCount);
    events.push_back({EventKind::OrderBegun, group.id.value, id, group.mesh.pose().position});
    return Outcome::GoesOn;
}

void OrderStage::goBare(WorldState& state, Group& group, const Order& order, ThreadPool& pool) {
    pool.wait();  // Background work reads the plan.
    if (!state.continuum.isBare(group.id)) dissolveFormation(state, group);
    state.continuum.begin(group.id, order.kind, order.area);
}

// Gives a group without a formation one again, for an order that needs places.
void OrderStage::endBare(WorldState& state, Group& group, ThreadPool& pool) {
    if (!state.continuum.isBare(group.id)) return;
    pool.wait();
    formUp(state, group);
    state.continuum.end(group.id);
}

// Members go to areas, or on, without end; a group that waits does so for a while after enough members have
// come.
OrderStage::Outcome OrderStage::goWithout(WorldState& state, Group& group, ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    const Order& order = queue.orders.front().order;
    queue.march.phase = MarchPhase::Stand;
    queue.march.last = group.mesh.pose();
    queue.ground = state.groundEdits;
    Gathering* gathering = state.continuum.find(group.id);
    // Fingers have given the group its formation back in the meantime.
    if (gathering == nullptr || !gathering->active || gathering->kind != order.kind)
        goBare(state, group, order, pool);
    if (order.kind != OrderKind::Wait) return Outcome::GoesOn;
    gathering = state.continuum.find(group.id);
    if (queue.orders.size() > 1 && state.findArea(order.area) == nullptr) return Outcome::Skipped;
    const double share = order.share * static_cast<double>(group.members.size());
    const auto come = static_cast<double>(
        std::count_if(group.members.begin(), group.members.end(),
                      [&](std::int32_t i) { return waits(state, *gathering, i); }));
    if (gathering->since == 0 && come >= std::ceil(share - 1e-9))
        gathering->since = std::max(1u, state.stepCount);
    const bool over = gathering->since > 0 && order.seconds > 0.0 &&
                      state.stepCount - gathering->since >= stepsIn(state, order.seconds);
    return over ? Outcome::Done : Outcome::GoesOn;
}

}  // namespace muster
