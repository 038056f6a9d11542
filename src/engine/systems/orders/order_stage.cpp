#include "engine/systems/orders/order_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/bounds.h"
#include "base/maths.h"
#include "engine/state/bare_groups.h"
#include "engine/state/ground_class.h"
#include "engine/state/group_edits.h"
#include "engine/state/reform.h"
#include "engine/systems/events/standstill.h"
#include "engine/systems/orders/order_formations.h"
#include "engine/systems/orders/premovement.h"
#include "engine/systems/steering/continuum_stage.h"

namespace muster {
namespace {

constexpr std::int32_t kCellsPerStep = 2000;     // Cells that searches for routes may visit in a step.
constexpr std::int64_t kFlowOperations = 60000;  // Operations that plans of marches may take in a step.
// Groups and characters that beginning orders may look at in a step.
constexpr std::size_t kMostLookedAt = 2'000'000;
// Time within kCampReach after which a member is not waited for [s].
constexpr double kCampWait = 20.0;

/// True while fingers hold the mesh, or their trajectories are followed.
bool isHandled(const Group& group) {
    for (const Control& control : group.controls.controls())
        for (const ControlPoint& point : control.points)
            if (point.down || !point.trajectory.empty()) return true;
    return false;
}

bool isContinuum(const Order& order) {
    return order.kind == OrderKind::Move && order.manner == Manner::Continuum;
}

void raise(std::vector<Event>& events, EventKind kind, const Group& group, std::uint32_t value) {
    events.push_back({kind, group.id.value, value, group.mesh.pose().position});
}

/// Raises that `count` members of the group cannot come where the order leads.
void raiseNoPath(std::vector<Event>& events, const Group& group, std::int32_t count) {
    events.push_back({EventKind::NoPath, group.id.value, static_cast<std::uint32_t>(count),
                      group.orders.orders.front().order.target});
}

/// Marks the corners of the route that lie before a share of it as passed.
void passCorners(March& march, double share) {
    double done = share * pathLength(march.way);
    march.next = march.way.empty() ? 0 : 1;
    while (march.next + 1 < march.way.size() &&
           (done -= distance(march.way[march.next - 1], march.way[march.next])) > 0.0)
        ++march.next;
}

/// False for a route so short that it has no direction worth turning to.
bool leadsOn(const Group& group, Vec2 from, Vec2 to) {
    return distance(from, to) > group.def.formation.spacing;
}

/// True where enough members have arrived, or none of the others gets on any more, at least `least` steps
/// after the last member arrived.
template <class There, class Stuck>
bool isOver(const WorldState& state, Group& group, std::uint32_t least, const There& isThere,
            const Stuck& isStuck) {
    OrderQueue& queue = group.orders;
    std::int32_t arrived = 0, awaited = 0;
    bool stuck = true;
    for (const std::int32_t i : group.members) {
        if (!fitsGround(state, group, i)) continue;
        ++awaited;
        if (isThere(i))
            ++arrived;
        else
            stuck = stuck && isStuck(i);
    }
    if (arrived > queue.arrived) {
        queue.arrived = arrived;
        queue.stoodAt = state.stepCount;
    }
    const double share = queue.orders.front().order.share * static_cast<double>(awaited);
    const std::uint32_t quiet = state.stepCount - queue.stoodAt;
    if (quiet >= least && arrived >= static_cast<std::int32_t>(std::ceil(share - 1e-9))) return true;
    return stuck && quiet >= stepsIn(state, kStuckTime);
}

/// After members have joined or left, the middle of the formation follows the route.
void recentre(Group& group) {
    if (!group.refitted) return;
    const bool led = !(group.orders.march.last == group.mesh.pose());
    recentreFormation(group);
    if (!led) group.orders.march.last = group.mesh.pose();
}

}  // namespace

std::int32_t OrderStage::regionOf(WorldState& state, const Group& group) {
    state.refreshRoutes(group.groundClass);
    return mainRegion(state, group, regions_);
}

// Finds the point that the order leads to on the present ground.
void OrderStage::findGoal(WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    const Order& order = queue.orders.front().order;
    queue.target = order.target;
    queue.reachable = true;
    queue.ground = state.groundEdits;
    if (order.kind != OrderKind::Move) return;
    const std::int32_t region = regionOf(state, group);
    const OrderGoal goal = goalOf(state.routesOf(group), region, extentOf(group).width, order.target);
    queue.target = goal.target;
    queue.reachable = goal.reachable;
}

// Judges the order again on changed ground: people hear of a target that cannot be reached any more, and the
// group goes on as if the ground had always been so.
void OrderStage::judgeAgain(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    const bool reachable = queue.reachable;
    const Vec2 target = queue.target;
    const std::int32_t tooLarge = tooLargeFor(state, group);
    updateGroundClass(state, group, pool);
    findGoal(state, group);
    if (reachable && !queue.reachable) raiseNoPath(events, group, group.def.count);
    if (const std::int32_t now = tooLargeFor(state, group); now > tooLarge) raiseNoPath(events, group, now);
    MarchPhase& phase = queue.march.phase;
    const bool same = queue.target == target;
    const bool goesOn = group.flow.moves() ? flows_.goesOn(state, group) : isClear(state, group);
    if (same && goesOn) return;
    // A search that is under way begins again on the present ground.
    if (same && phase == MarchPhase::Search)
        group.flow.end();
    else
        phase = MarchPhase::Idle;
}

// True where the rest of the route is free.
bool OrderStage::isClear(const WorldState& state, const Group& group) {
    const double radius = groundRadius(state.parameters.character.radius, group.groundClass);
    Vec2 from = group.mesh.pose().position;
    for (const Vec2 corner : group.orders.march.ahead()) {
        if (!state.environment.clearStaticLine(from, corner, radius)) return false;
        from = corner;
    }
    return true;
}

OrderStage::Outcome OrderStage::begin(WorldState& state, Group& group, ThreadPool& pool,
                                      std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    const Order order = queue.orders.front().order;
    const std::uint32_t id = queue.orders.front().id;
    if (isBare(order.kind)) return beginBare(state, group, order, id, pool, events);
    endBare(state, group, pool);
    updateGroundClass(state, group, pool);
    findGoal(state, group);
    if (!queue.reachable && queue.orders.size() > 1) return Outcome::Skipped;
    queue.begun = true;
    queue.begunAt = queue.stoodAt = state.stepCount;
    queue.arrived = 0;
    queue.march.phase = MarchPhase::Idle;
    group.controls.clear();
    if (isContinuum(order))
        state.continuum.begin(group.id, queue.target);
    else
        state.continuum.end(group.id);
    takeUpFormation(state, group, order, pool);
    // A ring may stand round a tree where a square could not.
    if (order.formation) findGoal(state, group);
    group.order.begin(state.stepCount);
    raise(events, EventKind::OrderBegun, group, id);
    if (!queue.reachable)
        raiseNoPath(events, group, group.def.count);
    else if (const std::int32_t tooLarge = tooLargeFor(state, group); tooLarge > 0)
        raiseNoPath(events, group, tooLarge);
    return Outcome::GoesOn;
}

// The pose at the end of the route: as ordered, or facing along the route.
Pose OrderStage::endPose(const Group& group) const {
    const OrderQueue& queue = group.orders;
    const March& march = queue.march;
    const Order& order = queue.orders.front().order;
    const Pose now = group.mesh.pose();
    const Vec2 at = order.kind == OrderKind::Face ? now.position : queue.target;
    Vec2 front = march.front(now);
    if (order.facing)
        front = {cosine(*order.facing), sine(*order.facing)};
    else if (order.turn != Turn::Keep && march.way.size() > 1 && leadsOn(group, now.position, at))
        front = normalized(march.way.back() - march.way[march.way.size() - 2], front);
    return facingPose(at, front);
}

// Begins the route at the mesh. A formation that surrounds a building leaves it on the side of the target.
void OrderStage::beginWay(WorldState& state, Group& group, std::int32_t region) {
    March& march = group.orders.march;
    const Vec2 middle = group.mesh.pose().position;
    march.way.assign(1, middle);
    march.next = 1;
    march.phase = MarchPhase::Search;
    if (region < 0 || march.legs.empty() || state.routesOf(group).region(middle) == region) return;
    const Vec2 to = march.legs.front();
    const std::vector<Vec2>& places = group.places.positions();
    const auto nearest = std::min_element(places.begin(), places.end(), [&](Vec2 a, Vec2 b) {
        return lengthSquared(a - to) < lengthSquared(b - to);
    });
    if (nearest != places.end()) march.way.push_back(*nearest);
}

// True where the target cannot be reached and the group already stands, or goes, about as near to it as it
// can.
bool OrderStage::staysNear(WorldState& state, Group& group) {
    const OrderQueue& queue = group.orders;
    const Order& order = queue.orders.front().order;
    if (queue.reachable || order.kind != OrderKind::Move || !order.route.empty()) return false;
    return !flows_.pays(state, group, queue.target, order.facing);
}

// Begins the route from where the mesh is.
void OrderStage::restart(WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const Order& order = queue.orders.front().order;
    const Pose pose = group.mesh.pose();
    march.last = pose;
    march.searched = 0;
    if (staysNear(state, group)) {
        march.phase = group.flow.moves() ? MarchPhase::Go : MarchPhase::Stand;
        queue.stoodAt = state.stepCount;
        return;
    }
    // The present march goes on while the route of the next one is searched.
    const bool goesOn = order.kind == OrderKind::Move && order.manner == Manner::March &&
                        group.flow.moves() && group.flow.version == group.formationVersion &&
                        group.flow.ground == state.groundEdits;
    if (!goesOn) group.flow.end();
    if (order.kind == OrderKind::Face) {
        march.way.assign(2, pose.position);
        march.next = 1;
        beginMarch(state, group);
        return;
    }
    if (order.kind != OrderKind::Move) return;
    if (order.manner == Manner::Free && order.route.empty()) {
        const Vec2 middle = middleOf(state, group);
        Vec2 front = march.front(pose);
        if (leadsOn(group, middle, queue.target)) front = normalized(queue.target - middle, front);
        if (order.facing) front = {cosine(*order.facing), sine(*order.facing)};
        march.reversed = false;
        group.mesh.setPose(facingPose(queue.target, front));
        flows_.stand(state, group);
        march.last = group.mesh.pose();
        march.phase = MarchPhase::Stand;
        queue.stoodAt = state.stepCount;
        return;
    }
    const std::int32_t region = regionOf(state, group);
    const OrderGoal goal = goalOf(state.routesOf(group), region, extentOf(group).width, order.target);
    listLegs(state.routesOf(group), region, order, goal, march.legs);
    beginWay(state, group, region);
}

// Searches the route of a group. One group searches at a time until its route is found, since a search that
// another one interrupts starts again.
bool OrderStage::searchWay(WorldState& state, Group& group, bool drawn) {
    if (budget_ <= 0) return false;
    const std::int32_t region = regionOf(state, group);
    March& march = group.orders.march;
    const bool busy = searching_ != 0 && searching_ != group.id.value;
    const WayNeeds needs = needsOf(state, group, group.orders.orders.front().order);
    const bool whole = ways_.advance(state, state.routesOf(group), region, drawn, needs, busy, march,
                                     budget_);
    if (!busy) searching_ = march.searched > 0 ? group.id.value : 0;
    return whole;
}

// Begins a march: in one piece where the formation is to turn as a whole, else one that flows.
void OrderStage::beginMarch(WorldState& state, Group& group) {
    March& march = group.orders.march;
    const Order& order = group.orders.orders.front().order;
    const bool free = order.manner == Manner::Free;
    const Pose end = endPose(group);
    // A group that may not narrow keeps to its route, which was searched for its width.
    const bool kept = !order.route.empty() || group.def.conduct.squeeze < 1.0;
    march.phase = MarchPhase::Go;
    if (order.turn == Turn::Flow && !free) {
        const bool stays = order.kind == OrderKind::Face;
        flows_.start(state, group, end, stays ? std::span<const Vec2>() : march.way, kept);
        return;
    }
    PieceDef piece{group.mesh.pose(), march.way, order.turn, order.facing, extentOf(group).reach};
    if (free) {
        piece.turn = Turn::Keep;
        piece.facing = arcTangent2(end.rotation.s, end.rotation.c);
    }
    flows_.startPiece(state, group, piece, kept);
}

void OrderStage::goOn(WorldState& state, Group& group, const MarchDef& def) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const Order& order = queue.orders.front().order;
    if (march.phase == MarchPhase::Search && searchWay(state, group, !order.route.empty())) {
        if (!(march.way.back() == queue.target)) march.way.push_back(queue.target);
        beginMarch(state, group);
    }
    // The march before this one goes on while the route is searched.
    if (march.phase != MarchPhase::Search)
        flow(state, group, def);
    else if (group.flow.moves())
        flows_.advance(state, ways_.ground(), group, def);
    march.last = group.mesh.pose();
}

void OrderStage::flow(WorldState& state, Group& group, MarchDef def) {
    March& march = group.orders.march;
    if (march.phase != MarchPhase::Go) return;
    Vec2 offCourse;
    if (group.flow.phase == FlowPhase::Flowing &&
        (group.def.conduct.avoids || !(group.avoidance.offCourse == Vec2{})))
        offCourse = avoidance_.advance(state, ways_.ground(), def, group);
    if (group.flow.leads() && flows_.advance(state, ways_.ground(), group, def, offCourse)) {
        passCorners(march, group.flow.q);
        // The members that are left after a loss form up again.
        if (group.flow.phase == FlowPhase::Standing)
            march.phase = group.flow.kept.empty() ? MarchPhase::Stand : MarchPhase::Idle;
        return;
    }
    // Where no march is possible every member goes to the end on its own.
    group.mesh.setPose(endPose(group));
    flows_.stand(state, group);
    march.phase = MarchPhase::Stand;
}

bool OrderStage::isDone(const WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    if (queue.march.phase != MarchPhase::Stand) {
        queue.stoodAt = state.stepCount;
        return false;
    }
    const Characters& c = state.characters;
    const std::uint32_t patience = stepsIn(state, kStuckTime), longest = stepsIn(state, kCampWait);
    shared_.find(state, group);
    const auto isThere = [&](std::int32_t i) {
        const std::int32_t place = c.place[i];
        return place >= 0 && distance(c.position[i], group.places.reachableTargets()[place]) <=
                                 kArrivedReach + shared_.room(i);
    };
    const auto isStuck = [&](std::int32_t i) {
        return state.stepCount - c.walk[i].movedAt >= patience ||
               state.stepCount - c.walk[i].campedAt >= longest;
    };
    // One step of patience, since targets follow the mesh in this step.
    return isOver(state, group, 2, isThere, isStuck);
}

OrderStage::Outcome OrderStage::guard(WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    group.flow.end();
    const Order& order = queue.orders.front().order;
    Vec2 centre = order.target;
    const double facing = order.facing.value_or(0.0);
    Vec2 front{cosine(facing), sine(facing)};
    if (order.group || order.character != 0) {
        const Lead lead = leadOf(state, order);
        if (!lead.found) return Outcome::Done;
        centre = facingPose(lead.position, lead.facing).apply(order.offset);
        front = lead.facing;
    } else if (!order.path.still()) {
        const Waypoint at = order.path.at((state.stepCount - queue.begunAt) * state.parameters.stepTime);
        centre += at.position;
        front = {cosine(facing + at.angle), sine(facing + at.angle)};
    }
    centre = state.environment.def().box.clamp(centre);
    queue.target = centre;
    queue.march.phase = MarchPhase::Stand;
    queue.march.reversed = false;
    group.mesh.setPose(facingPose(centre, front));
    queue.march.last = group.mesh.pose();
    return queue.orders.size() > 1 && isDone(state, group) ? Outcome::Done : Outcome::GoesOn;
}

// All members go to the target itself. The order is done once enough have come near, or nobody gets on any
// more; with the last order the members behind still go on to the target.
OrderStage::Outcome OrderStage::gather(WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    group.flow.end();
    queue.march.phase = MarchPhase::Stand;
    queue.march.last = group.mesh.pose();
    const Gathering* gathering = state.continuum.find(group.id);
    // Fingers have given the group its places back in the meantime.
    if (gathering == nullptr || !gathering->active) state.continuum.begin(group.id, queue.target);
    gathering = state.continuum.find(group.id);
    const Characters& c = state.characters;
    const double reach = gatheringReach(group.members.size(), state.parameters.character.radius);
    const std::uint32_t patience = stepsIn(state, kStuckTime);
    const auto isThere = [&](std::int32_t i) {
        return distance(c.position[i], queue.target) <= reach || gathering->hasArrived(c.id[i]);
    };
    const auto isStuck = [&](std::int32_t i) { return state.stepCount - c.walk[i].movedAt >= patience; };
    return isOver(state, group, 0, isThere, isStuck) ? Outcome::Done : Outcome::GoesOn;
}

// Moves the formation of a group without places with its people, so that fingers can take it there.
void OrderStage::followPeople(WorldState& state, ThreadPool& pool) {
    for (const Gathering& gathering : state.continuum.gatherings) {
        Group* const group = state.findGroup(gathering.group);
        if (group == nullptr || !gathering.isBare() || !isHandled(*group)) continue;
        pool.wait();
        formUp(state, *group);
    }
    std::erase_if(state.continuum.gatherings, [&](const Gathering& gathering) {
        const Group* const group = state.findGroup(gathering.group);
        return group == nullptr || isHandled(*group);
    });
    for (const Gathering& gathering : state.continuum.gatherings) {
        Group& group = *state.findGroup(gathering.group);
        if (group.members.empty()) continue;
        Pose pose = group.mesh.pose();
        pose.position = middleOf(state, group);
        group.mesh.setPose(pose);
    }
}

OrderStage::Outcome OrderStage::advance(WorldState& state, Group& group, ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    const Order& order = queue.orders.front().order;
    if (order.kind == OrderKind::Guard) return guard(state, group);
    if (isContinuum(order)) return gather(state, group);
    if (isBare(order.kind)) return goWithout(state, group, pool);
    const FormationExtent extent = extentOf(group);
    MarchDef def = marchDefOf(state, group, order, extent, speeds_);
    // A free group waits for no member on a drawn route.
    if (order.manner != Manner::Free) def.pace = pace_.of(state, group);
    if (order.kind == OrderKind::Follow) return follow(state, group, def);
    // Fingers have led the group away: it goes on from where it is.
    const bool lost = queue.march.phase == MarchPhase::Go && !group.flow.leads();
    if (queue.march.phase == MarchPhase::Idle || lost || !(queue.march.last == group.mesh.pose()))
        restart(state, group);
    goOn(state, group, def);
    if (!isDone(state, group)) return Outcome::GoesOn;
    return queue.reachable ? Outcome::Done : Outcome::Skipped;
}

void OrderStage::runGroup(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    // Each order of the queue ends at most once in a step.
    for (std::size_t left = queue.orders.size(); left > 0 && !queue.orders.empty(); --left) {
        Outcome outcome = queue.begun ? Outcome::GoesOn : begin(state, group, pool, events);
        if (outcome == Outcome::GoesOn) {
            if (!group.controls.controls().empty()) group.controls.clear();
            recentre(group);
            const bool bare = isBare(queue.orders.front().order.kind);
            if (!bare && queue.ground != state.groundEdits) judgeAgain(state, group, pool, events);
            outcome = advance(state, group, pool);
        }
        if (outcome == Outcome::GoesOn) return;
        const QueuedOrder done = queue.orders.front();
        raise(events, outcome == Outcome::Done ? EventKind::OrderDone : EventKind::OrderSkipped, group,
              done.id);
        if (outcome == Outcome::Skipped) group.order.arrival = ArrivalWatch::Raised;  // NoPath was raised.
        queue.end();
        queue.orders.erase(queue.orders.begin());
        if (queue.patrols) queue.orders.push_back(done);
        if (outcome == Outcome::Done && queue.patrols && queue.orders.size() == 1) return;
    }
}

void OrderStage::run(WorldState& state, ThreadPool& pool, std::vector<Event>& events) {
    // A step that divides a group searches no routes, as it has enough work.
    const bool divided = std::any_of(events.begin(), events.end(),
                                     [](const Event& event) { return event.kind == EventKind::GroupAdded; });
    budget_ = divided ? 0 : kCellsPerStep;
    flows_.begin(kFlowOperations);
    ways_.update(state);
    avoidance_.begin();
    searching_ = 0;
    lookedAt_ = 0;
    for (const Group& group : state.groups) {
        const OrderQueue& queue = group.orders;
        const bool searches = !queue.orders.empty() && queue.march.phase == MarchPhase::Search &&
                              queue.march.searched > 0 && !queue.held && !isHandled(group) &&
                              !group.members.empty();
        if (searches && searching_ == 0) searching_ = group.id.value;
    }
    hearOrders(state);
    for (Group& group : state.groups) runQueue(state, group, pool, events);
}

void OrderStage::runQueue(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    const bool led = group.flow.version != group.formationVersion || isHandled(group) ||
                     !(queue.march.last == group.mesh.pose());
    // On changed ground the places of a standing group are laid out again, except after an order to stop.
    const bool stale = queue.orders.empty() && group.flow.ground != state.groundEdits;
    if (group.flow.leads() && (led || (stale && !group.flow.isStop()))) group.flow.end();
    if (queue.orders.empty()) {
        if (state.continuum.isBare(group.id)) return;
        if (queue.own && !isHandled(group) && !group.flow.isStop()) restoreOwn(state, group, pool);
        if (!isHandled(group)) flows_.settle(state, group);
        return;
    }
    if (queue.held || isHandled(group) || group.members.empty()) return;
    // A group that begins an order looks at all others, so that of very many groups some begin in later
    // steps.
    if (!queue.begun || queue.march.phase == MarchPhase::Idle) {
        const std::size_t all = state.groups.size() + state.characters.size();
        if (lookedAt_ > 0 && lookedAt_ + all > kMostLookedAt) return;
        lookedAt_ += all;
    }
    runGroup(state, group, pool, events);
}

OrderForecast OrderStage::forecast(WorldState& state, const Group& group, const Order& order,
                                   const Pose* from) {
    ways_.update(state);
    OrderForecast forecast;
    Order asked = order;
    if (order.group || order.character != 0) asked.target = leadOf(state, order).position;
    const Pose pose = from != nullptr ? *from : group.mesh.pose();
    const std::int32_t region = regionOf(state, group);
    const FormationExtent extent = extentOf(group);
    if (asked.kind == OrderKind::Face) asked.target = pose.position;
    if (isBare(asked.kind)) asked.target = goalPoint(state, asked, pose.position);
    RouteGraph& routes = state.refreshRoutes(group.groundClass);
    const OrderGoal goal = goalOf(routes, region, extent.width, asked.target);
    March march;
    march.reversed = from == nullptr && group.orders.march.reversed;
    march.way.assign(1, pose.position);
    listLegs(routes, region, asked, goal, march.legs);
    std::int32_t budget = state.environment.grid().count() + 1;
    // Runs a search that is under way again, up to where it was.
    while (!ways_.advance(state, routes, region, !asked.route.empty(), needsOf(state, group, asked), false,
                          march, budget))
        budget = state.environment.grid().count() + 1;
    if (!(march.way.back() == goal.target)) march.way.push_back(goal.target);
    forecast.arrives = goal.reachable;
    forecast.end = goal.target;
    forecast.way = march.way;
    const MarchDef def = marchDefOf(state, group, asked, extent, speeds_);
    const auto facing = asked.manner == Manner::Free ? std::nullopt : asked.facing;
    const double slower = slowGround(state.environment, march.way,
                                     asked.manner == Manner::Free ? 0.0 : extent.depth);
    forecast.seconds = goal.reachable
                           ? marchTime(def, march.way, march.front(pose), facing) + slower / def.speed
                           : std::numeric_limits<double>::infinity();
    return forecast;
}

}  // namespace muster
