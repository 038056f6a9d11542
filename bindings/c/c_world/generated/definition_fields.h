// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// The fields of definitions, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/marshal.h"
#include "muster/generated/world_definitions.h"
#include "muster/muster.h"

namespace muster::c_api {

MUSTER_STRUCT_VERSION(MusterObstacleDef, 3, 1, "muster_default_obstacle_def");
MUSTER_STRUCT_VERSION(MusterClipFacts, 5, 1, "muster_default_clip_facts");
MUSTER_STRUCT_VERSION(MusterPatchDef, 4, 2, "muster_default_patch_def");
MUSTER_STRUCT_VERSION(MusterAreaDef, 18, 1, "muster_default_area_def");
MUSTER_STRUCT_VERSION(MusterPeopleDef, 17, 1, "muster_default_people_def");
MUSTER_STRUCT_VERSION(MusterFormationDef, 2, 1, "muster_default_formation_def");
MUSTER_STRUCT_VERSION(MusterOrder, 7, 2, "muster_default_order");
MUSTER_STRUCT_VERSION(MusterGroupDef, 9, 2, "muster_default_group_def");
MUSTER_STRUCT_VERSION(MusterCheckpointDef, 10, 1, "muster_default_checkpoint_def");
MUSTER_STRUCT_VERSION(MusterWorldDef, 11, 2, "muster_default_world_def");

static_assert(sizeof(MusterWaypoint) == sizeof(Waypoint));
static_assert(offsetof(MusterWaypoint, position) == offsetof(Waypoint, position));
static_assert(offsetof(MusterWaypoint, angle) == offsetof(Waypoint, angle));
static_assert(sizeof(MusterArrivals) == sizeof(Arrivals));
static_assert(offsetof(MusterArrivals, count) == offsetof(Arrivals, count));
static_assert(sizeof(MusterItemDef) == sizeof(ItemDef));
static_assert(offsetof(MusterItemDef, radius) == offsetof(ItemDef, radius));
static_assert(sizeof(MusterBody) == sizeof(Body));
static_assert(offsetof(MusterBody, maxSpeed) == offsetof(Body, maxSpeed));
static_assert(offsetof(MusterBody, acceleration) == offsetof(Body, acceleration));
static_assert(offsetof(MusterBody, mass) == offsetof(Body, mass));
static_assert(offsetof(MusterBody, supply) == offsetof(Body, supply));
static_assert(offsetof(MusterBody, unitClass) == offsetof(Body, unitClass));
static_assert(offsetof(MusterBody, headway) == offsetof(Body, headway));
static_assert(offsetof(MusterBody, premovement) == offsetof(Body, premovement));
static_assert(offsetof(MusterBody, upstairs) == offsetof(Body, upstairs));
static_assert(offsetof(MusterBody, downstairs) == offsetof(Body, downstairs));

/// Reads the preset, and what differs from it.
void parameterFields(FromC& m, const MusterWorldDef& c, Parameters& p);
/// Writes what differs from the preset "muster".
void parameterFields(ToC& m, MusterWorldDef& c, const Parameters& p);

template <class M>
void fields(M& m, C<M, MusterWaypoint>& c, P<M, Waypoint>& p) {
    m.plain(c, p);
}
template <class M>
void fields(M& m, C<M, MusterTimedPath>& c, P<M, TimedPath>& p) {
    m.list(c.waypoints, c.waypointCount, p.waypoints, "waypoints");
    m.plain(c.loop, p.loop);
}
template <class M>
void fields(M& m, C<M, MusterObstacleDef>& c, P<M, ObstacleDef>& p) {
    m.template version<MusterObstacleDef>(c.structVersion);
    m.text(c.name, p.name);
    m.part(c.polygon, p.polygon, "polygon");
    m.plain(c.centre, p.centre);
    m.plain(c.radius, p.radius);
    m.part(c.path, p.path, "path");
    m.plain(c.range, p.range);
    m.plain(c.strength, p.strength);
    m.plain(c.height, p.height);
}
template <class M>
void fields(M& m, C<M, MusterClipFacts>& c, P<M, ClipFacts>& p) {
    m.template version<MusterClipFacts>(c.structVersion);
    m.text(c.name, p.name);
    m.text(c.file, p.file);
    m.plain(c.speed, p.speed);
    m.plain(c.length, p.length);
    m.plain(c.duration, p.duration);
    m.plain(c.cyclic, p.cyclic);
    m.plain(c.transitionTime, p.transitionTime);
    m.plain(c.reachAhead, p.reachAhead);
    m.plain(c.reachBehind, p.reachBehind);
}
template <class M>
void fields(M& m, C<M, MusterPatchDef>& c, P<M, PatchDef>& p) {
    m.template version<MusterPatchDef>(c.structVersion);
    m.text(c.name, p.name);
    m.part(c.polygon, p.polygon, "polygon");
    m.part(c.path, p.path, "path");
    m.plain(c.motion, p.motion);
    m.plain(c.speed, p.speed);
    m.optional(c.hasAscent, c.ascent, p.ascent);
    m.plain(c.speedDown, p.speedDown);
}
template <class M>
void fields(M& m, C<M, MusterArrivals>& c, P<M, Arrivals>& p) {
    m.plain(c, p);
}
template <class M>
void fields(M& m, C<M, MusterAreaDef>& c, P<M, AreaDef>& p) {
    m.template version<MusterAreaDef>(c.structVersion);
    m.text(c.name, p.name);
    m.choice(c.kind, p.kind, kLastOf<AreaKind>, "kind");
    m.part(c.polygon, p.polygon, "polygon");
    m.plain(c.open, p.open);
    m.plain(c.rate, p.rate);
    m.list(c.queue, c.queueCount, p.queue, "queue");
    m.plain(c.group, p.group);
    m.plain(c.from, p.from);
    m.plain(c.until, p.until);
    m.plain(c.most, p.most);
    m.list(c.timetable, c.timetableCount, p.timetable, "timetable");
}
template <class M>
void fields(M& m, C<M, MusterItemDef>& c, P<M, ItemDef>& p) {
    m.plain(c, p);
}
template <class M>
void fields(M& m, C<M, MusterBody>& c, P<M, Body>& p) {
    m.plain(c, p);
}
template <class M>
void fields(M& m, C<M, MusterRoleDef>& c, P<M, RoleDef>& p) {
    m.choice(c.area, p.area, kLastOf<RoleArea>, "area");
    m.plain(c.unitClass, p.unitClass);
}
template <class M>
void fields(M& m, C<M, MusterDistribution>& c, P<M, Distribution>& p) {
    m.choice(c.spread, p.spread, kLastOf<Spread>, "spread");
    m.plain(c.a, p.a);
    m.plain(c.b, p.b);
    m.plain(c.least, p.least);
    m.plain(c.most, p.most);
}
template <class M>
void fields(M& m, C<M, MusterPeopleDef>& c, P<M, PeopleDef>& p) {
    m.template version<MusterPeopleDef>(c.structVersion);
    m.text(c.name, p.name);
    m.plain(c.share, p.share);
    m.plain(c.unitClass, p.unitClass);
    m.part(c.speed, p.speed, "speed");
    m.part(c.radius, p.radius, "radius");
    m.part(c.headway, p.headway, "headway");
    m.part(c.premovement, p.premovement, "premovement");
    m.part(c.age, p.age, "age");
    m.plain(c.upstairs, p.upstairs);
    m.plain(c.downstairs, p.downstairs);
}
template <class M>
void fields(M& m, C<M, MusterFormationDef>& c, P<M, FormationDef>& p) {
    m.template version<MusterFormationDef>(c.structVersion);
    m.choice(c.kind, p.kind, kLastOf<FormationKind>, "kind");
    m.plain(c.spacing, p.spacing);
    m.plain(c.opening, p.opening);
    m.part(c.outline, p.outline.outline, "outline");
    m.items(c.holes, c.holeCount, p.outline.holes, "holes");
    m.list(c.points, c.pointCount, p.points, "points");
    m.plain(c.files, p.files);
}
template <class M>
void fields(M& m, C<M, MusterOrder>& c, P<M, Order>& p) {
    m.template version<MusterOrder>(c.structVersion);
    m.choice(c.kind, p.kind, kLastOf<OrderKind>, "kind");
    m.choice(c.manner, p.manner, kLastOf<Manner>, "manner");
    m.choice(c.turn, p.turn, kLastOf<Turn>, "turn");
    m.plain(c.target, p.target);
    m.optional(c.hasFacing, c.facing, p.facing);
    m.plain(c.width, p.width);
    m.list(c.route, c.routeCount, p.route, "route");
    m.optionalPart(c.formation, p.formation, "formation");
    m.plain(c.pace, p.pace);
    m.plain(c.share, p.share);
    m.id(c.group, p.group);
    m.plain(c.character, p.character);
    m.plain(c.offset, p.offset);
    m.plain(c.halfSize, p.halfSize);
    m.part(c.path, p.path, "path");
    m.list(c.exits, c.exitCount, p.exits, "exits");
    m.choice(c.choice, p.choice, kLastOf<ExitChoice>, "choice");
    m.list(c.attractions, c.attractionCount, p.attractions, "attractions");
    m.plain(c.herding, p.herding);
    m.plain(c.misjudgement, p.misjudgement);
    m.id(c.area, p.area);
    m.plain(c.seconds, p.seconds);
}
template <class M>
void fields(M& m, C<M, MusterQueuedOrder>& c, P<M, QueuedOrder>& p) {
    m.plain(c.id, p.id);
    m.part(c.order, p.order, "order");
}
template <class M>
void fields(M& m, C<M, MusterConduct>& c, P<M, Conduct>& p) {
    m.choice(c.stance, p.stance, kLastOf<Stance>, "stance");
    m.plain(c.cohesion, p.cohesion);
    m.plain(c.squeeze, p.squeeze);
    m.plain(c.avoids, p.avoids);
}
template <class M>
void fields(M& m, C<M, MusterGroupDef>& c, P<M, GroupDef>& p) {
    m.template version<MusterGroupDef>(c.structVersion);
    m.text(c.name, p.name);
    m.plain(c.count, p.count);
    m.part(c.formation, p.formation, "formation");
    m.plain(c.position, p.position);
    m.plain(c.angle, p.angle);
    m.list(c.starts, c.startCount, p.starts, "starts");
    m.plain(c.jitter, p.jitter);
    m.list(c.bodies, c.bodyCount, p.bodies, "bodies");
    m.items(c.roles, c.roleCount, p.roles, "roles");
    m.list(c.demands, c.demandCount, p.demands, "demands");
    m.part(c.conduct, p.conduct, "conduct");
    m.items(c.orders, c.orderCount, p.orders, "orders");
    m.plain(c.patrols, p.patrols);
    m.optional(c.hasColour, c.colour, p.colour);
    m.optionalChoice(c.hasBuild, c.build, p.build, kLastOf<BodyBuild>, "build");
    m.optionalChoice(c.hasMotions, c.motions, p.motions, kLastOf<MotionSet>, "motions");
    m.items(c.people, c.peopleCount, p.people, "people");
}
template <class M>
void fields(M& m, C<M, MusterGroupColour>& c, P<M, GroupColour>& p) {
    m.optional(c.hasColour, c.colour, p.colour);
}
template <class M>
void fields(M& m, C<M, MusterGroupLook>& c, P<M, GroupLook>& p) {
    m.optionalChoice(c.hasBuild, c.build, p.build, kLastOf<BodyBuild>, "build");
    m.optionalChoice(c.hasMotions, c.motions, p.motions, kLastOf<MotionSet>, "motions");
}
template <class M>
void fields(M& m, C<M, MusterCheckpointDef>& c, P<M, FormationCheckpointDef>& p) {
    m.template version<MusterCheckpointDef>(c.structVersion);
    m.plain(c.position, p.position);
    m.plain(c.radius, p.radius);
    m.part(c.formation, p.formation, "formation");
    m.plain(c.group, p.group);
    m.plain(c.once, p.once);
    m.choice(c.trigger, p.trigger, kLastOf<CheckpointTrigger>, "trigger");
    m.plain(c.share, p.share);
}
template <class M>
void fields(M& m, C<M, MusterWorldDef>& c, P<M, WorldDef>& p) {
    m.template version<MusterWorldDef>(c.structVersion);
    m.text(c.name, p.name);
    m.text(c.description, p.description);
    m.text(c.credit, p.credit);
    m.text(c.gestures, p.gestures);
    m.plain(c.box, p.box);
    m.plain(c.cell, p.cell);
    m.plain(c.seed, p.seed);
    m.items(c.clips, c.clipCount, p.clips, "clips");
    m.items(c.obstacles, c.obstacleCount, p.obstacles, "obstacles");
    m.items(c.patches, c.patchCount, p.patches, "patches");
    m.optionalPart(c.map, p.map, "map");
    m.items(c.groups, c.groupCount, p.groups, "groups");
    m.items(c.checkpoints, c.checkpointCount, p.checkpoints, "checkpoints");
    m.list(c.items, c.itemCount, p.items, "items");
    m.items(c.areas, c.areaCount, p.areas, "areas");
    m.plain(c.ring, p.ring);
    parameterFields(m, c, p.parameters);
}

}  // namespace muster::c_api
