// Made by schema/generate.mjs from schema/api: change these, not this file.
// Versions of structs that callers hand over: a number per kind, and that of its members.
#pragma once

#include "bindings/c/c_world/struct_version.h"
#include "muster/muster.h"

namespace muster::c_api {

MUSTER_STRUCT_VERSION(MusterClip, 21, 1, "muster_default_clip");
MUSTER_STRUCT_VERSION(MusterBvh, 22, 1, "muster_default_bvh");

}  // namespace muster::c_api
