#include "engine/systems/goals/goal_stage.h"

#include <algorithm>
#include <limits>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"
#include "engine/state/ground_class.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/goals/along_walls.h"

namespace muster {
namespace {

constexpr double kFarCost = 5.0;  // Cost of a route above which it is not looked up in every step [m]...
constexpr std::uint32_t kFarSteps = 4;  // ... but in one of this many steps.
constexpr double kMostWallGap = 0.5;    // Greatest extra distance to walls [m].
constexpr double kFieldAhead = 100.0;  // Distance ahead of the point for which a person heads on a field [m].

// The order that a group without places carries out; null where its members stand.
const Order* orderOf(const Group& group, const Gathering& gathering) {
    const OrderQueue& queue = group.orders;
    if (!gathering.active || queue.held) return nullptr;
    const bool begun = queue.begun && !queue.orders.empty() &&
                       queue.orders.front().order.kind == gathering.kind;
    return begun ? &queue.orders.front().order : nullptr;
}

// Distance by which a person keeps farther from walls than it must [m]: evenly spread over all ids.
double wallGapOf(std::uint32_t id) {
    constexpr std::uint32_t kGolden = 2654435769u;  // 2 to the power 32 by the golden ratio.
    return kMostWallGap * (static_cast<double>(id * kGolden) / 4294967296.0);
}

// True for a person far from its exit whose route stays as it is in this step, as no command has changed
// anything.
bool keepsWay(const WorldState& state, std::size_t i) {
    const Characters& c = state.characters;
    const bool changed = state.lastCommandStep == state.stepCount || state.groundEdits != state.editsBefore;
    const bool far = c.cost[i] > kFarCost && c.cost[i] < kInfiniteCost && !(c.direction[i] == Vec2{});
    return !changed && far && (state.stepCount + c.id[i]) % kFarSteps != 0;
}

double bodyRadius(const WorldState& state, std::size_t i) {
    const double own = state.characters.body[i].radius;
    return own == 0.0 ? state.parameters.character.radius : own;
}

}  // namespace

// Sorts the groups without formation by what they do; false where there are none.
bool GoalStage::listGroups(WorldState& state) {
    leavers_.clear();
    for (std::vector<Group*>* list : {&waiting_, &walking_, &idle_}) list->clear();
    for (const Gathering& gathering : state.continuum.gatherings) {
        if (!gathering.isBare()) continue;
        Group* const group = state.findGroup(gathering.group);
        if (group == nullptr) continue;
        const Order* const order = orderOf(*group, gathering);
        if (gathering.kind == OrderKind::Wait && gathering.active && !group->orders.held)
            waiting_.push_back(group);
        else if (order == nullptr)
            idle_.push_back(group);
        else if (order->kind == OrderKind::Leave)
            leavers_.push_back({group, order, state.continuum.find(gathering.group)});
        else
            walking_.push_back(group);
    }
    return !(leavers_.empty() && waiting_.empty() && walking_.empty() && idle_.empty());
}

void GoalStage::findClasses(const WorldState& state, ThreadPool& pool) {
    const Characters& c = state.characters;
    const Parameters::Character& usual = state.parameters.character;
    classes_.resize(c.size());
    forChunks(&pool, c.size(), kPerTask, [&](std::size_t i) {
        const double own = c.body[i].radius;
        classes_[i] = own == 0.0 ? 0 : groundClassFor(usual.radius, own);
    });
}

// The classes of ground of a group's members, ascending.
std::span<const std::int32_t> GoalStage::classesOf(const Group& group) {
    used_.clear();
    addClasses(group, classes_, used_);
    return used_;
}

void GoalStage::standAll(WorldState& state, const Group& group, std::span<Vec2> heads) {
    for (const std::int32_t i : group.members) {
        if (!group.orders.held) state.characters.goal[i] = 0;
        follow(state, static_cast<std::size_t>(i), {kInfiniteCost, {}}, heads);
    }
}

// Writes the route of one character.
void GoalStage::follow(WorldState& state, std::size_t i, const GoalWay& way, std::span<Vec2> heads) const {
    Characters& c = state.characters;
    c.direction[i] = way.direction;
    c.cost[i] = way.cost;
    heads[i] = c.position[i] + way.direction * kFieldAhead;
}

// Writes the route of a character that is led along the walls that it touches.
void GoalStage::followField(WorldState& state, std::size_t i, GoalWay way, const GoalField& field,
                            std::span<Vec2> heads) const {
    way.direction = alongWalls(state.environment, state.characters.position[i], bodyRadius(state, i),
                               way.direction, [&](Vec2 p) { return field.cost(p); });
    follow(state, i, way, heads);
}

// Lets a character stand at a point that it sees.
void GoalStage::goTo(WorldState& state, std::size_t i, Vec2 spot, double cost, std::span<Vec2> heads) {
    Characters& c = state.characters;
    const double radius = bodyRadius(state, i);
    const auto away = [&](Vec2 p) { return distance(p, spot); };
    c.direction[i] = normalized(spot - c.position[i], {});
    if (away(c.position[i]) > radius)
        c.direction[i] = alongWalls(state.environment, c.position[i], radius, c.direction[i], away);
    c.cost[i] = cost;
    heads[i] = spot;
    standing_[i] = 1;
}

void GoalStage::leave(WorldState& state, std::span<Vec2> heads, ThreadPool& pool) {
    if (leavers_.empty()) return;
    Characters& c = state.characters;
    choice_.run(state, fields_, leavers_, classes_, pool);
    lines_.run(state, fields_, classes_);
    if (lines_.any())
        for (Area& area : state.areas)
            if (!area.def.queue.empty())
                for (const std::int32_t groundClass : choice_.classes()) fields_.toQueue(area, groundClass);
    for (const Leavers& some : leavers_) {
        const std::vector<std::int32_t>& members = some.group->members;
        forChunks(&pool, members.size(), kPerTask, [&](std::size_t k) {
            const auto i = static_cast<std::size_t>(members[k]);
            const GoalField* const field = choice_.fieldOf(c, i, classes_);
            if (field == nullptr) return follow(state, i, {kInfiniteCost, {}}, heads);
            const ExitLines::Duty duty = lines_.dutyOf(i);
            if (duty == ExitLines::Duty::Free) {
                if (keepsWay(state, i)) return follow(state, i, {c.cost[i], c.direction[i]}, heads);
                const double gap = wallGapOf(c.id[i]);
                if (choice_.wayOf(i) >= 0)
                    return followField(state, i, choice_.wayThrough(c, i, gap), choice_.fieldThrough(c, i),
                                       heads);
                return followField(state, i, field->at(c.position[i], gap), *field, heads);
            }
            const double left = field->cost(c.position[i]);
            const Vec2 spot = lines_.spotOf(i);
            const StaticGround& ground = field->ground();
            if (ground.collisionFree(c.position[i], spot)) return goTo(state, i, spot, left, heads);
            const GoalField& queue = fields_.solvedQueue(*choice_.areaOf(c, i), classes_[i]);
            followField(state, i, {left, queue.at(c.position[i]).direction}, queue, heads);
        });
    }
}

// Members with a spot go to it; others come near, and stand before the area where it is full.
void GoalStage::wait(WorldState& state, Group& group, Gathering& gathering, std::span<Vec2> heads,
                     ThreadPool& pool) {
    Characters& c = state.characters;
    const Area* const area = state.findArea(gathering.area);
    if (area == nullptr || area->def.kind != AreaKind::Waiting) return standAll(state, group, heads);
    spots_.run(state, group, gathering, *area, fields_.ground(0));
    for (const std::int32_t groundClass : classesOf(group)) fields_.toArea(*area, groundClass);
    forChunks(&pool, group.members.size(), kPerTask, [&](std::size_t k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        c.goal[i] = gathering.area.value;
        const GoalField& field = fields_.solvedArea(*area, classes_[i]);
        const StandingSpot* const spot = gathering.spotOf(c.id[i]);
        const GoalWay way = field.at(c.position[i]);
        if (spot != nullptr && field.ground().collisionFree(c.position[i], spot->spot))
            return goTo(state, i, spot->spot, distance(c.position[i], spot->spot), heads);
        const bool stands = spot == nullptr && gathering.hasArrived(c.id[i]);
        followField(state, i, stands ? GoalWay{way.cost, {}} : way, field, heads);
    });
}

void GoalStage::walk(WorldState& state, const Group& group, double heading, std::span<Vec2> heads,
                     ThreadPool& pool) {
    Characters& c = state.characters;
    for (const std::int32_t groundClass : classesOf(group)) fields_.towards(heading, groundClass);
    forChunks(&pool, group.members.size(), kPerTask, [&](std::size_t k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        c.goal[i] = 0;
        const GoalField& field = fields_.solvedHeading(heading, classes_[i]);
        followField(state, i, field.at(c.position[i]), field, heads);
    });
}

void GoalStage::run(WorldState& state, PlanCosts& costs, std::span<Vec2> heads, ThreadPool& pool) {
    standing_.clear();
    if (!listGroups(state)) return;
    standing_.assign(state.characters.size(), 0);
    fields_.begin(state, costs);
    findClasses(state, pool);
    for (const Group* group : idle_) standAll(state, *group, heads);
    leave(state, heads, pool);
    for (Group* group : waiting_) wait(state, *group, *state.continuum.find(group->id), heads, pool);
    for (const Group* group : walking_)
        walk(state, *group, group->orders.orders.front().order.facing.value_or(0.0), heads, pool);
}

// A group without an exit stands until there is one again.
void GoalStage::raiseWays(WorldState& state, std::vector<Event>& events) {
    const Characters& c = state.characters;
    for (const Gathering& gathering : state.continuum.gatherings) {
        Group* const group = state.findGroup(gathering.group);
        if (group == nullptr || !gathering.isBare()) continue;
        const bool goes = orderOf(*group, gathering) != nullptr;
        std::int32_t none = 0;
        Vec2 middle;
        for (const std::int32_t i : group->members) {
            if (!goes || c.cost[i] < kInfiniteCost) continue;
            ++none;
            middle += c.position[i];
        }
        const std::int32_t before = group->order.withoutWay;
        group->order.withoutWay = none;
        if (none > before)
            events.push_back(
                {EventKind::NoPath, group->id.value, static_cast<std::uint32_t>(none), middle / none});
        else if (none == 0 && before > 0 && goes && !group->members.empty())
            events.push_back({EventKind::Free, group->id.value, static_cast<std::uint32_t>(before),
                              group->mesh.pose().position});
    }
}

}  // namespace muster
