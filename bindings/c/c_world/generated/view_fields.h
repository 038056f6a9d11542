// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// What is read of worlds, as structs of C (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/world_fields.h"
#include "muster/event.h"
#include "muster/muster.h"
#include "muster/views.h"

namespace muster::c_api {

static_assert(sizeof(MusterWalkTotals) == sizeof(WalkTotals) &&
              offsetof(MusterWalkTotals, squares) == offsetof(WalkTotals, squares) &&
              offsetof(MusterWalkTotals, longest) == offsetof(WalkTotals, longest));
static_assert(sizeof(MusterCheckpoint) == sizeof(Checkpoint) &&
              offsetof(MusterCheckpoint, time) == offsetof(Checkpoint, time));
static_assert(sizeof(MusterEvent) == sizeof(Event) &&
              offsetof(MusterEvent, subject) == offsetof(Event, subject) &&
              offsetof(MusterEvent, value) == offsetof(Event, value) &&
              offsetof(MusterEvent, position) == offsetof(Event, position));
static_assert(sizeof(MusterContacts) == sizeof(ContactReport) &&
              offsetof(MusterContacts, worstPenetration) == offsetof(ContactReport, worstPenetration));

template <class M>
void fields(M& m, C<M, MusterCharacters>& c, P<M, CharactersView>& p) {
    m.template version<MusterCharacters>(c.structVersion);
    m.list(c.id, c.count, p.id, "id");
    m.list(c.group, c.count, p.group, "group");
    m.list(c.position, c.count, p.position, "position");
    m.list(c.velocity, c.count, p.velocity, "velocity");
    m.list(c.heading, c.count, p.heading, "heading");
    m.list(c.place, c.count, p.place, "place");
    m.list(c.direction, c.count, p.direction, "direction");
    m.list(c.cost, c.count, p.cost, "cost");
    m.list(c.motion, c.count, p.motion, "motion");
    m.list(c.phase, c.count, p.phase, "phase");
    m.list(c.motionTime, c.count, p.motionTime, "motionTime");
    m.list(c.patch, c.count, p.patch, "patch");
    m.list(c.body, c.count, p.body, "body");
    m.list(c.driver, c.count, p.driver, "driver");
    m.list(c.wantedVelocity, c.count, p.wantedVelocity, "wantedVelocity");
    m.list(c.goal, c.count, p.goal, "goal");
}
template <class M>
void fields(M& m, C<M, MusterGroup>& c, P<M, GroupView>& p) {
    m.template version<MusterGroup>(c.structVersion);
    m.id(c.id, p.id);
    m.text(c.name, p.name);
    m.optional(c.hasColour, c.colour, p.colour);
    m.optionalChoice(c.hasBuild, c.build, p.build, kLastOf<BodyBuild>, "build");
    m.optionalChoice(c.hasMotions, c.motions, p.motions, kLastOf<MotionSet>, "motions");
    m.plain(c.count, p.count);
    m.choice(c.formation, p.formation, kLastOf<FormationKind>, "formation");
    m.plain(c.formationVersion, p.formationVersion);
    m.plain(c.pose, p.pose);
    m.list(c.members, c.memberCount, p.members, "members");
    m.list(c.restMesh, c.vertexCount, p.restMesh, "restMesh");
    m.list(c.userMesh, c.vertexCount, p.userMesh, "userMesh");
    m.list(c.finalMesh, c.vertexCount, p.finalMesh, "finalMesh");
    m.list(c.triangles, c.triangleCount, p.triangles, "triangles");
    m.list(c.meshPlaces, c.placeCount, p.meshPlaces, "meshPlaces");
    m.list(c.placePositions, c.placeCount, p.placePositions, "placePositions");
    m.list(c.placeVelocities, c.placeCount, p.placeVelocities, "placeVelocities");
    m.list(c.placeTargets, c.placeCount, p.placeTargets, "placeTargets");
    m.list(c.placeUsable, c.placeCount, p.placeUsable, "placeUsable");
    m.list(c.placeClasses, c.placeClassCount, p.placeClasses, "placeClasses");
    m.plain(c.objective, p.objective);
    m.plain(c.gapBound, p.gapBound);
    m.plain(c.walk, p.walk);
    m.plain(c.meanLag, p.meanLag);
    m.plain(c.waits, p.held);
    m.plain(c.patrols, p.patrols);
    m.part(c.conduct, p.conduct, "conduct");
    m.list(c.way, c.wayCount, p.way, "way");
}
template <class M>
void fields(M& m, C<M, MusterControlPoint>& c, P<M, ControlPoint>& p) {
    m.plain(c.vertex, p.vertex);
    m.plain(c.touch, p.touch);
    m.plain(c.down, p.down);
    m.plain(c.offset, p.offset);
    m.plain(c.position, p.position);
    m.list(c.trajectory, c.trajectoryCount, p.trajectory, "trajectory");
}
template <class M>
void fields(M& m, C<M, MusterControl>& c, P<M, Control>& p) {
    m.id(c.id, p.id);
    m.choice(c.kind, p.kind, kLastOf<ControlKind>, "kind");
    m.plain(c.client, p.client);
    m.plain(c.pinned, p.pinned);
    m.plain(c.open, p.open);
    m.plain(c.joinDeadline, p.joinDeadline);
    m.plain(c.startTime, p.startTime);
    m.plain(c.clock, p.clock);
    m.items(c.points, c.pointCount, p.points, "points");
    m.list(c.supplementary, c.supplementaryCount, p.supplementary, "supplementary");
    m.list(c.weights, c.weightCount, p.weights, "weights");
}
template <class M>
void fields(M& m, C<M, MusterObstacle>& c, P<M, ObstacleView>& p) {
    m.template version<MusterObstacle>(c.structVersion);
    m.id(c.id, p.id);
    m.part(c.def, p.def, "def");
    m.list(c.outline, c.outlineCount, p.outline, "outline");
    m.plain(c.centre, p.centre);
}
template <class M>
void fields(M& m, C<M, MusterPatch>& c, P<M, PatchView>& p) {
    m.template version<MusterPatch>(c.structVersion);
    m.id(c.id, p.id);
    m.part(c.def, p.def, "def");
    m.list(c.outline, c.outlineCount, p.outline, "outline");
}
template <class M>
void fields(M& m, C<M, MusterArea>& c, P<M, AreaView>& p) {
    m.id(c.id, p.id);
    m.part(c.def, p.def, "def");
    m.id(c.group, p.group);
    m.plain(c.passed, p.count.passed);
    m.plain(c.waiting, p.count.waiting);
}

}  // namespace muster::c_api
