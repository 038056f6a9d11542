// The fields of all objects in scenario and gesture files, described once for loading, saving and the schema.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/state/validation.h"
#include "files/scenario/describe_people.h"
#include "files/scenario/describe_units.h"
#include "files/scenario/fields.h"
#include "muster/parameter_table.h"
#include "muster/world_def.h"

namespace muster {

template <class Visitor>
void describeObstacle(Visitor& v, ObstacleDef& obstacle) {
    v.text("name", obstacle.name, "For people.");
    v.points("polygon", obstacle.polygon, 3, kMaxCorners, "Its corners, convex or not, in either direction.");
    if (Visitor::kReading || Visitor::kSchema || obstacle.polygon.empty() || obstacle.centre != Vec2{}) {
        v.point("centre", obstacle.centre, "For a disc: its centre.");
    }
    if (Visitor::kReading || Visitor::kSchema || obstacle.radius != 0.0) {
        v.number("radius", obstacle.radius, {0.0, 1e5, "m"}, "For a disc, instead of a polygon.");
    }
    describePath(v, obstacle.path);
    v.optionalNumber("range", obstacle.range, {0.0, 1e6, "m"},
                     "Range of its potential field; left out: the parameter field.range.");
    v.optionalNumber("strength", obstacle.strength, {0.0, 1e4},
                     "Strength of its potential field; left out: the parameter field.strength.");
    v.number("height", obstacle.height, {0.01, 1000.0, "m"}, "For the eye.");
}

/// `motions` names the clips; empty where they are not known (then only numbers are written).
template <class Visitor>
void describePatch(Visitor& v, PatchDef& patch, const std::vector<std::string>& motions) {
    v.text("name", patch.name, "Shown on its tag.");
    v.points("polygon", patch.polygon, 3, kMaxCorners, "Its corners.", Need::Required);
    describePath(v, patch.path);
    v.nameOrIndex("motion", patch.motion, motions, "Clip played on it: a name or index of `clips`.",
                  Need::Required);
    v.optionalNumber("speed", patch.speed, {0.01, 100.0},
                     "Travel speed relative to running; left out: the clip's.");
    v.optionalNumber("ascent", patch.ascent, kAngle, "For stairs and ramps: heading of the way up.",
                     Need::Optional);
    v.optionalNumber("speedDown", patch.speedDown, {0.01, 100.0},
                     "For stairs and ramps: travel speed down; left out: as `speed`.");
}

template <class Visitor>
void describeGroup(Visitor& v, GroupDef& group) {
    v.text("name", group.name, "Shown on its chip.", Need::Optional, GroupDef{}.name);
    v.colour("colour", group.colour,
             "Of its shirts and marks; left out: the palette's, by its place in the list.");
    describeAppearance(v, group);
    v.whole("count", group.count, {0.0, kMaxCharacters}, "Characters; 0 where a source sends some.");
    v.objectOrKind("formation", "Kind and spacing, or the kind alone.",
                   [&](auto& inner) { describeFormation(inner, group.formation); });
    v.point("position", group.position, "Centre of the formation.");
    v.number("angle", group.angle, kAngle, "Where it faces, from +x counter-clockwise.");
    v.points("starts", group.starts, 0, kMaxCharacters,
             "Where characters stand at first, one point each; left out: on their places.");
    v.number("jitter", group.jitter, {0.0, 100.0, "m"},
             "Start positions are moved by up to this, by the seed.");
    describeBodies(v, "bodies", group.bodies, Need::Optional);
    describePeople(v, group.people);
    describeRoles(v, group.roles, Need::Optional);
    v.numbers("demands", group.demands, kDemand, kMaxCharacters,
              "Units of supply that each place demands; left out: 1 each.");
    v.object("conduct", "How it behaves.", [&](auto& inner) { describeConduct(inner, group.conduct); });
    v.list("orders", group.orders, kMaxOrders, "What it is to do at first, one after the other.",
           [](auto& item, Order& order) {
               describeWord(item, "kind", order.kind, kOrderKindWords, "What it asks for.", Need::Required);
               describeOrder(item, order);
           });
    v.flag("patrols", group.patrols, "Orders that are done come last again.");
}

/// A checkpoint without the group that it concerns, which is put by `putGroup()`.
template <class Visitor, class PutGroup>
void describeCheckpoint(Visitor& v, FormationCheckpointDef& checkpoint, PutGroup putGroup) {
    v.point("position", checkpoint.position, "Where it lies.", Need::Required);
    v.number("radius", checkpoint.radius, {0.01, 1e4, "m"}, "Works for who comes within it.");
    v.objectOrKind(
        "formation", "What the group becomes.",
        [&](auto& inner) { describeFormation(inner, checkpoint.formation); }, Need::Required);
    putGroup();
    v.flag("once", checkpoint.once, "Works once per group; else each time the group comes anew.");
    describeWord(v, "trigger", checkpoint.trigger, kCheckpointTriggerWords,
                 "What passes it: a share of the crowd, or the centre of the mesh.");
    v.number("share", checkpoint.share, {1e-6, 1.0}, "For crowd: share of the group that has been in it.");
}

template <class Visitor>
void describeCheckpoint(Visitor& v, FormationCheckpointDef& checkpoint, std::size_t groups) {
    describeCheckpoint(v, checkpoint, [&] {
        if (!Visitor::kReading && !Visitor::kSchema && checkpoint.group < 0) return;
        const double most = Visitor::kSchema ? 999.0 : static_cast<double>(groups) - 1.0;
        v.whole("group", checkpoint.group, {-1.0, most},
                "Index of the group it concerns, from 0; -1 for any.");
    });
}

template <class Visitor>
void describeItem(Visitor& v, ItemDef& item) {
    v.point("position", item.position, "Where it lies.", Need::Required);
    v.number("radius", item.radius, {0.01, 1e4, "m"}, "Collected when a character comes within it.");
}

/// One number per parameter, from the table.
template <class Visitor>
void describeParameters(Visitor& v, Parameters& parameters) {
    for (const ParameterInfo& info : parameterTable()) {
        double value = info.get(parameters);
        v.number(info.name, value, {info.minimum, info.maximum, info.unit, info.whole()}, info.description);
        if constexpr (Visitor::kReading) info.set(parameters, value);
    }
    if constexpr (Visitor::kReading) {
        double unused = 0.0;
        for (const std::string_view name : retiredParameters()) v.number(name, unused, {-1e9, 1e9, ""}, "");
    }
}

/// The box that the map covers.
Box mapBox(const MapGround& map);

/// Each returns true where a map was read or written.
bool describeMap(FieldReader& v, std::optional<MapGround>& map, const std::string& folder);
bool describeMap(FieldWriter& v, std::optional<MapGround>& map, const std::string& folder);
bool describeMap(FieldSchema& v, std::optional<MapGround>& map, const std::string& folder);

}  // namespace muster
