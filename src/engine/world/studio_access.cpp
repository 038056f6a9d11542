#include "engine/world/studio_access.h"

#include <cmath>

#include "engine/formation/shapes/make_formation.h"
#include "engine/ground/environment/environment.h"
#include "engine/state/validation.h"
#include "engine/systems/events/standing.h"
#include "engine/world/world_engine.h"

namespace muster {

std::vector<Standing> barsOf(const World& world, GroupId group, std::span<const Vec2> places) {
    WorldEngine& engine = WorldAccess::of(world);
    engine.finishBackgroundWork();
    std::vector<Standing> bars(places.size(), Standing::InPlace);
    const Group* const found = engine.state.findGroup(group);
    if (found == nullptr) return bars;
    const RouteGraph& routes = engine.state.refreshRoutes(found->groundClass);
    std::vector<std::int32_t> counts;
    const std::int32_t region = mainRegion(engine.state, *found, counts);
    const Environment& environment = engine.state.environment;
    const Grid& grid = environment.grid();
    const auto clearance = environment.staticClearance();
    // The clearance of a cell's centre is off by at most half the cell's diagonal.
    const double least = routes.radius() - 0.5 * std::sqrt(2.0) * grid.cell;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Vec2 p = places[k];
        const std::int32_t label = routes.region(p);
        const float clear = clearance[static_cast<std::size_t>(grid.index(grid.nearestCell(p)))];
        if (!environment.def().box.contains(p) || label < 0 || clear < least ||
            (region >= 0 && label != region))
            bars[k] = barOf(engine.state, *found, region, p);
        if (bars[k] == Standing::Crowded) bars[k] = Standing::Narrow;
    }
    return bars;
}

Result<std::vector<Vec2>> placesAt(const FormationDef& formation, int count, const Pose& at) {
    const Result<Formation> made = makeFormation(formation, count);
    if (!made.ok()) return made.status();
    std::vector<Vec2> places;
    for (const MeshPoint& place : made->places)
        places.push_back(at.apply(place.position(made->mesh.triangles, made->mesh.vertices)));
    return places;
}

Result<std::vector<Vec2>> placesAt(const World& world, GroupId group, const FormationDef& formation,
                                   const Pose& at, int count) {
    const Group* const found = WorldAccess::of(world).state.findGroup(group);
    if (found == nullptr) return Status(StatusCode::NotFound, "there is no such group");
    if (Status status = validate(formation); !status.ok()) return status;
    const int people = count > 0 ? count : found->def.count;
    if (people < 1) return std::vector<Vec2>{};
    return placesAt(formation, people, at);
}

std::size_t dropWaitingCommands(World& world) {
    std::vector<Command>& queue = WorldAccess::of(world).state.queue;
    const std::size_t dropped = queue.size();
    queue.clear();
    return dropped;
}

}  // namespace muster
