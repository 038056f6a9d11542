// Made by schema/generate.mjs from schema/api: change these, not this file.
// Versions of structs that callers hand over: a number per kind, and that of its members.
#pragma once

#include "bindings/c/c_world/struct_version.h"
#include "muster/muster.h"

namespace muster::c_api {

MUSTER_STRUCT_VERSION(MusterTake, 19, 1, "muster_default_take");
MUSTER_STRUCT_VERSION(MusterExportDef, 20, 1, "muster_default_export_def");

}  // namespace muster::c_api
