#include "world/stages/order_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "orders/rim_places.h"
#include "world/stages/standstill.h"
#include "world/state/ground_class.h"
#include "world/state/group_edits.h"
#include "world/state/reform.h"

namespace muster {
namespace {

constexpr std::int32_t kCellsPerStep = 1000;  // Of searches for ways.
constexpr double kLagFree = 0.6;              // The mesh does not wait for lags below [m]...
constexpr double kLagMost = 2.0;              // ... and stands for those above [m].
constexpr double kLagShare = 0.95;            // Of the group, whose lag counts.
constexpr double kWaitedFor = 5.0;            // Who has not got on for so long is not waited for [s].
constexpr double kLongest = 20.0;             // Nor who has moved to and fro on one spot for so long [s].
constexpr double kShifted = 1.5;              // Places so far off the formation are not waited for [m].
constexpr double kWaits = 0.2;                // At a pace below it waits.
constexpr double kWaitsFor = 10.0;            // From here on, and to twice that, it begins to go on [s]...
constexpr double kCreeps = 0.3;               // ... at this pace.
constexpr double kSoonDone = 5.0;             // Following ends so soon where another order waits [s].
constexpr double kBeside = 0.1;               // Between bodies and walls of a passage [m].
constexpr double kTight = 0.5;                // Passages narrower by so much are wide enough [m].
constexpr double kPassagesAhead = 8.0;        // For passages [m].
constexpr std::uint32_t kSqueezeEvery = 10;   // Steps between looks for passages,
constexpr std::uint32_t kWidenEvery = 120;    // and between those that widen a formation again.

/// True while fingers hold the mesh, or their ways are followed.
bool isHandled(const Group& group) {
    for (const Control& control : group.controls.controls())
        for (const ControlPoint& point : control.points)
            if (point.down || !point.trajectory.empty()) return true;
    return false;
}

Pose facingPose(Vec2 position, Vec2 front) {
    return {position, {front.x, front.y}};
}

bool samePose(const Pose& a, const Pose& b) {
    return a.position == b.position && a.rotation.c == b.rotation.c && a.rotation.s == b.rotation.s;
}

void raise(std::vector<Event>& events, EventKind kind, const Group& group, std::uint32_t value) {
    events.push_back({kind, group.id.value, value, group.mesh.pose().position});
}

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

/// Where somebody has joined or left, the middle of the formation goes the way.
void recentre(Group& group) {
    if (!group.refitted) return;
    const bool led = !samePose(group.orders.march.last, group.mesh.pose());
    recentreFormation(group);
    if (!led) group.orders.march.last = group.mesh.pose();
}

/// A march that has waited for long creeps on, so that no order lasts for ever.
double patientPace(March& march, double pace, double dt) {
    march.waited = pace < kWaits ? march.waited + dt : std::max(0.0, march.waited - 2.0 * dt);
    return std::max(pace, kCreeps * std::clamp((march.waited - kWaitsFor) / kWaitsFor, 0.0, 1.0));
}

/// Takes up its own formation again.
void restoreOwn(WorldState& state, Group& group, ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    if (!queue.own) return;
    const FormationDef own = *queue.own;
    queue.own.reset();
    queue.files = 0;
    queue.stoodAt = state.stepCount;
    exchangeFormation(state, group, own, pool);
}

}  // namespace

std::int32_t OrderStage::regionOf(WorldState& state, const Group& group) {
    state.refreshRoutes(group.groundClass);
    return mainRegion(state, group, regions_);
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
        lead = {true, group.mesh.pose().position, group.orders.march.front(group.mesh.pose()), {}};
        for (const Vec2 v : group.places.velocities()) lead.velocity += v;
        if (!group.places.velocities().empty())
            lead.velocity = lead.velocity / static_cast<double>(group.places.velocities().size());
    }
    return lead;
}

// By the lag of the last but a few, without those who do not get on, and those whose places had to leave the
// formation.
double OrderStage::paceOf(const WorldState& state, const Group& group) {
    if (!state.parameters.opposing.enabled) return 1.0;
    const Characters& c = state.characters;
    const std::uint32_t patience = stepsIn(state, kWaitedFor);
    lags_.clear();
    for (const std::int32_t i : group.members) {
        if (c.place[i] < 0 || c.driver[i] != Driver::Muster) continue;
        const Vec2 target = group.places.reachableTargets()[c.place[i]];
        const double lag = distance(c.position[i], target);
        if (lag > kLagFree && distance(target, group.places.targetsWithinReach()[c.place[i]]) > kShifted)
            continue;
        if (lag <= kLagFree || state.stepCount - c.walk[i].movedAt < patience) lags_.push_back(lag);
    }
    if (lags_.empty()) return 1.0;
    const auto at = lags_.begin() +
                    static_cast<std::ptrdiff_t>(kLagShare * static_cast<double>(lags_.size() - 1));
    std::nth_element(lags_.begin(), at, lags_.end());
    return std::clamp((kLagMost - *at) / (kLagMost - kLagFree), 0.0, 1.0);
}

void OrderStage::takeUpFormation(WorldState& state, Group& group, const Order& order, ThreadPool& pool) {
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

OrderStage::Outcome OrderStage::begin(WorldState& state, Group& group, ThreadPool& pool,
                                      std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    const Order order = queue.orders.front().order;
    const std::uint32_t id = queue.orders.front().id;
    queue.target = order.target;
    queue.reachable = true;
    if (order.kind == OrderKind::Move) {
        const std::int32_t region = regionOf(state, group);
        const OrderGoal goal = goalOf(state.routesOf(group), region, extentOf(group).width, order.target);
        queue.target = goal.target;
        queue.reachable = goal.reachable;
        const bool last = queue.orders.size() == 1;
        if (!goal.reachable && !last) return Outcome::Skipped;
    }
    queue.begun = true;
    queue.begunAt = queue.stoodAt = state.stepCount;
    queue.arrived = 0;
    queue.march.phase = MarchPhase::Idle;
    group.avoidance = {};
    group.controls.clear();
    takeUpFormation(state, group, order, pool);
    group.order.begin(state.stepCount);
    raise(events, EventKind::OrderBegun, group, id);
    if (!queue.reachable)
        events.push_back(
            {EventKind::NoPath, group.id.value, static_cast<std::uint32_t>(group.def.count), order.target});
    return Outcome::GoesOn;
}

// Begins the way from where the mesh is.
void OrderStage::restart(WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const Order& order = queue.orders.front().order;
    const Pose pose = group.mesh.pose();
    march.last = pose;
    march.searched = 0;
    march.facing = order.facing.value_or(0.0);
    march.turns = order.facing.has_value();
    if (order.kind == OrderKind::Face) {
        march.phase = MarchPhase::Turn;
        return;
    }
    if (order.kind != OrderKind::Move) return;
    if (order.manner == Manner::Free && order.route.empty()) {
        Vec2 middle;
        for (const std::int32_t i : group.members) middle += state.characters.position[i];
        middle = middle / std::max(1.0, static_cast<double>(group.members.size()));
        Vec2 front = normalized(queue.target - middle, march.front(pose));
        if (order.facing) front = {cosine(*order.facing), sine(*order.facing)};
        march.reversed = false;
        group.mesh.setPose(facingPose(queue.target, front));
        march.last = group.mesh.pose();
        march.phase = MarchPhase::Stand;
        march.speed = march.spin = 0.0;
        queue.stoodAt = state.stepCount;
        return;
    }
    if (order.manner == Manner::Free && !march.turns) {
        const Vec2 last = queue.target - order.route.back();
        march.turns = length(last) > 0.0;
        march.facing = arcTangent2(last.y, last.x);
    }
    const std::int32_t region = regionOf(state, group);
    const OrderGoal goal = goalOf(state.routesOf(group), region, extentOf(group).width, order.target);
    listLegs(state.routesOf(group), region, order, goal, march.legs);
    march.way.assign(1, pose.position);
    march.next = 1;
    march.phase = MarchPhase::Search;
}

void OrderStage::avoid(const WorldState& state, Group& group, const MarchDef& def) {
    avoids_ = true;
    group.mesh.setPose(avoidance_.advance(state, ways_.ground(), def, group));
}

void OrderStage::goOn(WorldState& state, Group& group, const MarchDef& def) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const Order& order = queue.orders.front().order;
    if (march.phase == MarchPhase::Search && budget_ > 0) {
        const std::int32_t region = regionOf(state, group);
        const bool whole = ways_.advance(state, state.routesOf(group), region, !order.route.empty(),
                                         needsOf(state, group, order), march, budget_);
        if (whole) {
            if (!(march.way.back() == queue.target)) march.way.push_back(queue.target);
            march.phase = MarchPhase::Go;
        }
    }
    const double dt = state.parameters.stepTime;
    if (march.phase == MarchPhase::Search)
        march.speed = std::max(0.0, march.speed - def.acceleration * dt);
    else if (march.phase == MarchPhase::Go && group.def.conduct.avoids)
        avoid(state, group, def);
    else
        group.mesh.setPose(advanceMarch(def, march, group.mesh.pose(), dt));
    march.last = group.mesh.pose();
}

bool OrderStage::isDone(const WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
    if (queue.march.phase != MarchPhase::Stand) {
        queue.stoodAt = state.stepCount;
        return false;
    }
    const Characters& c = state.characters;
    const std::uint32_t patience = stepsIn(state, kWaitedFor);
    const std::uint32_t longest = stepsIn(state, kLongest);
    std::int32_t arrived = 0;
    bool stuck = true;
    shared_.find(state);
    for (const std::int32_t i : group.members) {
        const std::int32_t place = c.place[i];
        const Vec2 target = place >= 0 ? group.places.reachableTargets()[place] : Vec2{};
        if (place >= 0 && distance(c.position[i], target) <= kArrivedReach + shared_.room(i))
            ++arrived;
        else
            stuck = stuck && (state.stepCount - c.walk[i].movedAt >= patience ||
                              state.stepCount - c.walk[i].campedAt >= longest);
    }
    if (arrived > queue.arrived) {
        queue.arrived = arrived;
        queue.stoodAt = state.stepCount;
    }
    const double share = queue.orders.front().order.share * static_cast<double>(group.members.size());
    // Targets follow the mesh in this step.
    const std::uint32_t quiet = state.stepCount - queue.stoodAt;
    if (quiet > 1 && arrived >= static_cast<std::int32_t>(std::ceil(share - 1e-9))) return true;
    return stuck && quiet >= patience;
}

// Narrows before passages, as far as they ask, and widens behind them.
void OrderStage::squeeze(WorldState& state, Group& group, const FormationExtent& extent, ThreadPool& pool) {
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
    const double room = ways_.narrowest(march, group.mesh.pose().position, extent.depth + 1.0,
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

OrderStage::Outcome OrderStage::follow(WorldState& state, Group& group, const MarchDef& def) {
    OrderQueue& queue = group.orders;
    March& march = queue.march;
    const Order& order = queue.orders.front().order;
    const Lead lead = leadOf(state, order);
    if (!lead.found) return Outcome::Done;
    if (queue.orders.size() > 1 && state.stepCount - queue.begunAt >= stepsIn(state, kSoonDone))
        return Outcome::Done;
    const Pose leading = facingPose(lead.position, lead.facing);
    const Pose pose = group.mesh.pose();
    const double dt = state.parameters.stepTime;
    const double radius = groundRadius(state.parameters.character.radius, group.groundClass);
    const Vec2 goal = state.environment.def().box.clamp(leading.apply(order.offset));
    const std::int32_t region = regionOf(state, group);
    const bool free = region < 0 || state.routesOf(group).region(goal) == region;
    if (free && state.environment.clearStaticLine(pose.position, goal, radius)) {
        march.phase = MarchPhase::Idle;
        group.mesh.setPose(advanceTowards(def, march, pose, goal, lead.velocity, lead.facing, dt));
        march.last = group.mesh.pose();
        return Outcome::GoesOn;
    }
    const double stale = std::max(2.0, 0.25 * distance(pose.position, goal));
    const bool under = march.phase == MarchPhase::Search || march.phase == MarchPhase::Go;
    if (!under || distance(queue.target, goal) > stale) {
        queue.target = goal;
        march.turns = false;
        march.searched = 0;
        march.legs.assign(1, free ? goal : state.routesOf(group).nearestReachable(goal, region));
        march.way.assign(1, pose.position);
        march.next = 1;
        march.phase = MarchPhase::Search;
    }
    if (march.phase == MarchPhase::Search && budget_ > 0 &&
        ways_.advance(state, state.routesOf(group), region, false, needsOf(state, group, order), march,
                      budget_))
        march.phase = MarchPhase::Go;
    if (march.phase == MarchPhase::Go && group.def.conduct.avoids)
        avoid(state, group, def);
    else
        group.mesh.setPose(advanceMarch(def, march, pose, dt));
    march.last = group.mesh.pose();
    return Outcome::GoesOn;
}

OrderStage::Outcome OrderStage::guard(WorldState& state, Group& group) {
    OrderQueue& queue = group.orders;
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

OrderStage::Outcome OrderStage::advance(WorldState& state, Group& group, ThreadPool& pool) {
    OrderQueue& queue = group.orders;
    const Order& order = queue.orders.front().order;
    if (order.kind == OrderKind::Guard) return guard(state, group);
    const FormationExtent extent = extentOf(group);
    MarchDef def = marchDefOf(state, group, order, extent);
    // A free group waits for nobody on a drawn way.
    if (order.manner != Manner::Free)
        def.pace = patientPace(queue.march, paceOf(state, group), state.parameters.stepTime);
    if (order.kind == OrderKind::Follow) return follow(state, group, def);
    // Led away by fingers, it goes on from where it is.
    if (queue.march.phase == MarchPhase::Idle || !samePose(queue.march.last, group.mesh.pose()))
        restart(state, group);
    goOn(state, group, def);
    if (order.kind == OrderKind::Move && order.manner == Manner::March && order.turn != Turn::Keep)
        squeeze(state, group, extent, pool);
    return isDone(state, group) ? Outcome::Done : Outcome::GoesOn;
}

void OrderStage::runGroup(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    // Each order of the queue ends once in a step at most.
    for (std::size_t left = queue.orders.size(); left > 0 && !queue.orders.empty(); --left) {
        Outcome outcome = queue.begun ? Outcome::GoesOn : begin(state, group, pool, events);
        if (outcome == Outcome::GoesOn) {
            if (!group.controls.controls().empty()) group.controls.clear();
            recentre(group);
            outcome = advance(state, group, pool);
        }
        if (outcome == Outcome::GoesOn) return;
        const QueuedOrder done = queue.orders.front();
        raise(events, outcome == Outcome::Done ? EventKind::OrderDone : EventKind::OrderSkipped, group,
              done.id);
        queue.end();
        queue.orders.erase(queue.orders.begin());
        if (queue.patrols) queue.orders.push_back(done);
        if (outcome == Outcome::Done && queue.patrols && queue.orders.size() == 1) return;
    }
}

void OrderStage::run(WorldState& state, ThreadPool& pool, std::vector<Event>& events) {
    // A step that divides a group has enough to do.
    const bool divided = std::any_of(events.begin(), events.end(),
                                     [](const Event& event) { return event.kind == EventKind::GroupAdded; });
    budget_ = divided ? 0 : kCellsPerStep;
    ways_.update(state);
    avoidance_.begin();
    for (Group& group : state.groups) {
        avoids_ = false;
        runQueue(state, group, pool, events);
        if (!avoids_) group.avoidance = {};
    }
}

void OrderStage::runQueue(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events) {
    OrderQueue& queue = group.orders;
    if (queue.orders.empty()) {
        queue.march.speed = queue.march.spin = 0.0;
        if (queue.own && !isHandled(group)) restoreOwn(state, group, pool);
        return;
    }
    if (queue.held || isHandled(group) || group.members.empty()) {
        queue.march.speed = queue.march.spin = 0.0;
        return;
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
    const OrderGoal goal = goalOf(state.refreshRoutes(group.groundClass), region, extent.width, asked.target);
    March march;
    march.reversed = from == nullptr && group.orders.march.reversed;
    march.way.assign(1, pose.position);
    listLegs(state.routesOf(group), region, asked, goal, march.legs);
    std::int32_t budget = state.environment.grid().count() + 1;
    // A search that is under way is run again up to where it was.
    RouteGraph& routes = state.refreshRoutes(group.groundClass);
    while (!ways_.advance(state, routes, region, !asked.route.empty(), needsOf(state, group, asked), march,
                          budget))
        budget = state.environment.grid().count() + 1;
    if (!(march.way.back() == goal.target)) march.way.push_back(goal.target);
    forecast.arrives = goal.reachable;
    forecast.end = goal.target;
    forecast.way = march.way;
    const MarchDef def = marchDefOf(state, group, asked, extent);
    const auto facing = asked.manner == Manner::Free ? std::nullopt : asked.facing;
    const double slower = slowGround(state.environment, march.way,
                                     asked.manner == Manner::Free ? 0.0 : extent.depth);
    forecast.seconds = goal.reachable
                           ? marchTime(def, march.way, march.front(pose), facing) + slower / def.speed
                           : std::numeric_limits<double>::infinity();
    return forecast;
}

}  // namespace muster
