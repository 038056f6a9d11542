#include "engine/state/group_edits.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/bounds.h"
#include "base/maths.h"
#include "base/neighbour_list.h"
#include "engine/formation/shapes/make_formation.h"
#include "engine/state/draw_person.h"
#include "engine/state/ground_class.h"
#include "engine/state/reform.h"
#include "engine/state/standing_room.h"
#include "engine/state/validation.h"
#include "engine/steering/contacts.h"

namespace muster {
namespace {

constexpr std::int32_t kStartIterations = 64;  // Rounds of contacts that part characters at their starts.
constexpr std::int32_t kJoiningRank = 10;      // Characters that join come in ranks of so many.

Pose poseOf(Vec2 position, double angle) {
    return {position, {cosine(angle), sine(angle)}};
}

/// Makes a character of a group, an index of all arrays, stand still near a position.
void standStill(WorldState& state, const Group& group, std::size_t i, Vec2 position) {
    Characters& c = state.characters;
    const double radius = radiusOf(state.parameters.character, c.body[i]);
    c.position[i] = state.environment.projectToFreeSpace(position, radius);
    c.velocity[i] = {};
    c.heading[i] = group.mesh.pose().rotation.apply({1.0, 0.0});
    c.place[i] = -1;
    c.direction[i] = {};
    c.cost[i] = 0.0;
    c.motion[i] = 0;
    c.phase[i] = MotionPhase::Steady;
    c.motionTime[i] = 0.0;
    c.patch[i] = 0;
    c.lastSingle[i] = 0;
    c.walk[i] = {c.position[i], state.stepCount, state.stepCount, false,
                 false,         c.position[i],   state.stepCount};
    c.claim[i] = {};
    c.claim[i].spot = c.position[i];
    c.claim[i].since = state.stepCount;
    c.chosen[i] = {};
    c.wanted[i] = {};
    c.goal[i] = 0;
}

/// Those of a group who come next.
std::vector<Body> nextMembers(const WorldState& state, const Group& group, std::size_t count) {
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < count; ++k)
        bodies.push_back(drawMember(group.def, group.members.size() + k, state.seed,
                                    state.nextCharacter + static_cast<std::uint32_t>(k)));
    return bodies;
}

/// One entry more in each array.
struct Extension {
    [[maybe_unused]] static constexpr bool kReading = false;

    template <class... Arrays>
    void operator()(Arrays&... arrays) const {
        (arrays.emplace_back(), ...);
    }
};

// Drops the marked entries of all arrays of characters; an archive, as far as visits go.
struct Compaction {
    [[maybe_unused]] static constexpr bool kReading = false;
    std::span<const std::uint8_t> leaves;

    template <class... Arrays>
    void operator()(Arrays&... arrays) const {
        (compact(arrays), ...);
    }
    template <class Array>
    void compact(Array& array) const {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < array.size(); ++i) {
            if (leaves[i] != 0) continue;
            if (kept != i) array[kept] = std::move(array[i]);
            ++kept;
        }
        array.resize(kept);
    }
};

Status checkNewGroup(const WorldState& state, const GroupDef& def) {
    if (state.groups.size() >= kMaxGroups)
        return {StatusCode::LimitExceeded, "a world holds at most " + std::to_string(kMaxGroups) + " groups"};
    const std::string name = "group '" + def.name + "'";
    const auto total = static_cast<std::int64_t>(state.characters.size()) + def.count;
    if (const Status fits = validateTotal(total, state.parameters); !fits.ok()) return fits.within(name);
    if (def.count < 0)
        return invalidArgument(name + ": found count " + std::to_string(def.count) + ", expected at least 0");
    if (!def.starts.empty() && std::cmp_not_equal(def.starts.size(), def.count))
        return invalidArgument(name + ": found " + std::to_string(def.starts.size()) +
                               " starts, expected one for each of its " + std::to_string(def.count) +
                               " characters");
    if (!def.demands.empty() && std::cmp_not_equal(def.demands.size(), def.count))
        return invalidArgument(name + ": found " + std::to_string(def.demands.size()) +
                               " demands, expected one for each of its " + std::to_string(def.count) +
                               " places");
    return {};
}

/// Where a character of a new group starts, before it leaves walls and others.
Vec2 startOf(const GroupDef& def, std::int32_t index, const std::vector<Vec2>& places, Random& random) {
    Vec2 start = def.starts.empty() ? places[std::min<std::size_t>(index, places.size() - 1)]
                                    : def.starts[index];
    if (def.jitter > 0.0) {
        const double x = random.uniform(-def.jitter, def.jitter);
        const double y = random.uniform(-def.jitter, def.jitter);
        start += Vec2{x, y};
    }
    return start;
}

/// Of all characters and of those who join [m].
double largestRadius(const WorldState& state, std::span<const Body> joining) {
    const Parameters::Character& usual = state.parameters.character;
    double largest = 0.0;
    for (const Body& body : state.characters.body) largest = std::max(largest, radiusOf(usual, body));
    for (const Body& body : joining) largest = std::max(largest, radiusOf(usual, body));
    return largest > 0.0 ? largest : usual.radius;
}

/// True where two of the characters still stand in each other.
bool anyInside(const WorldState& state) {
    constexpr double kDeep = 0.9;  // Diameters.
    CrowdBodies bodies;
    bodies.resolve(state.parameters.character, state.characters, {});
    const std::vector<Vec2>& positions = state.characters.position;
    NeighbourList neighbours;
    neighbours.build(positions, kDeep * 2.0 * bodies.largestRadius());
    return std::any_of(neighbours.pairs().begin(), neighbours.pairs().end(), [&](NeighbourPair pair) {
        const double least = kDeep * bodies.touching(pair.low, pair.high);
        return lengthSquared(positions[pair.high] - positions[pair.low]) < least * least;
    });
}

/// Characters that start in each other or in a wall part before anything is planned.
void partAtStart(WorldState& state) {
    CrowdBodies bodies;
    bodies.resolve(state.parameters.character, state.characters, {});
    Contacts().resolve({kStartIterations}, state.parameters.character, state.environment,
                       state.characters.position, nullptr, nullptr, {}, &bodies);
}

/// Where so many start in walls that there is no room beside them, all start at their places.
void startAtPlaces(WorldState& state, const Group& group) {
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        const std::int32_t i = group.members[k];
        if (group.places.fit()[k] == 0) continue;
        state.characters.position[i] = group.places.reachableTargets()[k];
        state.characters.walk[i].anchor = state.characters.position[i];
    }
    partAtStart(state);
}

/// Puts the places of a group on their reachable targets.
void resetPlaces(WorldState& state, Group& group) {
    std::vector<Vec2> targets;
    group.mesh.placePositions(targets);
    std::vector<std::int32_t> counts;
    const std::int32_t before = std::exchange(group.groundClass, groundClassFor(state, group));
    RouteGraph& routes = state.refreshRoutes(group.groundClass);
    group.places.reset(placeDefOf(state, group), targets, routes, mainRegion(state, group, counts));
    group.groundClass = before;  // Until updateGroundClasses() exchanges its plan.
}

/// A group that stands elsewhere or otherwise at once is planned from the start.
void planAfresh(WorldState& state, Group& group) {
    resetPlaces(state, group);
    group.planNow = true;
    group.assigned = false;
    group.refitted = false;
    group.lastAssignment.clear();
    ++group.formationVersion;
    group.order.begin(state.stepCount);
}

/// True where places are still far from where the mesh has them.
bool isUnderWay(const Group& group) {
    constexpr double kFar = 3.0;  // Mean distance [m].
    const std::vector<Vec2>& places = group.places.positions();
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
        sum += distance(places[k], group.places.reachableTargets()[k]);
    return sum > kFar * static_cast<double>(places.size());
}

}  // namespace

std::size_t addCharacter(WorldState& state, const Group& group, std::uint32_t groupIndex, Vec2 position,
                         const Body& body) {
    Characters& c = state.characters;
    Extension extension;
    c.visit(extension);
    c.id.back() = state.nextCharacter++;
    c.group.back() = groupIndex;
    c.body.back() = body;
    c.driver.back() = Driver::Muster;
    standStill(state, group, c.size() - 1, position);
    return c.size() - 1;
}

std::unique_ptr<Plan> makePlan(const Parameters& parameters) {
    return parameters.plan.solver == PlanSolver::Fast ? makeFastPlan() : makeExactPlan();
}

void leavePlaces(WorldState& state, Group& group) {
    for (const std::int32_t i : group.members) {
        state.characters.place[i] = -1;
        state.characters.chosen[i] = {};
    }
    group.planNow = true;
    group.provisional = group.assigned = false;
    group.slice = 0;
    group.objective = group.gapBound = 0.0;
    group.walk = {};
}

void exchangePlans(WorldState& state) {
    for (Group& group : state.groups) {
        group.plan = makePlan(state.parameters);
        group.planNow = true;
    }
}

Status addGroup(WorldState& state, const GroupDef& def) {
    if (const Status valid = checkNewGroup(state, def); !valid.ok()) return valid;
    // A group that people come to later has a mesh, and no places yet.
    const Result<Formation> formation = makeFormation(def.formation, std::max(1, def.count));
    if (!formation.ok()) return formation.status().within("group '" + def.name + "'");
    Group group;
    group.def = def;
    const Status placed = group.mesh.reset(*formation, poseOf(def.position, def.angle));
    if (!placed.ok()) return placed.within("group '" + def.name + "'");
    if (def.count == 0) group.mesh.setPlaces({});
    group.id = GroupId{state.nextGroup++};
    group.plan = makePlan(state.parameters);
    std::vector<Vec2> targets;
    group.mesh.placePositions(targets);
    const auto index = static_cast<std::uint32_t>(state.groups.size());
    const std::vector<Body> bodies = drawMembers(def, state.seed, state.nextCharacter);
    for (std::int32_t i = 0; i < def.count; ++i)
        addCharacter(state, group, index, startOf(def, i, targets, state.random), bodies[i]);
    for (const Order& order : def.orders) group.orders.orders.push_back({state.nextOrder++, order});
    group.orders.patrols = def.patrols;
    group.members.resize(def.count);
    std::iota(group.members.begin(), group.members.end(),
              static_cast<std::int32_t>(state.characters.size()) - def.count);
    state.groups.push_back(std::move(group));
    state.checkpointState.resize(state.checkpoints.size() * state.groups.size(), 0);
    partAtStart(state);
    resetPlaces(state, state.groups.back());
    if (def.starts.empty() && anyInside(state)) startAtPlaces(state, state.groups.back());
    // Nobody has moved it yet: others count it as standing from the first step.
    state.groups.back().settling = {meanOf(targets), Settling::kRestSteps};
    return {};
}

Status standAt(WorldState& state, Group& group, const Pose& pose) {
    const Formation formation = group.mesh.formation();
    if (const Status placed = group.mesh.reset(formation, pose); !placed.ok())
        return placed.within("group '" + group.def.name + "'");
    std::vector<Vec2> targets;
    group.mesh.placePositions(targets);
    for (std::size_t k = 0; k < group.members.size(); ++k) {
        const auto i = static_cast<std::size_t>(group.members[k]);
        standStill(state, group, i,
                   targets.empty() ? pose.position : targets[std::min(k, targets.size() - 1)]);
        std::erase_if(state.ownRoutes,
                      [&](const OwnRoute& route) { return route.character == state.characters.id[i]; });
    }
    partAtStart(state);
    planAfresh(state, group);
    if (anyInside(state)) startAtPlaces(state, group);
    group.visitors.clear();
    group.settling = {};
    return {};
}

void removeCharacters(Characters& characters, std::span<const std::uint8_t> leaves) {
    Compaction compaction{leaves};
    characters.visit(compaction);
}

void joinCharacters(WorldState& state, const Group& group, std::span<const Vec2> positions,
                    std::span<const Body> bodies) {
    const auto index = static_cast<std::uint32_t>(&group - state.groups.data());
    std::vector<Body> drawn;
    if (bodies.empty()) bodies = drawn = nextMembers(state, group, positions.size());
    StandingRoom room(state.environment, largestRadius(state, bodies));
    for (const Vec2 p : state.characters.position) room.occupy(p);
    for (std::size_t k = 0; k < positions.size(); ++k)
        addCharacter(state, group, index, room.take(state.environment.def().box.clamp(positions[k])),
                     bodies[std::min(k, bodies.size() - 1)]);
    state.refreshMembers();
}

void removeGroup(WorldState& state, std::size_t index) {
    Characters& characters = state.characters;
    std::vector<std::uint8_t> leaves;
    for (const std::uint32_t group : characters.group) leaves.push_back(group == index ? 1 : 0);
    removeCharacters(characters, leaves);
    for (std::uint32_t& group : characters.group) group -= group > index ? 1 : 0;
    state.groups.erase(state.groups.begin() + static_cast<std::ptrdiff_t>(index));
    const auto count = static_cast<std::ptrdiff_t>(state.checkpoints.size());
    const auto first = state.checkpointState.begin() + static_cast<std::ptrdiff_t>(index) * count;
    state.checkpointState.erase(first, first + count);
    state.refreshMembers();
}

Status reformGroup(WorldState& state, Group& group, const FormationDef& def) {
    HeldPlaces held;
    held.add(state, group, group);
    std::vector<std::uint32_t> ids;
    for (const std::int32_t i : group.members) ids.push_back(state.characters.id[i]);
    Result<Reform> reform = refit(state, group, held, def, ids);
    if (!reform.ok()) return reform.status().within("group '" + group.def.name + "'");
    // The formation stands where the mesh stands: nothing of the former shape is to be kept.
    if (!reform->unmoved.empty()) reform->formation.mesh.vertices = std::move(reform->unmoved);
    applyReform(state, group, std::move(*reform), group.mesh);
    group.refitted = false;
    group.order.begin(state.stepCount);
    return {};
}

Status changeFormation(WorldState& state, Group& group, const FormationDef& def, std::int32_t count) {
    if (isUnderWay(group) && count == group.def.count) return reformGroup(state, group, def);
    const Result<Formation> formation = makeFormation(def, count);
    if (!formation.ok()) return formation.status().within("group '" + group.def.name + "'");
    const Status changed = group.mesh.change(*formation);
    if (!changed.ok()) return changed.within("group '" + group.def.name + "'");
    group.def.formation = def;
    group.def.count = count;
    if (!group.def.demands.empty()) group.def.demands.resize(static_cast<std::size_t>(count), 1.0);
    group.controls.rebind(group.mesh.formation().mesh, group.mesh.userMesh());
    planAfresh(state, group);
    for (const std::int32_t i : group.members) state.characters.place[i] = -1;
    return {};
}

void setCount(WorldState& state, Group& group, std::int32_t count) {
    const auto index = static_cast<std::uint32_t>(&group - state.groups.data());
    const Pose& pose = group.mesh.pose();
    double reach = 0.0;
    for (const Vec2 v : group.mesh.formation().mesh.vertices) reach = std::max(reach, length(v));
    const auto now = static_cast<std::int32_t>(group.members.size());
    const double spacing = std::max(group.def.formation.spacing, 2.2 * state.parameters.character.radius);
    const std::vector<Body> bodies = nextMembers(state, group,
                                                 static_cast<std::size_t>(std::max(0, count - now)));
    StandingRoom room(state.environment, largestRadius(state, bodies));
    if (count > now)
        for (const Vec2 p : state.characters.position) room.occupy(p);
    for (std::int32_t k = now; k < count; ++k) {
        const std::int32_t n = k - now;
        const std::int32_t rank = 1 + n / kJoiningRank;
        const Vec2 local{-(reach + spacing * rank), spacing * (n % kJoiningRank - 4.5)};
        addCharacter(state, group, index, room.take(pose.apply(local)), bodies[n]);
    }
    if (count < now) {
        std::vector<std::uint8_t> leaves(state.characters.size(), 0);
        for (std::int32_t k = count; k < now; ++k) leaves[group.members[k]] = 1;
        removeCharacters(state.characters, leaves);
    }
    state.refreshMembers();
}

}  // namespace muster
