// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
#include "engine/state/generated/definition_checks.h"

#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {

Status validate(const Waypoint& d) {
    Status status = inRange("time", d.time, 0.0, 1e9);
    if (status.ok()) status = isPlace("position", d.position);
    if (status.ok()) status = inRange("angle", d.angle, -1e6, 1e6);
    return status;
}

Status validate(const ObstacleDef& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = isShapeOrNone("polygon", d.polygon);
    if (status.ok()) status = isPath(d.path);
    if (status.ok()) status = isOwnOrNegative("range", d.range, 0.0, 1e6);
    if (status.ok()) status = isOwnOrNegative("strength", d.strength, 0.0, 1e4);
    if (status.ok()) status = inRange("height", d.height, 0.01, 1000.0);
    if (status.ok()) status = relations(d);
    return status;
}

Status validate(const ClipFacts& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = isText("file", d.file);
    if (status.ok()) status = inRange("speed", d.speed, 0.01, 100.0);
    if (status.ok()) status = inRange("length", d.length, 0.0, 1e4);
    if (status.ok()) status = inRange("duration", d.duration, 0.0, 1e4);
    if (status.ok()) status = inRange("transitionTime", d.transitionTime, 0.0, 100.0);
    if (status.ok()) status = inRange("reachAhead", d.reachAhead, 0.0, 2.0);
    if (status.ok()) status = inRange("reachBehind", d.reachBehind, 0.0, 2.0);
    return status;
}

Status validate(const PatchDef& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = isShape("polygon", d.polygon);
    if (status.ok()) status = isPath(d.path);
    if (status.ok()) status = isOwnOrNegative("speed", d.speed, 0.01, 100.0);
    if (status.ok()) status = inRange("ascent", d.ascent.value_or(0.0), -1e6, 1e6);
    if (status.ok()) status = isOwnOrNegative("speedDown", d.speedDown, 0.01, 100.0);
    return status;
}

Status validate(const MapDef& d) {
    Status status = inRange("metresPerCell", d.metresPerCell, 0.01, 1000.0);
    if (status.ok()) status = isPlace("origin", d.origin);
    if (status.ok()) status = inRange("swampSpeed", d.swampSpeed, 0.01, 100.0);
    return status;
}

Status validate(const Arrivals& d) {
    Status status = inRange("time", d.time, 0.0, 1e9);
    if (status.ok()) status = inRange("count", d.count, 1, kMaxCharacters);
    return status;
}

Status validate(const AreaDef& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = isKnown(d.kind, kLastOf<AreaKind>, "kind");
    if (status.ok()) status = isShape("polygon", d.polygon);
    if (status.ok()) status = inRange("rate", d.rate, 0.0, 1000.0);
    if (status.ok()) status = arePlaces("queue", d.queue, kMaxCorners);
    if (status.ok()) status = inRange("from", d.from, 0.0, 1e9);
    if (status.ok()) status = inRange("most", d.most, 0, kMaxCharacters);
    if (status.ok()) status = relations(d);
    return status;
}

Status validate(const ItemDef& d) {
    Status status = isPlace("position", d.position);
    if (status.ok()) status = inRange("radius", d.radius, 0.01, 1e4);
    return status;
}

Status validate(const Body& d) {
    Status status = isOwn("radius", d.radius, 0.05, 1.5);
    if (status.ok()) status = isOwn("maxSpeed", d.maxSpeed, 0.01, 50.0);
    if (status.ok()) status = isOwn("acceleration", d.acceleration, 0.01, 1000.0);
    if (status.ok()) status = inRange("mass", d.mass, 0.01, 1000.0);
    if (status.ok()) status = inRange("supply", d.supply, 1e-3, 1000.0);
    if (status.ok()) status = isOwn("headway", d.headway, 0.02, 5.0);
    if (status.ok()) status = inRange("premovement", d.premovement, 0.0, 1e7);
    if (status.ok()) status = isOwn("upstairs", d.upstairs, 0.01, 1.0);
    if (status.ok()) status = isOwn("downstairs", d.downstairs, 0.01, 1.0);
    return status;
}

Status validate(const RoleDef& d) {
    Status status = isKnown(d.area, kLastOf<RoleArea>, "area");
    if (status.ok()) status = inRange("class", d.unitClass, 1, 255);
    return status;
}

Status validate(const Distribution& d) {
    Status status = isKnown(d.spread, kLastOf<Spread>, "its kind");
    if (status.ok()) status = inRange("a", d.a, -1e9, 1e9);
    if (status.ok()) status = inRange("b", d.b, -1e9, 1e9);
    if (status.ok()) status = inRange("least", d.least, 0.0, 1e9);
    if (status.ok()) status = relations(d);
    return status;
}

Status validate(const PeopleDef& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = inRange("share", d.share, 1e-9, 1e9);
    if (status.ok()) status = isDistribution("speed", d.speed, 0.01, 50.0);
    if (status.ok()) status = isDistribution("radius", d.radius, 0.05, 1.5);
    if (status.ok()) status = isDistribution("headway", d.headway, 0.02, 5.0);
    if (status.ok()) status = isDistribution("premovement", d.premovement, 0.0, 1e7);
    if (status.ok()) status = isDistribution("age", d.age, 5.0, 90.0);
    if (status.ok()) status = isOwn("upstairs", d.upstairs, 0.01, 1.0);
    if (status.ok()) status = isOwn("downstairs", d.downstairs, 0.01, 1.0);
    return status;
}

Status validate(const FormationDef& d) {
    Status status = isKnown(d.kind, kLastOf<FormationKind>, "formation kind");
    if (status.ok()) status = inRange("spacing", d.spacing, 0.05, 100.0);
    if (status.ok()) status = inRange("opening", d.opening, 0.01, 6.0);
    if (status.ok()) status = arePlaces("points", d.points, kMaxCharacters);
    if (status.ok()) status = inRange("files", d.files, 0, kMaxCharacters);
    if (status.ok()) status = relations(d);
    return status;
}

Status validate(const Order& d) {
    Status status = isKnown(d.kind, kLastOf<OrderKind>, "kind of order");
    if (status.ok()) status = isPlace("target", d.target);
    if (status.ok()) status = inRange("facing", d.facing.value_or(0.0), -1e6, 1e6);
    if (status.ok()) status = inRange("width", d.width, 0.0, 1e5);
    if (status.ok()) status = arePlaces("route", d.route, kMaxCorners);
    if (status.ok()) status = validateIfAny(d.formation).within("formation");
    if (status.ok()) status = isKnown(d.manner, kLastOf<Manner>, "manner");
    if (status.ok()) status = isKnown(d.turn, kLastOf<Turn>, "turn");
    if (status.ok()) status = inRange("pace", d.pace, 0.0, 100.0);
    if (status.ok()) status = inRange("share", d.share, 1e-6, 1.0);
    if (status.ok()) status = isPlace("offset", d.offset);
    if (status.ok()) status = inRange("halfSize", d.halfSize.x, 0.0, 1e5);
    if (status.ok()) status = inRange("halfSize", d.halfSize.y, 0.0, 1e5);
    if (status.ok()) status = isPath(d.path).within("path");
    if (status.ok()) status = atMost("exits", d.exits.size(), 1000);
    if (status.ok()) status = isKnown(d.choice, kLastOf<ExitChoice>, "choice");
    if (status.ok()) status = eachInRange("attractions", d.attractions, 1000, -1e6, 1e6);
    if (status.ok()) status = inRange("herding", d.herding, 0.0, 1e6);
    if (status.ok()) status = inRange("misjudgement", d.misjudgement, 0.0, 1e6);
    if (status.ok()) status = inRange("seconds", d.seconds, 0.0, 1e9);
    if (status.ok()) status = relations(d);
    return status;
}

Status validate(const Conduct& d) {
    Status status = isKnown(d.stance, kLastOf<Stance>, "stance");
    if (status.ok()) status = inRange("cohesion", d.cohesion, 0.0, 1.0);
    if (status.ok()) status = inRange("squeeze", d.squeeze, 0.0, 1.0);
    return status;
}

Status validate(const GroupDef& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = inRange("count", d.count, 0, kMaxCharacters);
    if (status.ok()) status = validate(d.formation);
    if (status.ok()) status = isPlace("position", d.position);
    if (status.ok()) status = inRange("angle", d.angle, -1e6, 1e6);
    if (status.ok()) status = arePlaces("starts", d.starts, kMaxCharacters);
    if (status.ok()) status = inRange("jitter", d.jitter, 0.0, 100.0);
    if (status.ok()) status = validateRoles(d.roles);
    if (status.ok()) status = validate(d.conduct);
    if (status.ok()) status = each("orders", d.orders, 1000);
    if (status.ok()) status = validateColour(d.colour);
    if (status.ok()) status = isKnown(d.build, kLastOf<BodyBuild>, "build");
    if (status.ok()) status = isKnown(d.motions, kLastOf<MotionSet>, "set of motions");
    if (status.ok()) status = validatePeople(d.people);
    if (status.ok()) status = relations(d);
    return status;
}

Status validate(const GroupColour& d) {
    return validateColour(d.colour);
}

Status validate(const GroupLook& d) {
    Status status = isKnown(d.build, kLastOf<BodyBuild>, "build");
    if (status.ok()) status = isKnown(d.motions, kLastOf<MotionSet>, "set of motions");
    return status;
}

Status validate(const FormationCheckpointDef& d) {
    Status status = isPlace("position", d.position);
    if (status.ok()) status = inRange("radius", d.radius, 0.01, 1e4);
    if (status.ok()) status = validate(d.formation);
    if (status.ok()) status = isKnown(d.trigger, kLastOf<CheckpointTrigger>, "trigger");
    if (status.ok()) status = inRange("share", d.share, 1e-6, 1.0);
    return status;
}

Status validate(const WorldDef& d) {
    Status status = isText("name", d.name);
    if (status.ok()) status = isText("description", d.description);
    if (status.ok()) status = isText("credit", d.credit);
    if (status.ok()) status = isText("gestures", d.gestures);
    if (status.ok()) status = isPlace("box", d.box.min);
    if (status.ok()) status = isPlace("box", d.box.max);
    if (status.ok()) status = inRange("cell", d.cell, 0.01, 100.0);
    if (status.ok()) status = each("clips", d.clips, 1000);
    if (status.ok()) status = each("obstacles", d.obstacles, 20000);
    if (status.ok()) status = each("patches", d.patches, 20000);
    if (status.ok()) status = each("groups", d.groups, 20000);
    if (status.ok()) status = each("checkpoints", d.checkpoints, 20000);
    if (status.ok()) status = each("items", d.items, 20000);
    if (status.ok()) status = each("areas", d.areas, 1000);
    if (status.ok()) status = relations(d);
    return status;
}

}  // namespace muster
