// Versions of the structs that callers hand over: a number per kind, so that none is taken for another.
#pragma once

#include <cstdint>
#include <string>

#include "bindings/c/c_world/call.h"
#include "muster/c/people.h"
#include "muster/c/world_def.h"

namespace muster::c_api {

/// What `structVersion` holds in a struct of type T, and who sets it.
template <class T>
struct StructVersion;

constexpr std::uint32_t structVersion(std::uint32_t kind, std::uint32_t version) {
    return kind << 16 | version;
}

#define MUSTER_STRUCT_VERSION(type, kind, version, maker)                     \
    template <>                                                               \
    struct StructVersion<type> {                                              \
        static constexpr std::uint32_t kValue = structVersion(kind, version); \
        static constexpr const char* kMaker = maker;                          \
    }

// Those that schema/api declares stand in generated/struct_versions.h.
MUSTER_STRUCT_VERSION(MusterFormationDef, 2, 1, "muster_default_formation_def");
MUSTER_STRUCT_VERSION(MusterObstacleDef, 3, 1, "muster_default_obstacle_def");
MUSTER_STRUCT_VERSION(MusterPatchDef, 4, 2, "muster_default_patch_def");
MUSTER_STRUCT_VERSION(MusterClipFacts, 5, 1, "muster_default_clip_facts");
MUSTER_STRUCT_VERSION(MusterMapDef, 6, 1, "muster_default_map_def");
MUSTER_STRUCT_VERSION(MusterOrder, 7, 2, "muster_default_order");
MUSTER_STRUCT_VERSION(MusterForecast, 8, 1, "muster_default_forecast");
MUSTER_STRUCT_VERSION(MusterGroupDef, 9, 2, "muster_default_group_def");
MUSTER_STRUCT_VERSION(MusterCheckpointDef, 10, 1, "muster_default_checkpoint_def");
MUSTER_STRUCT_VERSION(MusterWorldDef, 11, 2, "muster_default_world_def");
MUSTER_STRUCT_VERSION(MusterPeopleDef, 17, 1, "muster_default_people_def");
MUSTER_STRUCT_VERSION(MusterAreaDef, 18, 1, "muster_default_area_def");

/// Fails where a struct that is to be filled is null or of another version.
template <class T>
Status needStruct(const T* out, const char* name) {
    if (out == nullptr) return nullArgument(name);
    if (out->structVersion == StructVersion<T>::kValue) return {};
    return invalidArgument(std::string(name) + ": found structVersion " + std::to_string(out->structVersion) +
                           ", expected " + std::to_string(StructVersion<T>::kValue) + " as " +
                           StructVersion<T>::kMaker + "() sets it");
}

}  // namespace muster::c_api
