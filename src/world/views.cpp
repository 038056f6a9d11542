// The read-only views of a world, and what Muster's own code sees of its inside.
#include "muster/views.h"

#include <algorithm>
#include <cmath>

#include "muster/world.h"
#include "world/inspect.h"
#include "world/state/world_state.h"

namespace muster {

const char* stageName(Stage stage) {
    constexpr const char* kNames[] = {"commands", "controls",         "user mesh", "final mesh",
                                      "places",   "density and cost", "plan",      "steering",
                                      "contacts", "patches",          "events"};
    return stage < Stage::Count ? kNames[static_cast<std::size_t>(stage)] : "none";
}

void WalkTotals::add(double walk) {
    if (!std::isfinite(walk)) return;
    sum += walk;
    squares += walk * walk;
    longest = std::max(longest, walk);
}

void WalkTotals::add(const WalkTotals& others) {
    sum += others.sum;
    squares += others.squares;
    longest = std::max(longest, others.longest);
}

std::uint32_t World::stepCount() const {
    return impl_->stepCount;
}
double World::time() const {
    return impl_->time();
}
const Parameters& World::parameters() const {
    return impl_->parameters;
}
CharactersView World::characters() const {
    return impl_->characters.view();
}
std::size_t World::groupCount() const {
    return impl_->groups.size();
}

GroupView World::group(std::size_t index) const {
    const Group& group = impl_->groups[index];
    const TriangleMesh& rest = group.mesh.formation().mesh;
    GroupView view;
    view.id = group.id;
    view.name = group.def.name;
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
    view.objective = group.objective;
    view.gapBound = group.gapBound;
    view.walk = group.walk;
    view.meanLag = group.meanLag;
    return view;
}

GroupDef World::groupDef(std::size_t index) const {
    return impl_->groups[index].def;
}

std::span<const ObstacleId> World::obstacleIds() const {
    return impl_->environment.obstacleIds();
}

ObstacleView World::obstacle(ObstacleId id) const {
    const ObstacleDef* def = impl_->environment.obstacle(id);
    if (def == nullptr) return {};
    return {id, *def, impl_->environment.obstaclePolygon(id), impl_->environment.obstacleCentre(id)};
}

std::span<const PatchId> World::patchIds() const {
    return impl_->environment.patchIds();
}

PatchView World::patch(PatchId id) const {
    const PatchDef* def = impl_->environment.patch(id);
    if (def == nullptr) return {};
    return {id, *def, impl_->environment.patchPolygon(id)};
}

std::span<const ItemDef> World::items() const {
    return impl_->items;
}
std::span<const std::uint8_t> World::collected() const {
    return impl_->collected;
}
std::span<const FormationCheckpointDef> World::checkpoints() const {
    return impl_->checkpoints;
}
std::span<const Event> World::events() const {
    return impl_->events;
}
std::span<const Rejection> World::rejections() const {
    return impl_->rejections;
}
StageTimes World::stageTimes() const {
    return impl_->times;
}
ContactReport World::contacts() const {
    return impl_->contacts;
}
std::uint32_t World::lastCommandStep() const {
    return impl_->lastCommandStep;
}

namespace inspect {

const Environment& environment(const World& world) {
    return WorldAccess::of(world).environment;
}
const Characters& characters(const World& world) {
    return WorldAccess::of(world).characters;
}
const DensityField& density(const World& world) {
    return WorldAccess::of(world).density;
}
const UnitCost* unitCost(const World& world) {
    return WorldAccess::of(world).unitCostNow();
}
const GroupDef& groupDef(const World& world, std::size_t group) {
    return WorldAccess::of(world).groups[group].def;
}
const FormationMesh& mesh(const World& world, std::size_t group) {
    return WorldAccess::of(world).groups[group].mesh;
}
const PlaceTracker& places(const World& world, std::size_t group) {
    return WorldAccess::of(world).groups[group].places;
}
const Plan& plan(const World& world, std::size_t group) {
    return *WorldAccess::of(world).groups[group].plan;
}

}  // namespace inspect
}  // namespace muster
