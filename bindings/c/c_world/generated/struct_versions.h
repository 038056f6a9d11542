// Made by schema/generate.mjs from schema/api: change these, not this file.
// Versions of structs that callers hand over: a number per kind, and that of its members.
#pragma once

#include "bindings/c/c_world/struct_version.h"
#include "muster/muster.h"

namespace muster::c_api {

MUSTER_STRUCT_VERSION(MusterTaskRunner, 1, 1, "muster_default_task_runner");
MUSTER_STRUCT_VERSION(MusterMapDef, 6, 1, "muster_default_map_def");
MUSTER_STRUCT_VERSION(MusterForecast, 8, 1, "muster_default_forecast");
MUSTER_STRUCT_VERSION(MusterCommand, 12, 2, "muster_default_command");
MUSTER_STRUCT_VERSION(MusterCharacters, 13, 2, "muster_default_characters");
MUSTER_STRUCT_VERSION(MusterGroup, 14, 1, "muster_default_group");
MUSTER_STRUCT_VERSION(MusterObstacle, 15, 1, "muster_default_obstacle");
MUSTER_STRUCT_VERSION(MusterPatch, 16, 2, "muster_default_patch");

}  // namespace muster::c_api
