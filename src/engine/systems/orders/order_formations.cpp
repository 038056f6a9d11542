#include "engine/systems/orders/order_formations.h"

#include <algorithm>
#include <cmath>

#include "engine/orders/rim_places.h"
#include "engine/state/ground_class.h"
#include "engine/state/group_edits.h"

namespace muster {
namespace {

constexpr double kBeside = 0.1;              // Between bodies and walls of a passage [m].
constexpr double kTight = 0.5;               // Passages narrower by so much are wide enough [m].
constexpr double kPassagesAhead = 8.0;       // For passages [m].
constexpr std::uint32_t kSqueezeEvery = 10;  // Steps between looks for passages,
constexpr std::uint32_t kWidenEvery = 120;   // and between those that widen a formation again.

bool isSame(const FormationDef& a, const FormationDef& b) {
    return a.kind == b.kind && a.spacing == b.spacing && a.opening == b.opening && a.files == b.files &&
           a.points == b.points && a.outline.outline == b.outline.outline &&
           a.outline.holes == b.outline.holes;
}

/// Square, line or column: how many stand abreast.
std::int32_t filesOf(const FormationDef& def, std::int32_t count, double width) {
    if (def.kind == FormationKind::Square && def.files > 0) return std::min(def.files, count);
    return std::clamp(static_cast<std::int32_t>(std::floor(2.0 * width / def.spacing + 0.5)) + 1, 1, count);
}

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
    queue.files = 0;
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
    queue.files = 0;
    if (!isSame(wanted, group.def.formation)) exchangeFormation(state, group, wanted, pool);
}

void squeeze(WorldState& state, Group& group, const FormationExtent& extent, WayFinder& ways,
             ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    const March& march = queue.march;
    const double share = group.def.conduct.squeeze;
    if (queue.files > 0 && march.phase > MarchPhase::Go) return restoreOwn(state, group, pool);
    if (share <= 0.0 || march.phase != MarchPhase::Go || state.stepCount % kSqueezeEvery != 0 ||
        group.def.count < 2)
        return;
    const Vec2 ahead = normalized(march.way[march.next] - group.mesh.pose().position);
    if (dot(ahead, march.front(group.mesh.pose())) < 0.7) return;
    const FormationDef own = queue.own ? *queue.own : group.def.formation;
    const double radius = groundRadius(state.parameters.character.radius, group.groundClass);
    const double spacing = group.def.formation.spacing;
    if (queue.files == 0) queue.clearOf = extent.width;
    const double full = 2.0 * (queue.clearOf + radius + kBeside);
    const double room = ways.narrowest(march, group.mesh.pose().position, extent.depth + 1.0,
                                       extent.depth + kPassagesAhead, full);
    const std::int32_t most = filesOf(own, group.def.count, queue.clearOf);
    const auto least = std::clamp(static_cast<std::int32_t>(std::ceil(most * (1.0 - share) - 1e-9)), 1, most);
    const double inner = std::max(0.0, room - 2.0 * (radius + kBeside));
    const auto fit = static_cast<std::int32_t>(std::floor(inner / spacing + 1e-9)) + 1;
    const std::int32_t files = room >= full - kTight ? most : std::clamp(fit, least, most);
    const std::int32_t now = queue.files > 0 ? queue.files : most;
    if (files == now || (files > now && state.stepCount % kWidenEvery != 0)) return;
    if (files == most) return restoreOwn(state, group, pool);
    FormationDef narrow = own;
    narrow.kind = FormationKind::Square;
    narrow.outline = {};
    narrow.points.clear();
    narrow.files = files;
    queue.own = own;
    queue.files = files;
    exchangeFormation(state, group, narrow, pool);
}

}  // namespace muster
