#include "engine/systems/plans/plan_stage.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/assignment/planning/main_places.h"
#include "engine/state/ground_class.h"
#include "engine/state/group_edits.h"
#include "engine/systems/steering/own_routes.h"

namespace muster {
namespace {

// Characters for which first plans are made in one step, unless a single group has more.
constexpr std::size_t kFirstCharacters = 500;
// In a large world the number is one part in kFirstDivisor of all characters.
constexpr std::size_t kFirstDivisor = 10;

constexpr std::int32_t kExactPeriod = 4;  // Steps between exact plans, whose work takes several steps.
constexpr std::int32_t kFastPeriod = 1;
// Number of characters from which on many groups take turns, number of characters whose fast plans are made
// in one step, and number of steps in which each group has a turn at least.
constexpr std::size_t kManyCharacters = 600;
constexpr std::size_t kTurnCharacters = 150;
constexpr std::size_t kPlanTurns = 6;

constexpr double kMostSlowness = 10.0;  // Greatest ratio of top speeds that counts.
constexpr float kLeastCost = 0.01f;     // Least cost of a place whose cost is known [m].

/// True where a plan is due. Groups take different steps of the period, so that their plans do not fall on
/// one step.
bool isDue(const WorldState& state, std::size_t index, std::int32_t period) {
    const Group& group = state.groups[index];
    const bool turn = (state.stepCount + index) % static_cast<std::uint32_t>(period) == 0;
    return group.planNow || (!group.plan->pending() && turn);
}

// The ratio of the usual top speed to a character's own, by which a route costs it more (SPEC B10).
double slownessOf(const WorldState& state, std::int32_t i) {
    const Parameters::Character& usual = state.parameters.character;
    const double own = state.characters.body[i].maxSpeed;
    return own > 0.0 ? std::clamp(usual.maxSpeed / own, 1.0 / kMostSlowness, kMostSlowness) : 1.0;
}

// The objective of plans, and the exchanges that they commit.
PlanDef objectiveOf(const Parameters::Plan& plan) {
    PlanDef def;
    def.exponent = plan.exponent;
    def.commitThreshold = plan.threshold;
    def.commitThresholdShare = plan.thresholdShare;
    def.bottleneck = plan.objective == PlanObjective::LongestWalk;
    def.geodesic = plan.geodesic;
    return def;
}

}  // namespace

std::int32_t planPeriod(const Parameters::Plan& plan) {
    if (plan.period > 0) return plan.period;
    return plan.solver == PlanSolver::Exact ? kExactPeriod : kFastPeriod;
}

std::int32_t planPeriod(const Parameters::Plan& plan, std::size_t groups, std::size_t characters) {
    const std::int32_t period = planPeriod(plan);
    if (plan.period > 0 || plan.solver == PlanSolver::Exact || characters < kManyCharacters) return period;
    const std::size_t turns = std::min(characters / kTurnCharacters, std::min(groups, kPlanTurns));
    return std::max(period, static_cast<std::int32_t>(turns));
}

void PlanStage::reserve(WorldState& state, PlanCosts& costs) {
    for (Group& group : state.groups)
        group.plan->reserve(group.members.size(), group.places.positions().size(),
                            costs.ofClass(group.groundClass));
}

// Marks members that can get to the places: not those on ground that is cut off from most of the group, or
// too large for where the group goes. Empty where all can.
void PlanStage::findConnected(const WorldState& state, const Group& group, std::span<const Vec2> positions) {
    connected_.clear();
    if (!group.split && tooLargeFor(state, group) == 0) return;
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const std::int32_t label = state.routesOf(group).region(positions[k]);
        const bool joined = label < 0 || group.region < 0 || label == group.region;
        connected_.push_back(joined && fitsGround(state, group, group.members[k]) ? 1 : 0);
    }
}

void PlanStage::gatherKnown(const WorldState& state, const Group& group) {
    gatherExactCosts(state, group, exact_);
    known_.clear();
    for (std::size_t k = 0; k < exact_.size(); ++k) {
        const bool known = exact_[k] >= 0.0;
        known_.push_back(
            known ? std::max(kLeastCost, static_cast<float>(slownessOf(state, group.members[k]) * exact_[k]))
                  : -1.0f);
    }
}

// Gathers slownesses; empty where all members are as fast as the parameters say.
void PlanStage::gatherSlowness(const WorldState& state, const Group& group) {
    slowness_.clear();
    const auto isUsual = [&](std::int32_t i) { return state.characters.body[i].maxSpeed == 0.0; };
    if (std::all_of(group.members.begin(), group.members.end(), isUsual)) return;
    for (const std::int32_t i : group.members) slowness_.push_back(static_cast<float>(slownessOf(state, i)));
}

// Finds the classes of members and places; only members that can get to the places count.
void PlanStage::findClasses(const WorldState& state, Group& group) {
    const std::vector<RoleDef>& roles = group.def.roles;
    class_.clear();
    ClassCounts counts{};
    for (std::size_t k = 0; k < group.members.size() && !roles.empty(); ++k) {
        class_.push_back(roleClass(roles, state.characters.body[group.members[k]].unitClass));
        if (connected_.empty() || connected_[k] != 0) ++counts[class_.back()];
    }
    group.placeClasses.find(group.mesh.formation(), roles, counts, group.places.fit(), group.placeClass);
}

// Gathers supplies and demands; empty where every member and every place counts for one unit.
void PlanStage::gatherAmounts(const WorldState& state, const Group& group) {
    const std::vector<double>& demands = group.def.demands;
    supply_.clear();
    demand_.clear();
    const auto isOne = [&](std::int32_t i) { return state.characters.body[i].supply == 1.0; };
    const std::size_t places = group.places.positions().size(), known = std::min(demands.size(), places);
    if (std::all_of(demands.begin(), demands.begin() + static_cast<std::ptrdiff_t>(known),
                    [](double demand) { return demand == 1.0; }) &&
        std::all_of(group.members.begin(), group.members.end(), isOne))
        return;
    for (const std::int32_t i : group.members) supply_.push_back(state.characters.body[i].supply);
    demand_.assign(demands.begin(), demands.begin() + static_cast<std::ptrdiff_t>(known));
    demand_.resize(places, 1.0);
}

void PlanStage::start(const WorldState& state, PlanCosts& costs, const PlannedWays& ways, Group& group,
                      const MemberArrays& members) {
    const PlanMode mode = state.parameters.plan.mode;
    PlanDef def = objectiveOf(state.parameters.plan);
    group.reassigns = mode == PlanMode::Transport || (mode == PlanMode::AssignedOnce && !group.assigned);
    def.reassign = group.reassigns;
    def.starts = std::max(1, starts_);
    def.groups = std::max(1, groups_);
    def.groupRank = groupRank_;
    if (group.planNow || group.provisional) {
        def.firstPlans = firstPlans_;
        def.firstPlanRank = firstPlanRank_++;
    }
    // A member that lost its place because that was not usable gets it back.
    incumbent_.assign(members.places().begin(), members.places().end());
    if (mode == PlanMode::Fixed)
        std::iota(incumbent_.begin(), incumbent_.end(), 0);
    else if (!group.reassigns)
        std::copy_n(group.lastAssignment.begin(), std::min(group.lastAssignment.size(), group.members.size()),
                    incumbent_.begin());
    PlanInput input;
    input.characters = members.positions();
    input.places = group.places.positions();
    input.usable = group.places.fit();
    input.incumbent = incumbent_;
    input.costs = &costs.ofClass(group.groundClass);
    input.edits = edits_;
    findConnected(state, group, members.positions());
    input.connected = connected_;
    gatherKnown(state, group);
    input.known = known_;
    gatherSlowness(state, group);
    input.slowness = slowness_;
    input.ways = ways;
    findClasses(state, group);
    input.characterClass = class_;
    input.placeClass = group.placeClass;
    gatherAmounts(state, group);
    input.supply = supply_;
    input.demand = demand_;
    group.slices = group.plan->shares(group.planNow ? 1 : period_);
    group.slice = 0;
    const Status status = group.plan->start(def, input);
    MUSTER_ASSERT(status.ok());
    (void)status;
}

void PlanStage::finish(WorldState& state, Group& group, MemberArrays& members, ThreadPool& pool,
                       std::vector<Event>& events) {
    const Status status = group.plan->finish(pool, result_);
    MUSTER_ASSERT(status.ok());
    (void)status;
    group.objective = result_.objective;
    group.gapBound = result_.gapBound;
    group.walk = {};
    for (const double cost : result_.cost) group.walk.add(cost);
    Characters& characters = state.characters;
    findMainPlaces(result_.flows, members.places(), places_);
    if (group.reassigns) group.lastAssignment = places_;
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        const std::int32_t i = group.members[k];
        const std::int32_t place = places_[k];
        if (place == characters.place[i]) continue;
        if (!result_.first && !group.planNow && place >= 0 && characters.place[i] >= 0)
            events.push_back({EventKind::Swap, characters.id[i], static_cast<std::uint32_t>(place),
                              characters.position[i]});
        characters.place[i] = place;
    }
    members.setPlaces(places_);
    group.provisional = result_.provisional;
    group.assigned = !result_.provisional;
    group.planNow = false;
}

// Takes the places of a group that goes by a field; a new plan is made when places count again.
bool PlanStage::goesWithout(WorldState& state, Group& group) {
    if (state.continuum.find(group.id) == nullptr) return false;
    // A group without plans follows no changes of the ground either.
    if (!group.planNow || group.plan->pending()) group.plan = makePlan(state.parameters);
    leavePlaces(state, group);
    return true;
}

void PlanStage::launch(ThreadPool& pool) {
    if (background_.empty()) return;
    pool.launch(
        [](void* plans) {
            for (Assigner* plan : *static_cast<std::vector<Assigner*>*>(plans)) plan->workInBackground();
        },
        &background_);
}

// Does the next share of a pending plan.
void PlanStage::advance(WorldState& state, Group& group, MemberArrays& members, ThreadPool& pool,
                        std::vector<Event>& events) {
    Assigner& plan = *group.plan;
    plan.advance(group.slice, group.slices, pool);
    if (++group.slice < group.slices) return;
    // A first plan is finished at once; later plans hold from the next step on.
    if (plan.worksInBackground() && !group.planNow)
        background_.push_back(&plan);
    else
        finish(state, group, members, pool, events);
}

// True where a first plan waits for a later step, so that the first plans of large groups do not fall on one
// step.
bool PlanStage::waitsForFirstPlan(const WorldState& state, const Group& group) {
    const std::size_t count = group.members.size();
    const std::size_t most = std::max(kFirstCharacters, state.characters.position.size() / kFirstDivisor);
    if (firstCharacters_ > 0 && firstCharacters_ + count > most) return true;
    firstCharacters_ += count;
    return false;
}

void PlanStage::endBackgroundWork(ThreadPool& pool) {
    pool.wait();
    background_.clear();
}

void PlanStage::takePlaces(WorldState& state) {
    without_.clear();
    for (Group& group : state.groups) {
        if (std::exchange(group.renumbered, false)) group.plan->forget();
        without_.push_back(goesWithout(state, group) ? 1 : 0);
    }
}

void PlanStage::findPeriod(const WorldState& state) {
    groups_ = 0;
    groupRank_ = -1;
    std::size_t characters = 0;
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        if (state.groups[g].members.empty() || without_[g] != 0) continue;
        ++groups_;
        characters += state.groups[g].members.size();
    }
    period_ = planPeriod(state.parameters.plan, static_cast<std::size_t>(groups_), characters);
}

void PlanStage::run(WorldState& state, PlanCosts& costs, const WayStage& ways, GroupMembers& members,
                    ThreadPool& pool, std::vector<Event>& events) {
    const auto isWithout = [&](const Group& group) { return without_[&group - state.groups.data()] != 0; };
    firstPlans_ = static_cast<std::int32_t>(
        std::count_if(state.groups.begin(), state.groups.end(), [&](const Group& group) {
            return !group.members.empty() && !isWithout(group) && (group.planNow || group.provisional);
        }));
    starts_ = static_cast<std::int32_t>(
        std::count_if(state.groups.begin(), state.groups.end(), [&](const Group& group) {
            return !group.members.empty() && !isWithout(group) && group.plan->starting();
        }));
    firstPlanRank_ = 0;
    firstCharacters_ = 0;
    // While anything moves, the ground counts as edited in every step.
    edits_ = state.environment.moves() ? state.groundEdits + state.stepCount : state.groundEdits;
    findPeriod(state);
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        Group& group = state.groups[g];
        if (group.members.empty() || without_[g] != 0) continue;
        ++groupRank_;
        const bool worked = group.plan->pending() && group.slice >= group.slices;
        if (worked && !group.planNow) finish(state, group, members.of(g), pool, events);
        if (group.planNow && waitsForFirstPlan(state, group)) continue;
        if (isDue(state, g, period_)) start(state, costs, ways.waysOf(g), group, members.of(g));
        if (group.plan->pending()) advance(state, group, members.of(g), pool, events);
    }
    launch(pool);
}

}  // namespace muster
