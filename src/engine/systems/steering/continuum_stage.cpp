#include "engine/systems/steering/continuum_stage.h"

#include <cmath>
#include <limits>

#include "engine/state/ground_class.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kFrozenTime = 0.25;   // Time for which frozen costs serve [s].
constexpr double kTargetRadius = 0.3;  // Distance to the target at which a character stands [m].
constexpr double kTouchGap = 0.15;     // Gap to an arrived character below which the two touch [m].
// Time without progress after which a character that touches an arrived one has arrived too [s].
constexpr double kTouchTime = 1.5;
// Factor of the radius of a disc of bodies: times their radius and the root of their number.
constexpr double kDiscFactor = 1.15;
constexpr double kDiscMargin = 0.35;  // Distance added to the radius of the disc [m].

}  // namespace

double gatheringReach(std::size_t count, double radius) {
    return kDiscFactor * radius * std::sqrt(static_cast<double>(count)) + kDiscMargin;
}

void ContinuumStage::begin(WorldState& state, PlanCosts& costs) {
    Continuum& continuum = state.continuum;
    const auto isBare = [](const Gathering& gathering) { return gathering.isBare(); };
    if (std::all_of(continuum.gatherings.begin(), continuum.gatherings.end(), isBare)) {
        if (!continuum.costs.empty()) continuum.costs.clear();
        return;
    }
    std::vector<std::int32_t> classes;
    for (const Group& group : state.groups) {
        const Gathering* const gathering = continuum.find(group.id);
        if (gathering != nullptr && gathering->active && !gathering->isBare() && !group.members.empty())
            classes.push_back(group.groundClass);
    }
    std::sort(classes.begin(), classes.end());
    classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
    const auto holds = [&](std::int32_t wanted) {
        return std::any_of(continuum.costs.begin(), continuum.costs.end(),
                           [&](const FrozenCost& frozen) { return frozen.groundClass == wanted; });
    };
    const bool fresh = continuum.groundEdits == state.groundEdits &&
                       state.stepCount - continuum.frozenAt < stepsIn(state, kFrozenTime) &&
                       std::all_of(classes.begin(), classes.end(), holds);
    if (fresh || classes.empty()) return;
    continuum.costs.resize(classes.size());
    for (std::size_t k = 0; k < classes.size(); ++k)
        continuum.costs[k] = {classes[k], costs.ofClass(classes[k]).unitCost()};
    continuum.frozenAt = state.stepCount;
    continuum.groundEdits = state.groundEdits;
    std::erase_if(fields_, [](const Field& field) { return !field.used; });
    for (Field& field : fields_) {
        field.used = false;
        field.stale = true;
    }
}

const CostField& ContinuumStage::fieldOf(const WorldState& state, std::int32_t groundClass, Vec2 target) {
    Field* found = nullptr;
    for (Field& field : fields_) {
        if (!(field.target == target) || field.groundClass != groundClass) continue;
        found = &field;
        field.used = true;
        if (!field.stale) return field.field;
    }
    if (found == nullptr) found = &fields_.emplace_back();
    found->groundClass = groundClass;
    found->target = target;
    found->used = true;
    found->stale = false;
    for (const FrozenCost& frozen : state.continuum.costs)
        if (frozen.groundClass == groundClass) solver_.solve(frozen.cost, target, {}, found->field);
    return found->field;
}

// Finds members that have come to the target, or that touch an arrived member, near the target or after they
// have not got on for a while.
void ContinuumStage::findArrived(const WorldState& state, const Group& group, Gathering& gathering) {
    const Characters& c = state.characters;
    const Parameters::Character& usual = state.parameters.character;
    standing_.clear();
    double largest = usual.radius;
    for (const std::int32_t i : group.members) {
        largest = std::max(largest, radiusOf(usual, c.body[i]));
        if (gathering.hasArrived(c.id[i])) standing_.push_back(c.position[i]);
    }
    const double reach = gatheringReach(group.members.size(), largest);
    const double touching = 2.0 * largest + kTouchGap;
    if (!standing_.empty()) cells_.sort(standing_, touching);
    const auto touches = [&](Vec2 p) {
        const auto isNear = [&](std::int32_t k) { return distance(standing_[k], p) <= touching; };
        return !standing_.empty() && cells_.anyBeside(p, isNear);
    };
    const std::uint32_t patience = stepsIn(state, kTouchTime);
    for (const std::int32_t i : group.members) {
        if (gathering.hasArrived(c.id[i])) continue;
        const double away = distance(c.position[i], gathering.target);
        // Once the order is done, a member that touches an arrived one stops.
        const bool stands = group.orders.orders.empty() || state.stepCount - c.walk[i].movedAt >= patience;
        if (away > kTargetRadius && !((away <= reach || stands) && touches(c.position[i]))) continue;
        gathering.arrived.insert(
            std::lower_bound(gathering.arrived.begin(), gathering.arrived.end(), c.id[i]), c.id[i]);
    }
}

void ContinuumStage::guide(WorldState& state, const Group& group, Gathering& gathering) {
    Characters& c = state.characters;
    const bool goes = gathering.active && !group.orders.held;
    if (goes) findArrived(state, group, gathering);
    const CostField* const field = goes ? &fieldOf(state, group.groundClass, gathering.target) : nullptr;
    for (const std::int32_t i : group.members) {
        const bool stands = field == nullptr || gathering.hasArrived(c.id[i]) || !fitsGround(state, group, i);
        c.direction[i] = stands ? Vec2{} : field->direction(c.position[i]);
        c.cost[i] = stands ? std::numeric_limits<double>::infinity() : field->cost(c.position[i]);
    }
}

}  // namespace muster
