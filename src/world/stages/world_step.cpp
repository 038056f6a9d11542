// The step: each stage reads what stands frozen before it and writes the next.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/stopwatch.h"
#include "world/state/derived_defs.h"
#include "world/state/world_state.h"

namespace muster {
namespace {

using StageFunction = void (World::Impl::*)();

constexpr double kUnmatchedReach = 2.0;  // The unmatched stop this far from the nearest place [m].

}  // namespace

// The whole step, stage by stage.
constexpr StageFunction kStages[] = {
    &World::Impl::applyCommands,        // Stage::Commands
    &World::Impl::moveControls,         // Stage::Controls
    &World::Impl::deformMeshes,         // Stage::UserMesh
    &World::Impl::meetEnvironment,      // Stage::FinalMesh
    &World::Impl::movePlaces,           // Stage::Places
    &World::Impl::buildDensityAndCost,  // Stage::DensityAndCost
    &World::Impl::plan,                 // Stage::Plan
    &World::Impl::steer,                // Stage::Steering
    &World::Impl::resolveContacts,      // Stage::Contacts
    &World::Impl::updatePatches,        // Stage::Patches
    &World::Impl::raiseEvents,          // Stage::Events
};
static_assert(std::size(kStages) == static_cast<std::size_t>(Stage::Count));

void World::step() {
    const Stopwatch whole;
    Stopwatch watch;
    for (std::size_t i = 0; i < std::size(kStages); ++i) {
        watch.restart();
        (impl_.get()->*kStages[i])();
        impl_->times.milliseconds[i] = watch.milliseconds();
    }
    ++impl_->stepCount;
    impl_->times.total = whole.milliseconds();
}

// SPEC U6: the mesh waits for a crowd that falls behind.
void World::Impl::moveControls() {
    for (Group& group : groups) {
        const double pace = parameters.opposing.enabled
                                ? std::max(0.0, 1.0 - parameters.opposing.gain * group.meanLag)
                                : 1.0;
        group.controls.advance(controlDef(parameters), parameters.stepTime, time(), pace);
    }
}

void World::Impl::deformMeshes() {
    for (Group& group : groups) {
        const Status status = group.mesh.deform(meshDef(parameters), controlDef(parameters), group.controls,
                                                parameters.stepTime);
        MUSTER_ASSERT(status.ok());
        (void)status;
    }
}

void World::Impl::meetEnvironment() {
    for (Group& group : groups) group.mesh.meet(meshDef(parameters), environment, parameters.stepTime);
}

void World::Impl::movePlaces() {
    for (Group& group : groups) {
        group.mesh.placePositions(memory.targets);
        group.region = regionOf(group);
        const auto standsIn = [](std::int32_t count) { return count > 0; };
        group.apart = std::count_if(memory.regionCounts.begin(), memory.regionCounts.end(), standsIn) > 1;
        group.places.advance(placeDef(parameters), memory.targets, environment, group.region,
                             parameters.stepTime, pool.get());
    }
}

// Groups take turns within the period, so that their plans do not fall on one step.
bool World::Impl::plansThisStep(const Group& group, std::size_t index) const {
    const auto period = static_cast<std::uint32_t>(planPeriod(parameters));
    return group.planNow || (!group.plan->pending() && (stepCount + index) % period == 0);
}

void World::Impl::buildDensityAndCost() {
    density.splat(characters.position, characters.velocity);
    const auto reads = [](const Group& group) { return group.plan->readsUnitCost(); };
    costBuilt = std::any_of(groups.begin(), groups.end(), reads);
    if (costBuilt)
        costBuilder.update(unitCostDef(parameters), environment, density, parameters.character.radius);
}

bool World::Impl::plansReadGround() const {
    return std::any_of(groups.begin(), groups.end(),
                       [](const Group& group) { return !group.plan->readsUnitCost(); });
}

// The still ground as plans read it; a new world has it made before its first step.
void World::Impl::prepareGround() {
    const UnitCostDef def = unitCostDef(parameters);
    if (plansReadGround()) ground.update(environment, def.alpha + def.beta, parameters.character.radius);
}

// Memory for the first step, which makes the first plans, besides.
void World::Impl::makeRoom() {
    if (plansReadGround()) excess.reset(environment.grid(), density.grid());
    for (Group& group : groups)
        group.plan->reserve(group.members.size(), group.places.positions().size(), ground);
}

// What plans read that are not made from the unit cost of all ground.
void World::Impl::updateGround() {
    if (!plansReadGround()) return;
    prepareGround();
    excess.update(unitCostDef(parameters), environment, density, parameters.character.radius);
}

// Only the exact plan needs it for the step, but pictures and reports may ask.
const UnitCost* World::Impl::unitCostNow() {
    if (stepCount == 0) return nullptr;
    if (!costBuilt)
        costBuilder.update(unitCostDef(parameters), environment, density, parameters.character.radius);
    costBuilt = true;
    return &costBuilder.cost();
}

// Who stands on ground that is cut off from where most of the group is.
void World::Impl::findPresent(const Group& group, std::span<const Vec2> positions) {
    memory.groupPresent.clear();
    if (!group.apart) return;
    for (const Vec2 p : positions) {
        const std::int32_t label = environment.region(p, parameters.character.radius);
        memory.groupPresent.push_back(label < 0 || group.region < 0 || label == group.region ? 1 : 0);
    }
}

// Writes to memory.groupPlaces the place of each member; returns where members are, valid until the next
// call. A group that holds all characters needs no list of its own.
std::span<const Vec2> World::Impl::gather(const Group& group) {
    const std::size_t count = group.members.size();
    if (count == characters.size()) {
        memory.groupPlaces.assign(characters.place.begin(), characters.place.end());
        return characters.position;
    }
    memory.groupPositions.resize(count);
    memory.groupPlaces.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        memory.groupPositions[k] = characters.position[i];
        memory.groupPlaces[k] = characters.place[i];
    }
    return memory.groupPositions;
}

void World::Impl::startPlan(Group& group) {
    const PlanMode mode = parameters.plan.mode;
    PlanInput input;
    input.characters = gather(group);
    PlanDef def = planDef(parameters);
    group.reassigns = mode == PlanMode::Transport || (mode == PlanMode::AssignedOnce && !group.assigned);
    def.reassign = group.reassigns;
    // Who lost a kept place because it did not fit has a claim to it.
    if (mode == PlanMode::Fixed)
        std::iota(memory.groupPlaces.begin(), memory.groupPlaces.end(), 0);
    else if (!group.reassigns)
        std::copy_n(group.kept.begin(), std::min(group.kept.size(), group.members.size()),
                    memory.groupPlaces.begin());
    input.places = group.places.positions();
    input.usable = group.places.fit();
    input.incumbent = memory.groupPlaces;
    if (group.plan->readsUnitCost()) {
        input.unitCost = &costBuilder.cost();
    } else {
        findPresent(group, input.characters);
        input.connected = memory.groupPresent;
        input.ground = &ground;
        input.dynamicCost = &excess;
    }
    const bool whole = group.planNow || !group.plan->readsUnitCost();
    group.slices = whole ? 1 : planPeriod(parameters);
    group.slice = 0;
    const Status status = group.plan->start(def, input);
    MUSTER_ASSERT(status.ok());
    (void)status;
}

void World::Impl::finishPlan(Group& group) {
    const Status status = group.plan->finish(*pool, memory.planResult);
    MUSTER_ASSERT(status.ok());
    (void)status;
    group.objective = memory.planResult.objective;
    group.gapBound = memory.planResult.gapBound;
    group.walk = {};
    for (const double cost : memory.planResult.cost) group.walk.add(cost);
    memory.groupPlaces.assign(group.members.size(), -1);
    for (const Flow& flow : memory.planResult.flows) memory.groupPlaces[flow.character] = flow.place;
    if (group.reassigns) group.kept = memory.groupPlaces;
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        const std::int32_t place = memory.groupPlaces[k];
        if (place == characters.place[i]) continue;
        if (!group.planNow && place >= 0 && characters.place[i] >= 0)
            events.push_back({EventKind::Swap, characters.id[i], static_cast<std::uint32_t>(place),
                              characters.position[i]});
        characters.place[i] = place;
    }
    group.assigned = true;
    group.planNow = false;
}

void World::Impl::planInSlices(Group& group) {
    group.plan->advance(group.slice, group.slices, *pool);
    if (++group.slice >= group.slices) finishPlan(group);
}

// A first plan is made at once; others while the crowd walks, and hold from the next step on.
void World::Impl::planAside(Group& group) {
    group.plan->advance(0, 1, *pool);
    if (group.planNow)
        finishPlan(group);
    else
        aside.push_back(group.plan.get());
}

void World::Impl::launchPlans() {
    if (aside.empty()) return;
    pool->launch(
        [](void* plans) {
            for (Plan* plan : *static_cast<std::vector<Plan*>*>(plans)) plan->workInBackground();
        },
        &aside);
}

void World::Impl::plan() {
    settlePlans();
    aside.clear();
    updateGround();
    for (std::size_t g = 0; g < groups.size(); ++g) {
        Group& group = groups[g];
        if (group.plan->worksInBackground() && group.plan->pending() && !group.planNow) finishPlan(group);
        if (plansThisStep(group, g)) startPlan(group);
        if (!group.plan->pending()) continue;
        if (group.plan->worksInBackground())
            planAside(group);
        else
            planInSlices(group);
    }
    launchPlans();
}

void World::Impl::steerGroup(Group& group) {
    const std::size_t count = group.members.size();
    const std::span<const Vec2> positions = gather(group);
    memory.groupDirections.resize(count);
    memory.groupCosts.resize(count);
    directTheUnmatched(group, positions);
    const GuidanceInput input{positions,
                              memory.groupPlaces,
                              group.places.positions(),
                              &environment,
                              parameters.character.directReach,
                              &ground,
                              &excess};
    group.plan->guide(input, *pool, memory.groupDirections, memory.groupCosts);
    const Vec2 facing = group.mesh.pose().rotation.apply({1.0, 0.0});
    for (std::size_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        const std::int32_t place = characters.place[i];
        const auto j = static_cast<std::size_t>(place);
        characters.direction[i] = memory.groupDirections[k];
        memory.facing[i] = facing;
        characters.cost[i] = place >= 0 ? memory.groupCosts[k] : std::numeric_limits<double>::infinity();
        memory.placePosition[i] = place >= 0 ? group.places.positions()[j] : characters.position[i];
        memory.placeVelocity[i] = place >= 0 ? group.places.velocities()[j] : Vec2{};
    }
}

// The unmatched come as near as the nearest place that someone can take, and wait there beside the mesh.
void World::Impl::directTheUnmatched(const Group& group, std::span<const Vec2> positions) {
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (memory.groupPlaces[k] >= 0) continue;
        const std::int32_t place = group.plan->waitingPlace(static_cast<std::int32_t>(k));
        if (place < 0) continue;
        const Vec2 position = positions[k];
        const Vec2 there = group.places.positions()[place];
        const bool beside = distance(position, there) < kUnmatchedReach &&
                            environment.clearLine(position, there, 0.0);
        if (!beside) memory.groupPlaces[k] = place;
    }
}

void World::Impl::steer() {
    const std::size_t count = characters.size();
    memory.placePosition.resize(count);
    memory.placeVelocity.resize(count);
    memory.facing.resize(count);
    memory.nextVelocity.resize(count);
    memory.nextHeading.resize(count);
    memory.nextPosition.resize(count);
    for (Group& group : groups) steerGroup(group);
    const SteeringInput input{memory.placePosition, memory.placeVelocity, memory.facing};
    steering.run(parameters.character, characters, input, environment, parameters.stepTime,
                 memory.nextVelocity, memory.nextHeading, pool.get());
    for (std::size_t i = 0; i < count; ++i)
        memory.nextPosition[i] = characters.position[i] + memory.nextVelocity[i] * parameters.stepTime;
}

void World::Impl::resolveContacts() {
    const KnownPairs known{steering.pairs(), characters.position, steering.reach()};
    contacts = contactSolver.resolve(contactDef(parameters), environment, memory.nextPosition, known,
                                     pool.get());
    // What contacts took away is not speed any more; what they pushed adds none.
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Vec2 moved = (memory.nextPosition[i] - characters.position[i]) / parameters.stepTime;
        characters.velocity[i] = clampLength(moved, length(memory.nextVelocity[i]));
        characters.position[i] = memory.nextPosition[i];
        characters.heading[i] = memory.nextHeading[i];
    }
}

void World::Impl::updatePatches() {
    memory.motionEvents.clear();
    updateMotions(environment, parameters.stepTime, characters, memory.motionEvents);
}

void World::Impl::raiseEvents() {
    for (const MotionEvent& event : memory.motionEvents) {
        const auto i = static_cast<std::size_t>(event.character);
        // The first kinds of both lists correspond one to one.
        const auto kind = static_cast<EventKind>(event.change);
        events.push_back({kind, characters.id[i], event.value, characters.position[i]});
    }
    collectItems();
    meetCheckpoints();
    measureLag();
}

void World::Impl::collectItems() {
    for (std::size_t k = 0; k < items.size(); ++k) {
        if (collected[k] != 0) continue;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            if (distance(characters.position[i], items[k].position) > items[k].radius) continue;
            collected[k] = 1;
            events.push_back(
                {EventKind::Collect, characters.id[i], static_cast<std::uint32_t>(k), items[k].position});
            break;
        }
    }
}

void World::Impl::meetCheckpoints() {
    for (std::size_t c = 0; c < checkpoints.size(); ++c) {
        const FormationCheckpointDef& checkpoint = checkpoints[c];
        for (std::size_t g = 0; g < groups.size(); ++g) {
            Group& group = groups[g];
            if (checkpointGroups[c] && checkpointGroups[c] != group.id) continue;
            std::uint8_t& state = checkpointState[g * checkpoints.size() + c];
            const bool inside = distance(group.mesh.pose().position, checkpoint.position) <=
                                checkpoint.radius;
            const bool comes = inside && (state & 1) == 0 && !(checkpoint.once && (state & 2) != 0);
            state = static_cast<std::uint8_t>((state & 2) | (inside ? 1 : 0));
            if (!comes) continue;
            state |= 2;
            if (changeFormation(group, checkpoint.formation, group.def.count).ok())
                events.push_back({EventKind::FormationChange, group.id.value, static_cast<std::uint32_t>(c),
                                  checkpoint.position});
        }
    }
}

// How far behind the mesh the crowd is. Places wait for slow ground themselves, so it counts from where they
// are bound.
void World::Impl::measureLag() {
    for (Group& group : groups) {
        double sum = 0.0;
        std::int32_t matched = 0;
        for (const std::int32_t member : group.members) {
            const auto i = static_cast<std::size_t>(member);
            if (characters.place[i] < 0) continue;
            sum += distance(characters.position[i], group.places.goals()[characters.place[i]]);
            ++matched;
        }
        group.meanLag = matched > 0 ? sum / matched : 0.0;
    }
}

}  // namespace muster
