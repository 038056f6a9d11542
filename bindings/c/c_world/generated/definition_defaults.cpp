// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// Definitions as they are made at first: those of the engine, so that none stands twice.
#include "bindings/c/c_world/default_of.h"

using namespace muster;
using namespace muster::c_api;

MusterObstacleDef muster_default_obstacle_def(void) {
    return defaultOf<MusterObstacleDef, ObstacleDef>();
}
MusterClipFacts muster_default_clip_facts(void) {
    return defaultOf<MusterClipFacts, ClipFacts>();
}
MusterPatchDef muster_default_patch_def(void) {
    return defaultOf<MusterPatchDef, PatchDef>();
}
MusterAreaDef muster_default_area_def(void) {
    return defaultOf<MusterAreaDef, AreaDef>();
}
MusterItemDef muster_default_item_def(void) {
    return defaultOf<MusterItemDef, ItemDef>();
}
MusterBody muster_default_body(void) {
    return defaultOf<MusterBody, Body>();
}
MusterDistribution muster_default_distribution(void) {
    return defaultOf<MusterDistribution, Distribution>();
}
MusterPeopleDef muster_default_people_def(void) {
    return defaultOf<MusterPeopleDef, PeopleDef>();
}
MusterFormationDef muster_default_formation_def(void) {
    return defaultOf<MusterFormationDef, FormationDef>();
}
MusterOrder muster_default_order(void) {
    return defaultOf<MusterOrder, Order>();
}
MusterConduct muster_default_conduct(void) {
    return defaultOf<MusterConduct, Conduct>();
}
MusterGroupDef muster_default_group_def(void) {
    return defaultOf<MusterGroupDef, GroupDef>();
}
MusterCheckpointDef muster_default_checkpoint_def(void) {
    return defaultOf<MusterCheckpointDef, FormationCheckpointDef>();
}
MusterWorldDef muster_default_world_def(void) {
    return defaultOf<MusterWorldDef, WorldDef>();
}
