// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// Random definitions of every kind, each of them valid.
#pragma once

#include "definition_draw.h"

namespace muster {

inline Waypoint randomWaypoint(DefinitionDraw& draw) {
    Waypoint d;
    d.time = draw.real(0, 1e9);
    d.position = draw.place();
    d.angle = draw.real(-1e6, 1e6);
    draw.relate(d);
    return d;
}
inline TimedPath randomTimedPath(DefinitionDraw& draw) {
    TimedPath d;
    draw.list(d.waypoints, [&] { return randomWaypoint(draw); });
    d.loop = draw.flag();
    draw.relate(d);
    return d;
}
inline ObstacleDef randomObstacleDef(DefinitionDraw& draw) {
    ObstacleDef d;
    d.name = draw.text();
    d.polygon = draw.polygon();
    d.centre = draw.place();
    d.radius = draw.real(0, 1e5);
    d.path = randomTimedPath(draw);
    d.range = draw.flag() ? -1.0 : draw.real(0, 1e6);
    d.strength = draw.flag() ? -1.0 : draw.real(0, 1e4);
    d.height = draw.real(0.01, 1000);
    draw.relate(d);
    return d;
}
inline ClipFacts randomClipFacts(DefinitionDraw& draw) {
    ClipFacts d;
    d.name = draw.text();
    d.file = draw.text();
    d.speed = draw.real(0.01, 100);
    d.length = draw.real(0, 1e4);
    d.duration = draw.real(0, 1e4);
    d.cyclic = draw.flag();
    d.transitionTime = draw.real(0, 100);
    d.reachAhead = draw.real(0, 2);
    d.reachBehind = draw.real(0, 2);
    draw.relate(d);
    return d;
}
inline PatchDef randomPatchDef(DefinitionDraw& draw) {
    PatchDef d;
    d.name = draw.text();
    d.polygon = draw.polygon();
    d.path = randomTimedPath(draw);
    d.motion = draw.whole(0, 7);
    d.speed = draw.flag() ? -1.0 : draw.real(0.01, 100);
    if (draw.flag()) d.ascent = draw.real(-1e6, 1e6);
    d.speedDown = draw.flag() ? -1.0 : draw.real(0.01, 100);
    draw.relate(d);
    return d;
}
inline MapDef randomMapDef(DefinitionDraw& draw) {
    MapDef d;
    d.metresPerCell = draw.real(0.01, 1000);
    d.origin = draw.place();
    d.swampSpeed = draw.real(0.01, 100);
    draw.relate(d);
    return d;
}
inline Arrivals randomArrivals(DefinitionDraw& draw) {
    Arrivals d;
    d.time = draw.real(0, 1e9);
    d.count = draw.whole(1, 200000);
    draw.relate(d);
    return d;
}
inline AreaDef randomAreaDef(DefinitionDraw& draw) {
    AreaDef d;
    d.name = draw.text();
    d.kind = draw.value<AreaKind>();
    d.polygon = draw.polygon();
    d.open = draw.flag();
    d.rate = draw.real(0, 1000);
    draw.list(d.queue, [&] { return draw.place(); });
    d.from = draw.real(0, 1e9);
    d.until = draw.real(0, 1e9);
    d.most = draw.whole(0, 200000);
    draw.list(d.timetable, [&] { return randomArrivals(draw); });
    draw.relate(d);
    return d;
}
inline ItemDef randomItemDef(DefinitionDraw& draw) {
    ItemDef d;
    d.position = draw.place();
    d.radius = draw.real(0.01, 1e4);
    draw.relate(d);
    return d;
}
inline Body randomBody(DefinitionDraw& draw) {
    Body d;
    d.radius = draw.flag() ? 0.0 : draw.real(0.05, 1.5);
    d.maxSpeed = draw.flag() ? 0.0 : draw.real(0.01, 50);
    d.acceleration = draw.flag() ? 0.0 : draw.real(0.01, 1000);
    d.mass = draw.real(0.01, 1000);
    d.supply = draw.real(1e-3, 1000);
    d.unitClass = static_cast<std::uint8_t>(draw.whole(0, 255));
    d.headway = draw.flag() ? 0.0 : draw.real(0.02, 5);
    d.premovement = draw.real(0, 1e7);
    d.upstairs = draw.flag() ? 0.0 : draw.real(0.01, 1);
    d.downstairs = draw.flag() ? 0.0 : draw.real(0.01, 1);
    draw.relate(d);
    return d;
}
inline RoleDef randomRoleDef(DefinitionDraw& draw) {
    RoleDef d;
    d.area = draw.value<RoleArea>();
    d.unitClass = static_cast<std::uint8_t>(draw.whole(1, 255));
    draw.relate(d);
    return d;
}
inline PeopleDef randomPeopleDef(DefinitionDraw& draw) {
    PeopleDef d;
    d.name = draw.text();
    d.share = draw.real(1e-9, 1e9);
    d.unitClass = static_cast<std::uint8_t>(draw.whole(0, 255));
    d.speed = draw.distribution(0.01, 50);
    d.radius = draw.distribution(0.05, 1.5);
    d.headway = draw.distribution(0.02, 5);
    d.premovement = draw.distribution(0, 1e7);
    d.age = draw.distribution(5, 90);
    d.upstairs = draw.flag() ? 0.0 : draw.real(0.01, 1);
    d.downstairs = draw.flag() ? 0.0 : draw.real(0.01, 1);
    draw.relate(d);
    return d;
}
inline FormationDef randomFormationDef(DefinitionDraw& draw) {
    FormationDef d;
    d.kind = draw.value<FormationKind>();
    d.spacing = draw.real(0.05, 100);
    d.opening = draw.real(0.01, 6);
    d.outline = draw.outline();
    draw.list(d.points, [&] { return draw.place(); });
    d.files = draw.whole(0, 200000);
    draw.relate(d);
    return d;
}
inline Order randomOrder(DefinitionDraw& draw) {
    Order d;
    d.kind = draw.value<OrderKind>();
    d.target = draw.place();
    if (draw.flag()) d.facing = draw.real(-1e6, 1e6);
    d.width = draw.real(0, 1e5);
    draw.list(d.route, [&] { return draw.place(); });
    if (draw.flag()) d.formation = randomFormationDef(draw);
    d.manner = draw.value<Manner>();
    d.turn = draw.value<Turn>();
    d.pace = draw.real(0, 100);
    d.share = draw.real(1e-6, 1);
    d.group = GroupId{draw.number()};
    d.character = draw.number();
    d.offset = draw.place();
    d.halfSize = Vec2{draw.real(0, 1e5), draw.real(0, 1e5)};
    d.path = randomTimedPath(draw);
    draw.list(d.exits, [&] { return AreaId{draw.number()}; });
    d.choice = draw.value<ExitChoice>();
    draw.list(d.attractions, [&] { return draw.real(-1e6, 1e6); });
    d.herding = draw.real(0, 1e6);
    d.misjudgement = draw.real(0, 1e6);
    d.area = AreaId{draw.number()};
    d.seconds = draw.real(0, 1e9);
    draw.relate(d);
    return d;
}
inline Conduct randomConduct(DefinitionDraw& draw) {
    Conduct d;
    d.stance = draw.value<Stance>();
    d.cohesion = draw.real(0, 1);
    d.squeeze = draw.real(0, 1);
    d.avoids = draw.flag();
    draw.relate(d);
    return d;
}
inline GroupDef randomGroupDef(DefinitionDraw& draw) {
    GroupDef d;
    d.name = draw.text();
    d.count = draw.whole(0, 200000);
    d.formation = randomFormationDef(draw);
    d.position = draw.place();
    d.angle = draw.real(-1e6, 1e6);
    draw.list(d.starts, [&] { return draw.place(); });
    d.jitter = draw.real(0, 100);
    draw.list(d.bodies, [&] { return randomBody(draw); });
    draw.list(d.roles, [&] { return randomRoleDef(draw); });
    draw.list(d.demands, [&] { return draw.real(0, 1000); });
    d.conduct = randomConduct(draw);
    draw.list(d.orders, [&] { return randomOrder(draw); });
    d.patrols = draw.flag();
    if (draw.flag()) d.colour = draw.number() & 0xffffffu;
    if (draw.flag()) d.build = draw.value<BodyBuild>();
    if (draw.flag()) d.motions = draw.value<MotionSet>();
    draw.list(d.people, [&] { return randomPeopleDef(draw); });
    draw.relate(d);
    return d;
}
inline GroupColour randomGroupColour(DefinitionDraw& draw) {
    GroupColour d;
    if (draw.flag()) d.colour = draw.number() & 0xffffffu;
    draw.relate(d);
    return d;
}
inline GroupLook randomGroupLook(DefinitionDraw& draw) {
    GroupLook d;
    if (draw.flag()) d.build = draw.value<BodyBuild>();
    if (draw.flag()) d.motions = draw.value<MotionSet>();
    draw.relate(d);
    return d;
}
inline FormationCheckpointDef randomCheckpointDef(DefinitionDraw& draw) {
    FormationCheckpointDef d;
    d.position = draw.place();
    d.radius = draw.real(0.01, 1e4);
    d.formation = randomFormationDef(draw);
    d.once = draw.flag();
    d.trigger = draw.value<CheckpointTrigger>();
    d.share = draw.real(1e-6, 1);
    draw.relate(d);
    return d;
}

}  // namespace muster
