// Groups and their characters: joining, leaving, changing formation.
#include <algorithm>
#include <string>

#include "base/maths.h"
#include "world/commands/validation.h"
#include "world/state/derived_defs.h"
#include "world/state/world_state.h"

namespace muster {
namespace {

Pose poseOf(Vec2 position, double angle) {
    return {position, {cosine(angle), sine(angle)}};
}

}  // namespace

Group* World::Impl::findGroup(GroupId id) {
    for (Group& group : groups)
        if (group.id == id) return &group;
    return nullptr;
}

void World::Impl::refreshMembers() {
    for (Group& group : groups) group.members.clear();
    for (std::size_t i = 0; i < characters.size(); ++i)
        groups[characters.group[i]].members.push_back(static_cast<std::int32_t>(i));
}

void World::Impl::addCharacter(const Group& group, std::uint32_t groupIndex, Vec2 position) {
    Characters& c = characters;
    c.id.push_back(nextCharacter++);
    c.group.push_back(groupIndex);
    c.position.push_back(environment.projectToFreeSpace(position, parameters.character.radius));
    c.velocity.push_back({});
    c.heading.push_back(group.mesh.pose().rotation.apply({1.0, 0.0}));
    c.place.push_back(-1);
    c.direction.push_back({});
    c.cost.push_back(0.0);
    c.motion.push_back(0);
    c.phase.push_back(MotionPhase::Steady);
    c.motionTime.push_back(0.0);
    c.patch.push_back(0);
    c.lastSingle.push_back(0);
}

void World::Impl::removeCharacter(std::size_t index) {
    const auto erase = [index](auto& array) {
        array.erase(array.begin() + static_cast<std::ptrdiff_t>(index));
    };
    Characters& c = characters;
    erase(c.id);
    erase(c.group);
    erase(c.position);
    erase(c.velocity);
    erase(c.heading);
    erase(c.place);
    erase(c.direction);
    erase(c.cost);
    erase(c.motion);
    erase(c.phase);
    erase(c.motionTime);
    erase(c.patch);
    erase(c.lastSingle);
}

// The connected region in which most of the group's characters stand; ties go to the lower label.
std::int32_t World::Impl::regionOf(const Group& group) {
    std::vector<std::int32_t>& counts = memory.regionCounts;
    counts.clear();
    std::int32_t best = -1;
    const bool only = environment.regionCount(parameters.character.radius) <= 1;
    for (const std::int32_t i : group.members) {
        const std::int32_t label = environment.region(characters.position[i], parameters.character.radius);
        if (label < 0) continue;
        if (only) return label;
        const auto at = static_cast<std::size_t>(label);
        if (at >= counts.size()) counts.resize(at + 1, 0);
        ++counts[at];
    }
    for (std::size_t label = 0; label < counts.size(); ++label)
        if (counts[label] > (best < 0 ? 0 : counts[best])) best = static_cast<std::int32_t>(label);
    return best;
}

// By `plan.solver`; the only place that knows which solvers there are.
std::unique_ptr<Plan> World::Impl::makePlan() const {
    return parameters.plan.solver == PlanSolver::Fast ? makeFastPlan() : makeExactPlan();
}

// Another solver takes over: every group is planned anew in this step, from the places that its characters
// have.
void World::Impl::exchangePlans() {
    settlePlans();
    for (Group& group : groups) {
        group.plan = makePlan();
        group.planNow = true;
    }
}

Status World::Impl::addGroup(const GroupDef& def) {
    if (groups.size() >= kMaxGroups)
        return {StatusCode::LimitExceeded, "a world holds at most " + std::to_string(kMaxGroups) + " groups"};
    const Status total = validateTotal(static_cast<std::int64_t>(characters.size()) + def.count, parameters);
    if (!total.ok()) return total.within("group '" + def.name + "'");
    if (def.count < 1)
        return invalidArgument("group '" + def.name + "': found count " + std::to_string(def.count) +
                               ", expected at least 1");
    if (!def.starts.empty() && def.starts.size() != static_cast<std::size_t>(def.count))
        return invalidArgument("group '" + def.name + "': found " + std::to_string(def.starts.size()) +
                               " starts, expected one for each of its " + std::to_string(def.count) +
                               " characters");
    const Result<Formation> formation = makeFormation(def.formation, def.count);
    if (!formation.ok()) return formation.status().within("group '" + def.name + "'");

    Group group;
    group.def = def;
    const Status placed = group.mesh.reset(*formation, poseOf(def.position, def.angle));
    if (!placed.ok()) return placed.within("group '" + def.name + "'");
    group.id = GroupId{nextGroup++};
    group.plan = makePlan();
    const auto index = static_cast<std::uint32_t>(groups.size());
    group.mesh.placePositions(memory.targets);
    for (std::int32_t i = 0; i < def.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        Vec2 start = def.starts.empty() ? memory.targets[std::min(k, memory.targets.size() - 1)]
                                        : def.starts[k];
        if (def.jitter > 0.0) {
            const double x = random.uniform(-def.jitter, def.jitter);
            const double y = random.uniform(-def.jitter, def.jitter);
            start += Vec2{x, y};
        }
        addCharacter(group, index, start);
    }
    groups.push_back(std::move(group));
    checkpointState.resize(checkpoints.size() * groups.size(), 0);
    refreshMembers();
    Group& added = groups.back();
    // Characters that begin in each other or in a wall part before anything is planned.
    contactSolver.resolve({parameters.character.radius, 64}, environment, characters.position);
    added.places.reset(placeDef(parameters), memory.targets, environment, regionOf(added));
    return {};
}

void World::Impl::removeGroup(std::size_t index) {
    for (std::size_t i = characters.size(); i-- > 0;) {
        if (characters.group[i] == index)
            removeCharacter(i);
        else if (characters.group[i] > index)
            --characters.group[i];
    }
    settlePlans();
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(index));
    const auto states = checkpointState.begin() + static_cast<std::ptrdiff_t>(index * checkpoints.size());
    checkpointState.erase(states, states + static_cast<std::ptrdiff_t>(checkpoints.size()));
    refreshMembers();
}

// New places appear at once where they can be reached; who takes which is planned afresh.
Status World::Impl::changeFormation(Group& group, const FormationDef& def, std::int32_t count) {
    const Result<Formation> formation = makeFormation(def, count);
    if (!formation.ok()) return formation.status().within("group '" + group.def.name + "'");
    const Status changed = group.mesh.change(*formation);
    if (!changed.ok()) return changed.within("group '" + group.def.name + "'");
    group.def.formation = def;
    group.def.count = count;
    group.controls.rebind(controlDef(parameters), group.mesh.formation().mesh, group.mesh.userMesh());
    group.mesh.placePositions(memory.targets);
    group.places.reset(placeDef(parameters), memory.targets, environment, regionOf(group));
    group.planNow = true;
    group.assigned = false;
    group.kept.clear();
    ++group.formationVersion;
    for (const std::int32_t i : group.members) characters.place[i] = -1;
    return {};
}

void World::Impl::setCount(Group& group, std::int32_t count) {
    const auto index = static_cast<std::uint32_t>(&group - groups.data());
    const Pose& pose = group.mesh.pose();
    double reach = 0.0;
    for (const Vec2 v : group.mesh.formation().mesh.vertices) reach = std::max(reach, length(v));
    const std::int32_t now = static_cast<std::int32_t>(group.members.size());
    const double step = std::max(group.def.formation.spacing, 2.2 * parameters.character.radius);
    // New ones come in ranks of ten behind the mesh.
    for (std::int32_t k = now; k < count; ++k) {
        const std::int32_t n = k - now;
        const Vec2 local{-(reach + step * (1 + n / 10)), step * (n % 10 - 4.5)};
        addCharacter(group, index, pose.apply(local));
    }
    for (std::int32_t k = now; k-- > count;) removeCharacter(static_cast<std::size_t>(group.members[k]));
    refreshMembers();
}

}  // namespace muster
