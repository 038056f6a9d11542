// Groups that stay with another one, or with a character.
#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/orders/turning.h"
#include "engine/state/ground_class.h"
#include "engine/systems/events/standstill.h"
#include "engine/systems/orders/order_stage.h"

namespace muster {
namespace {

constexpr double kLeaderWalkSpeed = 0.3;  // Speed above which a leader faces where it walks [m/s].
constexpr double kFollowTime = 5.0;       // Time after which following ends if another order waits [s].
// Share of the line from the leader to the place beside it between two tests for walls.
constexpr double kSightShare = 0.125;
// Share of the missing distance and turn that is made up for in a second.
constexpr double kCatchUpRate = 1.5;
// Distance that the end of a march may move before the march is made again [m]...
constexpr double kFollowEndMove = 2.0;
constexpr double kFollowEndShare = 0.25;  // ... and the same as a share of the distance to the end.

}  // namespace

void OrderStage::leadByPeople(const WorldState& state, const Group& group, Lead& lead) {
    const Characters& c = state.characters;
    lead.position = middleOf(state, group);
    lead.velocity = {};
    for (const std::int32_t i : group.members)
        lead.velocity += c.velocity[i] / static_cast<double>(group.members.size());
    if (length(lead.velocity) > kLeaderWalkSpeed) lead.facing = normalized(lead.velocity);
}

OrderStage::Lead OrderStage::leadOf(const WorldState& state, const Order& order) {
    Lead lead;
    if (order.character != 0) {
        const Characters& c = state.characters;
        const std::int32_t i = c.indexOf(order.character);
        if (i < 0) return lead;
        return {true, c.position[i], normalized(c.heading[i], {1.0, 0.0}), c.velocity[i]};
    }
    for (const Group& group : state.groups) {
        if (group.id != order.group) continue;
        lead = {true, group.mesh.pose().position, group.orders.march.front(group.mesh.pose()),
                meanVelocity(group)};
        // The places of a group whose members go freely are at the end already: its people lead.
        if (group.orders.goesFree() && !group.members.empty()) leadByPeople(state, group, lead);
    }
    return lead;
}

// The point beside the leader, or as far on the line to it as the leader sees.
Vec2 OrderStage::besideLead(const WorldState& state, const Group& group, const Lead& lead, Vec2 offset) {
    const double radius = groundRadius(state.parameters.character.radius, group.groundClass);
    const Vec2 at = state.environment.def().box.clamp(facingPose(lead.position, lead.facing).apply(offset));
    double share = 1.0;
    while (share > 0.0 &&
           !state.environment.clearStaticLine(lead.position, lerp(lead.position, at, share), radius))
        share -= kSightShare;
    return lerp(lead.position, at, std::max(0.0, share));
}

// One step towards the point beside the leader, along with the leader, so that no place is too fast.
Pose OrderStage::stepBeside(const MarchDef& def, const Pose& pose, const Lead& lead, Vec2 goal, double dt) {
    const Pose along{pose.position + lead.velocity * dt, pose.rotation};
    const Pose next = between(along, facingPose(goal, lead.facing), kCatchUpRate * dt);
    const double far = distance(pose.position, next.position) +
                       def.reach * std::fabs(angleBetween(pose.rotation, next.rotation));
    return between(pose, next, std::min(1.0, def.speed * def.pace * dt / std::max(far, 1e-9)));
}

OrderStage::Outcome OrderStage::follow(WorldState& state, Group& group, const MarchDef& def) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const Order& order = queue.orders.front().order;
    const Lead lead = leadOf(state, order);
    if (!lead.found) return Outcome::Done;
    if (queue.orders.size() > 1 && state.stepCount - queue.begunAt >= stepsIn(state, kFollowTime))
        return Outcome::Done;
    const Pose pose = group.mesh.pose();
    const Vec2 goal = besideLead(state, group, lead, order.offset);
    const double room = def.reach + groundRadius(state.parameters.character.radius, group.groundClass);
    if (state.environment.clearStaticLine(pose.position, goal, room)) {
        // On open ground the formation moves as a whole.
        group.flow.end();
        march.phase = MarchPhase::Idle;
        group.mesh.setPose(stepBeside(def, pose, lead, goal, state.parameters.stepTime));
    } else {
        followAlong(state, group, def, facingPose(goal, lead.facing));
    }
    march.last = group.mesh.pose();
    return Outcome::GoesOn;
}

// Among walls the group marches to where the leader is by now, again and again; a march goes on while the
// route of the next one is searched.
void OrderStage::followAlong(WorldState& state, Group& group, const MarchDef& def, const Pose& end) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const double stale = std::max(kFollowEndMove,
                                  kFollowEndShare * distance(group.mesh.pose().position, end.position));
    if (march.phase == MarchPhase::Idle || distance(queue.target, end.position) > stale) {
        const std::int32_t region = regionOf(state, group);
        const RouteGraph& routes = state.routesOf(group);
        const bool free = region < 0 || routes.region(end.position) == region;
        queue.target = end.position;
        march.searched = 0;
        march.legs.assign(1,
                          free ? end.position : state.routesOf(group).nearestReachable(end.position, region));
        beginWay(state, group, region);
    }
    if (march.phase == MarchPhase::Search && searchWay(state, group, false)) {
        flows_.start(state, group, {march.way.back(), end.rotation}, march.way, false);
        march.phase = MarchPhase::Go;
    }
    if (!group.flow.moves()) return;
    if (!flows_.advance(state, ways_.ground(), group, def)) {
        group.mesh.setPose(end);
        flows_.stand(state, group);
    }
}

}  // namespace muster
