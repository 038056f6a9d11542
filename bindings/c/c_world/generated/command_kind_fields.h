// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// The fields of each kind of command, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <tuple>
#include <variant>

#include "bindings/c/c_world/world_fields.h"
#include "muster/command.h"
#include "muster/muster.h"

namespace muster::c_api {

template <class M>
void fields(M& m, C<M, MusterTouch>& c, P<M, Touch>& p) {
    m.choice(c.phase, p.phase, kLastOf<TouchPhase>, "phase");
    m.plain(c.touch, p.touch);
    m.plain(c.position, p.position);
    m.plain(c.time, p.time);
    m.id(c.group, p.group);
}
template <class M>
void fields(M& m, C<M, MusterAddControl>& c, P<M, AddControl>& p) {
    m.id(c.group, p.group);
    m.choice(c.kind, p.kind, kLastOf<ControlKind>, "kind");
    m.list(c.touches, c.touchCount, p.touches, "touches");
    m.list(c.positions, c.positionCount, p.positions, "positions");
    m.plain(c.time, p.time);
}
template <class M>
void fields(M& m, C<M, MusterEditControl>& c, P<M, EditControl>& p) {
    m.id(c.group, p.group);
    m.id(c.control, p.control);
    m.choice(c.edit, p.edit, kLastOf<ControlEdit>, "edit");
}
template <class M>
void fields(M& m, C<M, MusterReleaseClient>& c, P<M, ReleaseClient>& p) {
    m.plain(c.unused, p.unused);
}
template <class M>
void fields(M& m, C<M, MusterChangeGroup>& c, P<M, ChangeGroup>& p) {
    m.id(c.group, p.group);
    m.optionalPart(c.formation, p.formation, "formation");
    m.optional(c.hasCount, c.count, p.count);
    if (m.given(c.hasPeople, p.people)) m.items(c.people, c.peopleCount, *p.people, "people");
    m.optionalPart(c.conduct, p.conduct, "conduct");
    if (m.given(c.hasRoles, p.roles)) m.items(c.roles, c.roleCount, *p.roles, "roles");
    if (m.given(c.hasDemands, p.demands)) m.list(c.demands, c.demandCount, *p.demands, "demands");
    if (m.given(c.hasName, p.name)) m.text(c.name, *p.name);
    m.optionalPart(c.colour, p.colour, "colour");
    m.optionalPart(c.look, p.look, "look");
}
template <class M>
void fields(M& m, C<M, MusterSetPose>& c, P<M, SetPose>& p) {
    m.id(c.group, p.group);
    m.plain(c.position, p.position);
    m.plain(c.angle, p.angle);
    m.plain(c.characters, p.characters);
}
template <class M>
void fields(M& m, C<M, MusterAddGroup>& c, P<M, AddGroup>& p) {
    m.part(c.group, p.group, "group");
}
template <class M>
void fields(M& m, C<M, MusterRemoveGroup>& c, P<M, RemoveGroup>& p) {
    m.id(c.group, p.group);
}
template <class M>
void fields(M& m, C<M, MusterPutThing>& c, P<M, PutThing>& p) {
    m.plain(c.id, p.id);
    m.optionalPart(c.obstacle, p.obstacle, "obstacle");
    m.optionalPart(c.patch, p.patch, "patch");
    m.optionalPart(c.item, p.item, "item");
    m.optionalPart(c.checkpoint, p.checkpoint, "checkpoint");
    m.optionalPart(c.area, p.area, "area");
    m.id(c.group, p.group);
}
template <class M>
void fields(M& m, C<M, MusterRemoveThing>& c, P<M, RemoveThing>& p) {
    m.choice(c.thing, p.thing, kLastOf<ThingKind>, "thing");
    m.plain(c.id, p.id);
}
template <class M>
void fields(M& m, C<M, MusterSetParameter>& c, P<M, SetParameter>& p) {
    m.text(c.name, p.name);
    m.plain(c.value, p.value);
}
template <class M>
void fields(M& m, C<M, MusterGiveOrder>& c, P<M, GiveOrder>& p) {
    m.id(c.group, p.group);
    m.choice(c.mode, p.mode, kLastOf<QueueMode>, "mode");
    m.plain(c.index, p.index);
    m.part(c.order, p.order, "order");
}
template <class M>
void fields(M& m, C<M, MusterEditQueue>& c, P<M, EditQueue>& p) {
    m.id(c.group, p.group);
    m.choice(c.edit, p.edit, kLastOf<QueueEdit>, "edit");
    m.plain(c.order, p.order);
}
template <class M>
void fields(M& m, C<M, MusterAddCharacters>& c, P<M, AddCharacters>& p) {
    m.id(c.group, p.group);
    m.list(c.positions, c.positionCount, p.positions, "positions");
    m.list(c.bodies, c.bodyCount, p.bodies, "bodies");
}
template <class M>
void fields(M& m, C<M, MusterTransferCharacters>& c, P<M, TransferCharacters>& p) {
    m.list(c.ids, c.idCount, p.ids, "ids");
    m.id(c.group, p.group);
}
template <class M>
void fields(M& m, C<M, MusterSplitGroup>& c, P<M, SplitGroup>& p) {
    m.id(c.group, p.group);
    m.choice(c.by, p.by, kLastOf<SplitBy>, "by");
    m.list(c.ids, c.idCount, p.ids, "ids");
    m.list(c.points, c.pointCount, p.points, "points");
    m.list(c.shares, c.shareCount, p.shares, "shares");
    m.plain(c.abreast, p.abreast);
    m.choice(c.shape, p.shape, kLastOf<PartShape>, "shape");
}
template <class M>
void fields(M& m, C<M, MusterMergeGroups>& c, P<M, MergeGroups>& p) {
    m.list(c.groups, c.groupCount, p.groups, "groups");
    m.choice(c.shape, p.shape, kLastOf<PartShape>, "shape");
}
template <class M>
void fields(M& m, C<M, MusterChangeCharacters>& c, P<M, ChangeCharacters>& p) {
    m.list(c.ids, c.idCount, p.ids, "ids");
    if (m.given(c.hasBodies, p.bodies)) m.list(c.bodies, c.bodyCount, *p.bodies, "bodies");
    m.optionalChoice(c.hasDriver, c.driver, p.driver, kLastOf<Driver>, "driver");
}
template <class M>
void fields(M& m, C<M, MusterWriteMotion>& c, P<M, WriteMotion>& p) {
    m.list(c.ids, c.idCount, p.ids, "ids");
    m.list(c.positions, c.positionCount, p.positions, "positions");
    m.list(c.velocities, c.velocityCount, p.velocities, "velocities");
}
template <class M>
void fields(M& m, C<M, MusterReverseQueue>& c, P<M, ReverseQueue>& p) {
    m.id(c.group, p.group);
}

/// The members of the C union, in the order of the engine's alternatives.
// clang-format off
inline constexpr std::tuple kCommandMembers{
    &MusterCommandBody::touch,
    &MusterCommandBody::addControl,
    &MusterCommandBody::editControl,
    &MusterCommandBody::releaseClient,
    &MusterCommandBody::changeGroup,
    &MusterCommandBody::setPose,
    &MusterCommandBody::addGroup,
    &MusterCommandBody::removeGroup,
    &MusterCommandBody::putThing,
    &MusterCommandBody::removeThing,
    &MusterCommandBody::setParameter,
    &MusterCommandBody::giveOrder,
    &MusterCommandBody::editQueue,
    &MusterCommandBody::addCharacters,
    &MusterCommandBody::transferCharacters,
    &MusterCommandBody::splitGroup,
    &MusterCommandBody::mergeGroups,
    &MusterCommandBody::changeCharacters,
    &MusterCommandBody::writeMotion,
    &MusterCommandBody::reverseQueue,
};
// clang-format on
static_assert(std::tuple_size_v<decltype(kCommandMembers)> == std::variant_size_v<CommandKinds> &&
              std::variant_size_v<CommandKinds> == MUSTER_COMMAND_COUNT);

}  // namespace muster::c_api
