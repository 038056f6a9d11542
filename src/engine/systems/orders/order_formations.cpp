#include "engine/systems/orders/order_formations.h"

#include <algorithm>
#include <cmath>

#include "engine/orders/rim_places.h"
#include "engine/state/ground_class.h"
#include "engine/state/group_edits.h"

namespace muster {
namespace {

/// Formations of ranks and files take up a front of any width; other shapes keep theirs.
void takeWidth(FormationDef& def, double width, std::int32_t count) {
    if (def.kind != FormationKind::Square && def.kind != FormationKind::Line &&
        def.kind != FormationKind::Column)
        return;
    const double files = std::min(1e6, std::floor(width / def.spacing + 1e-9)) + 1.0;
    def.kind = FormationKind::Square;
    def.files = std::clamp(static_cast<std::int32_t>(files), 1, count);
}

/// Gives a group another formation where it stands; it goes on with its order.
void exchangeFormation(WorldState& state, Group& group, const FormationDef& def, ThreadPool& pool) {
    pool.wait();  // Background work reads the plan.
    if (group.orders.march.reversed) {
        Pose pose = group.mesh.pose();
        pose.rotation = {-pose.rotation.c, -pose.rotation.s};
        group.mesh.setPose(pose);
        group.orders.march.reversed = false;
    }
    (void)reformGroup(state, group, def);
    group.orders.march.last = group.mesh.pose();
}

}  // namespace

void restoreOwn(WorldState& state, Group& group, ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    if (!queue.own) return;
    const FormationDef own = *queue.own;
    queue.own.reset();
    queue.stoodAt = state.stepCount;
    exchangeFormation(state, group, own, pool);
}

void takeUpFormation(WorldState& state, Group& group, const Order& order, ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    if (order.kind == OrderKind::Guard) {
        FormationDef rim = group.def.formation;
        if (!queue.own) queue.own = group.def.formation;
        rim.kind = FormationKind::Points;
        rim.outline = {};
        const double spacing = std::max(rim.spacing, 2.1 * state.parameters.character.radius);
        rim.points = rimPlaces(group.def.count, order.halfSize, spacing);
        exchangeFormation(state, group, rim, pool);
        return;
    }
    const bool asked = order.formation || order.width > 0.0;
    if (!asked) return restoreOwn(state, group, pool);
    FormationDef wanted = order.formation ? *order.formation : queue.own ? *queue.own : group.def.formation;
    if (order.width > 0.0) takeWidth(wanted, order.width, group.def.count);
    queue.own.reset();
    if (wanted != group.def.formation) exchangeFormation(state, group, wanted, pool);
}

}  // namespace muster
