// Read-outs of what lies on a world's ground.
#include <algorithm>

#include "bindings/c/c_world/generated/view_fields.h"
#include "bindings/c/c_world/layout.h"
#include "bindings/c/c_world/world_handle.h"

namespace muster::c_api {
namespace {

template <class Tag>
Status noSuchThing(const char* kind, Id<Tag> id) {
    return {StatusCode::NotFound, std::string(kind) + ": found no " + kind + " of id " +
                                      std::to_string(id.value) + ", expected one"};
}

template <class T>
T emptyStruct() {
    T none{};
    none.structVersion = StructVersion<T>::kValue;
    return none;
}

template <class T>
void giveWhereWanted(const T** out, const T* data) {
    if (out != nullptr) *out = data;
}

}  // namespace

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterObstacle muster_default_obstacle(void) {
    return emptyStruct<MusterObstacle>();
}
MusterPatch muster_default_patch(void) {
    return emptyStruct<MusterPatch>();
}

MusterStatus muster_world_obstacle_ids(MusterWorldId world, const MusterObstacleId** outIds,
                                       int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) {
        return giveSpan(handle.world().obstacleIds(), outIds, "outIds", outCount);
    });
}

MusterStatus muster_world_obstacle(MusterWorldId world, MusterObstacleId id, MusterObstacle* outObstacle) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status fits = needStruct(outObstacle, "outObstacle"); !fits.ok()) return fits;
        const ObstacleId wanted{id};
        const auto ids = handle.world().obstacleIds();
        if (!std::binary_search(ids.begin(), ids.end(), wanted)) return noSuchThing("obstacle", wanted);
        const ObstacleView& view = handle.keep(handle.world().obstacle(wanted));
        *outObstacle = writeC<MusterObstacle>(view, handle.lend(Lent::Obstacle));
        return {};
    });
}

MusterStatus muster_world_patch_ids(MusterWorldId world, const MusterPatchId** outIds, int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) {
        return giveSpan(handle.world().patchIds(), outIds, "outIds", outCount);
    });
}

MusterStatus muster_world_patch(MusterWorldId world, MusterPatchId id, MusterPatch* outPatch) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status fits = needStruct(outPatch, "outPatch"); !fits.ok()) return fits;
        const PatchId wanted{id};
        const auto ids = handle.world().patchIds();
        if (!std::binary_search(ids.begin(), ids.end(), wanted)) return noSuchThing("patch", wanted);
        const PatchView& view = handle.keep(handle.world().patch(wanted));
        *outPatch = writeC<MusterPatch>(view, handle.lend(Lent::Patch));
        return {};
    });
}

MusterStatus muster_world_items(MusterWorldId world, const MusterItemDef** outItems,
                                const MusterItemId** outIds, const uint8_t** outCollected,
                                int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (outCount == nullptr) return nullArgument("outCount");
        const World& own = handle.world();
        giveWhereWanted(outItems, same<MusterItemDef>(own.items()));
        giveWhereWanted(outIds, same<MusterItemId>(own.itemIds()));
        giveWhereWanted(outCollected, own.collected().data());
        *outCount = static_cast<std::int32_t>(own.items().size());
        return {};
    });
}

MusterStatus muster_world_checkpoints(MusterWorldId world, const MusterCheckpointDef** outCheckpoints,
                                      const MusterCheckpointId** outIds, const MusterGroupId** outGroups,
                                      int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (outCount == nullptr) return nullArgument("outCount");
        const World& own = handle.world();
        std::int32_t count = 0;
        if (outCheckpoints != nullptr)
            *outCheckpoints = writeAll<MusterCheckpointDef>(own.checkpoints(), handle.lend(Lent::Checkpoints),
                                                            count);
        giveWhereWanted(outIds, same<MusterCheckpointId>(own.checkpointIds()));
        giveWhereWanted(outGroups, same<MusterGroupId>(own.checkpointGroups()));
        *outCount = static_cast<std::int32_t>(own.checkpoints().size());
        return {};
    });
}

MusterStatus muster_world_areas(MusterWorldId world, const MusterArea** outAreas, int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outAreas", "outCount"}, outAreas, outCount); !given.ok())
            return given;
        std::vector<AreaView> views;
        for (std::size_t a = 0; a < handle.world().areaCount(); ++a) views.push_back(handle.world().area(a));
        *outAreas = writeAll<MusterArea>(handle.keep(std::move(views)), handle.lend(Lent::Areas), *outCount);
        return {};
    });
}

MusterStatus muster_world_ring(MusterWorldId world, bool* outRing) {
    return readValue(world, outRing, "outRing", [](const World& own) { return own.ring(); });
}
