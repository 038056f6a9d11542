// The read-only views of a world, and the access of Muster's own code to its inside.
#include "muster/views.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/ground/routes/route_search.h"
#include "engine/state/bare_groups.h"
#include "engine/state/validation.h"
#include "engine/systems/commands/picked_group.h"
#include "engine/systems/events/standing.h"
#include "engine/systems/places/place_stage.h"
#include "engine/world/inspect.h"
#include "engine/world/studio_access.h"
#include "engine/world/world_engine.h"
#include "muster/world.h"

namespace muster {
namespace {

OrderForecast forecastOf(WorldEngine& engine, GroupId group, const Order& order, const Pose* from) {
    engine.finishBackgroundWork();
    const Group* const found = engine.state.findGroup(group);
    if (found == nullptr || !validate(order).ok()) {
        OrderForecast none;
        none.end = order.target;
        none.seconds = std::numeric_limits<double>::infinity();
        return none;
    }
    return engine.orders.forecast(engine.state, *found, order, from);
}

}  // namespace

std::uint32_t World::stepCount() const {
    return engine_->state.stepCount;
}
double World::time() const {
    return engine_->state.time();
}
const Parameters& World::parameters() const {
    return engine_->state.parameters;
}
CharactersView World::characters() const {
    return engine_->state.characters.view();
}
std::vector<Vec2> World::wayAhead(std::size_t character) const {
    engine_->finishBackgroundWork();
    WorldState& state = engine_->state;
    if (character >= state.characters.size() || state.characters.place[character] < 0) return {};
    const Group& group = state.groups[state.characters.group[character]];
    RouteSearch search;
    RouteGraph& routes = state.refreshRoutes(group.groundClass);
    search.start(routes, state.characters.position[character],
                 group.places.positions()[state.characters.place[character]]);
    std::int64_t whole = std::numeric_limits<std::int64_t>::max();
    const bool found = search.advance(routes, whole) == RouteStatus::Found;
    return found ? search.path() : std::vector<Vec2>{};
}
std::vector<Standing> World::standings() const {
    std::vector<Standing> standings;
    for (const StandingReport& report : inspect::standings(*this)) standings.push_back(report.standing);
    return standings;
}
std::size_t World::groupCount() const {
    return engine_->state.groups.size();
}

GroupView World::group(std::size_t index) const {
    const Group& group = engine_->state.groups[index];
    const TriangleMesh& rest = group.mesh.formation().mesh;
    GroupView view;
    view.id = group.id;
    view.name = group.def.name;
    view.colour = group.def.colour;
    view.build = group.def.build;
    view.motions = group.def.motions;
    view.count = group.def.count;
    view.formation = group.def.formation.kind;
    view.formationVersion = group.formationVersion;
    view.pose = group.mesh.pose();
    view.members = group.members;
    view.restMesh = rest.vertices;
    view.userMesh = group.mesh.userMesh();
    view.finalMesh = group.mesh.finalMesh();
    view.triangles = rest.triangles;
    view.controls = group.controls.controls();
    view.meshPlaces = group.mesh.formation().places;
    view.placePositions = group.places.positions();
    view.placeVelocities = group.places.velocities();
    view.placeTargets = group.places.reachableTargets();
    view.placeUsable = group.places.fit();
    view.placeClasses = group.placeClass;
    view.objective = group.objective;
    view.gapBound = group.gapBound;
    view.walk = group.walk;
    view.meanLag = group.meanLag;
    const OrderQueue& queue = group.orders;
    view.orders = queue.orders;
    view.held = queue.held;
    view.patrols = queue.patrols;
    view.conduct = group.def.conduct;
    view.way = queue.march.ahead();
    return view;
}

GroupDef World::groupDef(std::size_t index) const {
    const WorldState& state = engine_->state;
    const Group& group = state.groups[index];
    GroupDef def = group.def;
    // While members come and go freely their bodies are not listed.
    if (isBare(group) && def.bodies.size() > 1) {
        def.bodies.clear();
        for (const std::int32_t i : group.members) def.bodies.push_back(state.characters.body[i]);
    }
    return def;
}

OrderForecast World::forecast(GroupId group, const Order& order) const {
    return forecastOf(*engine_, group, order, nullptr);
}

std::span<const ObstacleId> World::obstacleIds() const {
    return engine_->state.environment.obstacleIds();
}

ObstacleView World::obstacle(ObstacleId id) const {
    const ObstacleDef* def = engine_->state.environment.obstacle(id);
    if (def == nullptr) return {};
    return {id, *def, engine_->state.environment.obstaclePolygon(id),
            engine_->state.environment.obstacleCentre(id)};
}

std::span<const PatchId> World::patchIds() const {
    return engine_->state.environment.patchIds();
}

PatchView World::patch(PatchId id) const {
    const PatchDef* def = engine_->state.environment.patch(id);
    if (def == nullptr) return {};
    return {id, *def, engine_->state.environment.patchPolygon(id)};
}

std::span<const ItemDef> World::items() const {
    return engine_->state.items;
}
std::span<const std::uint8_t> World::collected() const {
    return engine_->state.collected;
}
std::span<const FormationCheckpointDef> World::checkpoints() const {
    return engine_->state.checkpoints;
}
std::span<const ItemId> World::itemIds() const {
    return engine_->state.itemIds;
}
std::span<const CheckpointId> World::checkpointIds() const {
    return engine_->state.checkpointIds;
}
std::span<const GroupId> World::checkpointGroups() const {
    return engine_->state.checkpointGroups;
}
std::size_t World::areaCount() const {
    return engine_->state.areas.size();
}
AreaView World::area(std::size_t index) const {
    if (index >= engine_->state.areas.size()) return {};
    const Area& area = engine_->state.areas[index];
    return {area.id, area.def, area.group, area.count};
}
bool World::ring() const {
    return engine_->state.environment.def().ring;
}
std::span<const Event> World::events() const {
    return engine_->events;
}
std::span<const Rejection> World::rejections() const {
    return engine_->rejections;
}
StageTimes World::stageTimes() const {
    return engine_->times;
}
ContactReport World::contacts() const {
    return engine_->contactReport;
}
std::uint32_t World::lastCommandStep() const {
    return engine_->state.lastCommandStep;
}

OrderForecast forecastFrom(const World& world, GroupId group, const Order& order, const Pose& from) {
    WorldEngine& engine = WorldAccess::of(world);
    const Pose inside{engine.state.environment.def().box.clamp(from.position), from.rotation};
    return forecastOf(engine, group, order, &inside);
}

namespace inspect {

const Environment& environment(const World& world) {
    return WorldAccess::of(world).state.environment;
}
const Characters& characters(const World& world) {
    return WorldAccess::of(world).state.characters;
}
const DensityField& density(const World& world) {
    return WorldAccess::of(world).cost.density();
}
const UnitCost* unitCost(const World& world) {
    WorldEngine& engine = WorldAccess::of(world);
    return engine.state.stepCount == 0 ? nullptr : &engine.cost.unitCost();
}
std::optional<std::size_t> indexOfGroup(const World& world, GroupId id) {
    const std::vector<Group>& groups = WorldAccess::of(world).state.groups;
    const auto at = std::lower_bound(groups.begin(), groups.end(), id,
                                     [](const Group& group, GroupId of) { return group.id < of; });
    if (at == groups.end() || at->id != id) return std::nullopt;
    return static_cast<std::size_t>(at - groups.begin());
}
double distanceLeft(const World& world, std::size_t character) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const WorldState& state = WorldAccess::of(world).state;
    const Characters& c = state.characters;
    const Group& group = state.groups[c.group[character]];
    if (const Gathering* const gathering = state.continuum.find(group.id)) {
        if (gathering->isBare()) return c.cost[character];
        const double reach = gatheringReach(group.members.size(), state.parameters.character.radius);
        const double beyond = distance(c.position[character], gathering->target) - reach;
        return gathering->hasArrived(c.id[character]) ? 0.0 : std::max(0.0, beyond);
    }
    const std::int32_t place = c.place[character];
    if (place < 0 || std::cmp_greater_equal(place, group.places.positions().size())) return kNone;
    const double left = distance(c.position[character], group.places.positions()[place]);
    const OrderQueue& queue = group.orders;
    if (!queue.begun || queue.held || queue.orders.empty()) return left;
    const OrderKind kind = queue.orders.front().order.kind;
    if (kind != OrderKind::Move && kind != OrderKind::Face) return left;
    if (queue.march.phase != MarchPhase::Stand) return kNone;
    return std::max(left, distance(c.position[character], group.places.reachableTargets()[place]));
}
std::vector<StandingReport> standings(const World& world) {
    WorldEngine& engine = WorldAccess::of(world);
    WorldState& state = engine.state;
    if (state.routes.version() == 0) {  // No step was made yet.
        engine.finishBackgroundWork();
        refreshRoutes(state);
    }
    std::vector<StandingReport> reports(state.characters.size());
    for (const Group& group : state.groups) judgeStandings(state, group, reports);
    return reports;
}
bool leaves(const World& world, std::size_t character) {
    const WorldState& state = WorldAccess::of(world).state;
    const GroupId group = state.groups[state.characters.group[character]].id;
    const Gathering* const gathering = state.continuum.find(group);
    return gathering != nullptr && gathering->kind == OrderKind::Leave;
}
std::int32_t doorWay(const World& world, std::size_t character) {
    const WorldState& state = WorldAccess::of(world).state;
    const GroupId group = state.groups[state.characters.group[character]].id;
    const Gathering* const gathering = state.continuum.find(group);
    if (gathering == nullptr) return -1;
    for (const DoorWay& own : gathering->ways)
        if (own.character == state.characters.id[character]) return own.way;
    return -1;
}
bool maySend(const World& world, std::size_t area) {
    const WorldState& state = WorldAccess::of(world).state;
    const Area& source = state.areas[area];
    const bool isFor = std::any_of(state.groups.begin(), state.groups.end(),
                                   [&](const Group& group) { return group.id == source.group; });
    return source.def.kind == AreaKind::Source && source.def.open && isFor && maySend(source);
}
std::optional<std::size_t> pickedGroup(const World& world, Vec2 p) {
    return muster::pickedGroup(WorldAccess::of(world).state, p);
}
const GroupDef& groupDef(const World& world, std::size_t group) {
    return WorldAccess::of(world).state.groups[group].def;
}
const FormationDef& ownFormation(const World& world, std::size_t group) {
    const Group& of = WorldAccess::of(world).state.groups[group];
    return of.orders.own ? *of.orders.own : of.def.formation;
}
const FormationMesh& mesh(const World& world, std::size_t group) {
    return WorldAccess::of(world).state.groups[group].mesh;
}
const PlaceTracker& places(const World& world, std::size_t group) {
    return WorldAccess::of(world).state.groups[group].places;
}
const Plan& plan(const World& world, std::size_t group) {
    return *WorldAccess::of(world).state.groups[group].plan;
}

}  // namespace inspect
}  // namespace muster
