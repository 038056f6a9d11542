#include "world/stages/plan_stage.h"

#include <algorithm>
#include <numeric>

#include "world/state/layer_defs.h"

namespace muster {
namespace {

bool readsGround(const WorldState& state) {
    return std::any_of(state.groups.begin(), state.groups.end(),
                       [](const Group& group) { return !group.plan->readsUnitCost(); });
}

/// Groups take different steps of the period, so that their plans do not fall on one step.
bool isDue(const WorldState& state, std::size_t index) {
    const Group& group = state.groups[index];
    const auto period = static_cast<std::uint32_t>(planPeriod(state.parameters));
    return group.planNow || (!group.plan->pending() && (state.stepCount + index) % period == 0);
}

}  // namespace

void PlanStage::prepare(const WorldState& state) {
    const Parameters::Cost& cost = state.parameters.cost;
    if (readsGround(state))
        ground_.update(state.environment, cost.alpha + cost.beta, state.parameters.character.radius);
}

void PlanStage::reserve(WorldState& state, const DensityField& density) {
    if (readsGround(state)) dynamicCost_.reset(state.environment.grid(), density.grid());
    for (Group& group : state.groups)
        group.plan->reserve(group.members.size(), group.places.positions().size(), ground_);
}

void PlanStage::update(const WorldState& state, const DensityField& density) {
    if (!readsGround(state)) return;
    prepare(state);
    dynamicCost_.update(unitCostDef(state.parameters), state.environment, density,
                        state.parameters.character.radius);
}

// Marks who stands on ground that is cut off from where most of the group is; empty where nobody does.
void PlanStage::findConnected(const WorldState& state, const Group& group) {
    connected_.clear();
    if (!group.split) return;
    for (const Vec2 p : members_.positions()) {
        const std::int32_t label = state.environment.region(p, state.parameters.character.radius);
        connected_.push_back(label < 0 || group.region < 0 || label == group.region ? 1 : 0);
    }
}

void PlanStage::start(const WorldState& state, CostStage& cost, Group& group) {
    const PlanMode mode = state.parameters.plan.mode;
    members_.gather(state.characters, group);
    std::vector<std::int32_t>& incumbent = members_.places();
    PlanDef def = planDef(state.parameters);
    group.reassigns = mode == PlanMode::Transport || (mode == PlanMode::AssignedOnce && !group.assigned);
    def.reassign = group.reassigns;
    // Who lost its place because that was not usable gets it back.
    if (mode == PlanMode::Fixed)
        std::iota(incumbent.begin(), incumbent.end(), 0);
    else if (!group.reassigns)
        std::copy_n(group.lastAssignment.begin(), std::min(group.lastAssignment.size(), group.members.size()),
                    incumbent.begin());
    PlanInput input;
    input.characters = members_.positions();
    input.places = group.places.positions();
    input.usable = group.places.fit();
    input.incumbent = incumbent;
    const bool slow = group.plan->readsUnitCost();
    if (slow) {
        input.unitCost = &cost.unitCost(state);
    } else {
        findConnected(state, group);
        input.connected = connected_;
        input.ground = &ground_;
        input.dynamicCost = &dynamicCost_;
    }
    group.slices = group.planNow || !slow ? 1 : planPeriod(state.parameters);
    group.slice = 0;
    const Status status = group.plan->start(def, input);
    MUSTER_ASSERT(status.ok());
    (void)status;
}

void PlanStage::finish(WorldState& state, Group& group, ThreadPool& pool, std::vector<Event>& events) {
    const Status status = group.plan->finish(pool, result_);
    MUSTER_ASSERT(status.ok());
    (void)status;
    group.objective = result_.objective;
    group.gapBound = result_.gapBound;
    group.walk = {};
    for (const double cost : result_.cost) group.walk.add(cost);
    std::vector<std::int32_t>& places = members_.places();
    places.assign(group.members.size(), -1);
    for (const Flow& flow : result_.flows) places[flow.character] = flow.place;
    if (group.reassigns) group.lastAssignment = places;
    Characters& characters = state.characters;
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        const std::int32_t i = group.members[k];
        const std::int32_t place = places[k];
        if (place == characters.place[i]) continue;
        if (!group.planNow && place >= 0 && characters.place[i] >= 0)
            events.push_back({EventKind::Swap, characters.id[i], static_cast<std::uint32_t>(place),
                              characters.position[i]});
        characters.place[i] = place;
    }
    group.assigned = true;
    group.planNow = false;
}

void PlanStage::launch(ThreadPool& pool) {
    if (background_.empty()) return;
    pool.launch(
        [](void* plans) {
            for (Plan* plan : *static_cast<std::vector<Plan*>*>(plans)) plan->workInBackground();
        },
        &background_);
}

void PlanStage::run(WorldState& state, CostStage& cost, ThreadPool& pool, std::vector<Event>& events) {
    pool.wait();
    background_.clear();
    update(state, cost.density());
    for (std::size_t g = 0; g < state.groups.size(); ++g) {
        Group& group = state.groups[g];
        Plan& plan = *group.plan;
        if (plan.worksInBackground() && plan.pending() && !group.planNow) finish(state, group, pool, events);
        if (isDue(state, g)) start(state, cost, group);
        if (!plan.pending()) continue;
        plan.advance(group.slice, group.slices, pool);
        // A first plan is finished at once; later ones hold from the next step on.
        if (plan.worksInBackground() && !group.planNow)
            background_.push_back(&plan);
        else if (plan.worksInBackground() || ++group.slice >= group.slices)
            finish(state, group, pool, events);
    }
    launch(pool);
}

}  // namespace muster
