// Commands that put and remove things, made from typed ids and definitions.
#include "muster/command.h"

namespace muster {
namespace {

template <class Def, class AnyId>
PutThing put(std::optional<Def> PutThing::*member, const Def& def, AnyId id, GroupId group = {}) {
    PutThing put;
    put.id = id.value;
    put.*member = def;
    put.group = group;
    return put;
}

}  // namespace

PutThing putThing(const ObstacleDef& def, ObstacleId id) {
    return put(&PutThing::obstacle, def, id);
}
PutThing putThing(const PatchDef& def, PatchId id) {
    return put(&PutThing::patch, def, id);
}
PutThing putThing(const ItemDef& def, ItemId id) {
    return put(&PutThing::item, def, id);
}
PutThing putThing(const FormationCheckpointDef& def, CheckpointId id, GroupId group) {
    return put(&PutThing::checkpoint, def, id, group);
}
PutThing putThing(const AreaDef& def, AreaId id, GroupId group) {
    return put(&PutThing::area, def, id, group);
}

RemoveThing removeThing(ObstacleId id) {
    return {ThingKind::Obstacle, id.value};
}
RemoveThing removeThing(PatchId id) {
    return {ThingKind::Patch, id.value};
}
RemoveThing removeThing(ItemId id) {
    return {ThingKind::Item, id.value};
}
RemoveThing removeThing(CheckpointId id) {
    return {ThingKind::Checkpoint, id.value};
}
RemoveThing removeThing(AreaId id) {
    return {ThingKind::Area, id.value};
}

std::optional<ThingKind> thingOf(const PutThing& put) {
    if (put.obstacle) return ThingKind::Obstacle;
    if (put.patch) return ThingKind::Patch;
    if (put.item) return ThingKind::Item;
    if (put.checkpoint) return ThingKind::Checkpoint;
    return put.area ? std::optional(ThingKind::Area) : std::nullopt;
}

}  // namespace muster
