// Formations by name, timed paths, maps.
#include "bindings/c/c_world/handle_table.h"
#include "bindings/c/c_world/world_fields.h"
#include "muster/muster.h"
#include "muster/order.h"

namespace muster::c_api {
namespace {

/// A map, and the ground that was last made from it.
struct MapThing {
    MapGround ground;
    std::vector<ObstacleDef> obstacles;
    std::vector<PatchDef> patches;
    Arena arena;
};

using Maps = HandleTable<MusterMapId, MapThing>;

Maps& maps() {
    static Maps& table = *new Maps("map");
    return table;
}

Status readPlacement(const MusterMapDef* placement, MapDef& def) {
    if (const Status fits = needStruct(placement, "placement"); !fits.ok()) return fits;
    def.metresPerCell = placement->metresPerCell;
    def.origin = {placement->origin.x, placement->origin.y};
    def.swampSpeed = placement->swampSpeed;
    return {};
}

/// Makes the ground of a map by `make` and gives it as C structs.
template <class A, class Made, class Make>
MusterStatus makeGround(MusterMapId map, const MusterMapDef* placement, Made MapThing::*made, const A** out,
                        const char* name, int32_t* outCount, Make&& make) noexcept {
    return call([&]() -> Status {
        if (const Status given = needPointers({name, "outCount"}, out, outCount); !given.ok()) return given;
        const Result<MapThing*> found = maps().find(map);
        if (!found.ok()) return found.status();
        MapDef def;
        if (const Status fits = readPlacement(placement, def); !fits.ok()) return fits;
        MapThing& thing = **found;
        thing.arena.reset();
        thing.*made = make(thing.ground.grid, def);
        *out = writeAll<A>(thing.*made, thing.arena, *outCount);
        return {};
    });
}

}  // namespace
}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

const char* muster_formation_name(MusterFormationKind kind) {
    return kind <= MUSTER_FORMATION_POINTS ? formationName(static_cast<FormationKind>(kind)).data() : nullptr;
}

MusterStatus muster_formation_kind(const char* name, MusterFormationKind* outKind) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"name", "outKind"}, name, outKind); !given.ok()) return given;
        const Result<FormationKind> kind = formationKind(name);
        if (kind.ok()) *outKind = static_cast<MusterFormationKind>(*kind);
        return kind.status();
    });
}

MusterStatus muster_timed_path_at(const MusterTimedPath* path, double time, MusterPathState* outState) {
    return call([&]() -> Status {
        if (outState == nullptr) return nullArgument("outState");
        TimedPath read;
        if (const Status fits = readC(path, read, "path"); !fits.ok()) return fits;
        if (const Status valid = read.validate(); !valid.ok()) return valid;
        if (!(time > -1e9 && time < 1e9)) return invalidArgument("time: found no number from -1e9 to 1e9");
        const Waypoint at = read.at(time);
        const Vec2 velocity = read.velocity(time);
        *outState = {{at.time, {at.position.x, at.position.y}, at.angle},
                     {velocity.x, velocity.y},
                     read.angularVelocity(time)};
        return {};
    });
}

MusterStatus muster_map_parse(const char* text, size_t size, MusterMapId* outMap) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"text", "outMap"}, text, outMap); !given.ok()) return given;
        *outMap = {0, 0};
        Result<MapGrid> grid = parseMap(std::string(text, size));
        if (!grid.ok()) return grid.status();
        auto thing = std::make_unique<MapThing>();
        thing->ground.grid = *std::move(grid);
        *outMap = maps().add(std::move(thing));
        return {};
    });
}

MusterStatus muster_map_destroy(MusterMapId map) {
    return call([&] { return maps().destroy(map); });
}

MusterStatus muster_map_def(MusterMapId map, MusterMapDef* outDef) {
    return call([&]() -> Status {
        if (const Status fits = needStruct(outDef, "outDef"); !fits.ok()) return fits;
        const Result<MapThing*> found = maps().find(map);
        if (!found.ok()) return found.status();
        Arena none;
        *outDef = writeC<MusterMapDef>((*found)->ground, none);
        return {};
    });
}

MusterStatus muster_map_obstacles(MusterMapId map, const MusterMapDef* placement,
                                  const MusterObstacleDef** outObstacles, int32_t* outCount) {
    return makeGround(map, placement, &MapThing::obstacles, outObstacles, "outObstacles", outCount,
                      mapObstacles);
}

MusterStatus muster_map_patches(MusterMapId map, const MusterMapDef* placement, MusterMotionIndex motion,
                                const MusterPatchDef** outPatches, int32_t* outCount) {
    return makeGround(
        map, placement, &MapThing::patches, outPatches, "outPatches", outCount,
        [motion](const MapGrid& grid, const MapDef& def) { return mapPatches(grid, def, motion); });
}
