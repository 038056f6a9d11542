// The fields of all objects in scenario and gesture files, described once for loading, saving and the schema.
#pragma once

#include <string>
#include <vector>

#include "io/scenario/fields.h"
#include "muster/parameter_table.h"
#include "muster/world_def.h"
#include "world/validation.h"

namespace muster {

inline constexpr NumberRange kAngle{-1e6, 1e6, "rad"};
inline constexpr NumberRange kTime{0.0, 1e9, "s"};

/// The names of all formations, in the order of FormationKind.
inline std::vector<std::string> formationNames() {
    std::vector<std::string> names;
    for (int kind = 0; kind <= static_cast<int>(FormationKind::Points); ++kind) {
        names.emplace_back(formationName(static_cast<FormationKind>(kind)));
    }
    return names;
}

/// The fields of a formation; the enclosing key may also hold the bare kind.
template <class Visitor>
void describeFormation(Visitor& v, FormationDef& formation) {
    const auto names = formationNames();
    std::string kind(formationName(formation.kind));
    v.choice("kind", kind, names, "The shape.");
    if constexpr (Visitor::kReading) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (names[i] == kind) formation.kind = static_cast<FormationKind>(i);
        }
    }
    v.number("spacing", formation.spacing, {0.05, 100.0, "m"}, "Distance between neighbouring places.");
    v.number("opening", formation.opening, {0.01, 6.0, "rad"},
             "Full angle of Pacman's mouth or the crescent's gap.");
    v.points("outline", formation.outline.outline, 3, kMaxCorners, "For outline: its corners, of any size.");
    if constexpr (Visitor::kSchema) {
        v.set("holes",
              {{"type", "array"}, {"maxItems", 1000}, {"items", {{"type", "array"}, {"minItems", 3}}}},
              "For outline: the corners of each hole.", Need::Optional);
    } else {
        describeHoles(v, formation.outline.holes);
    }
    v.points("points", formation.points, 1, kMaxCharacters,
             "For points: places in the local frame, facing +x.");
}

/// Holes are polygons: a list of lists of points.
inline void describeHoles(FieldReader& v, std::vector<Polygon>& holes) {
    const Json* found = v.findArray("holes", 1000, Need::Optional);
    if (found == nullptr) return;
    holes.clear();
    for (std::size_t i = 0; i < found->size() && !v.failed(); ++i) {
        const std::string key = "holes[" + std::to_string(i) + "]";
        Json wrapped = {{key, (*found)[i]}};
        std::string failure;
        FieldReader child(wrapped, "", failure);
        child.points(key, holes.emplace_back(), 3, kMaxCorners, "");
        if (!failure.empty()) v.fail(key, describeJson((*found)[i]), "at least three points [x, y]");
    }
}
inline void describeHoles(FieldWriter& v, const std::vector<Polygon>& holes) {
    if (holes.empty()) return;
    Json list = Json::array();
    for (const Polygon& hole : holes) {
        Json corners = Json::array();
        for (Vec2 p : hole) corners.push(Json::array({p.x, p.y}));
        list.push(std::move(corners));
    }
    v.set("holes", std::move(list));
}

template <class Visitor>
void describePath(Visitor& v, TimedPath& path) {
    const auto put = [&](auto& inner) {
        inner.list(
            "waypoints", path.waypoints, kMaxCorners, "Places at rising times.",
            [](auto& item, Waypoint& w) {
                item.number("t", w.time, kTime, "Time from the start of the world.", Need::Required);
                item.number("x", w.position.x, {-1e6, 1e6, "m"}, "Offset from the defined placement.");
                item.number("y", w.position.y, {-1e6, 1e6, "m"}, "Offset from the defined placement.");
                item.number("angle", w.angle, kAngle, "Turn about its centre.");
            },
            Need::Required);
        inner.flag("loop", path.loop, "Starts again after the last waypoint; else it stays there.");
    };
    if (Visitor::kReading || Visitor::kSchema || !path.still() || path.loop) {
        v.object("path", "Moves it, linearly from waypoint to waypoint.", put);
    }
}

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
}

template <class Visitor>
void describeGroup(Visitor& v, GroupDef& group) {
    v.text("name", group.name, "Shown on its chip.", Need::Optional, GroupDef{}.name);
    v.whole("count", group.count, {1.0, kMaxCharacters}, "Characters.");
    v.objectOrKind("formation", "Kind and spacing, or the kind alone.",
                   [&](auto& inner) { describeFormation(inner, group.formation); });
    v.point("position", group.position, "Centre of the formation.");
    v.number("angle", group.angle, kAngle, "Where it faces, from +x counter-clockwise.");
    v.points("starts", group.starts, 0, kMaxCharacters,
             "Where characters stand at first, one point each; left out: on their places.");
    v.number("jitter", group.jitter, {0.0, 100.0, "m"},
             "Start positions are moved by up to this, by the seed.");
}

template <class Visitor>
void describeCheckpoint(Visitor& v, FormationCheckpointDef& checkpoint, std::size_t groups) {
    v.point("position", checkpoint.position, "Where it lies.", Need::Required);
    v.number("radius", checkpoint.radius, {0.01, 1e4, "m"}, "Works where a mesh centre comes within it.");
    v.objectOrKind(
        "formation", "What the group becomes.",
        [&](auto& inner) { describeFormation(inner, checkpoint.formation); }, Need::Required);
    if (Visitor::kReading || Visitor::kSchema || checkpoint.group >= 0) {
        const double most = Visitor::kSchema ? 999.0 : static_cast<double>(groups) - 1.0;
        v.whole("group", checkpoint.group, {-1.0, most}, "Index of the group it concerns; -1 for any.");
    }
    v.flag("once", checkpoint.once, "Works once per group; else each time the group comes anew.");
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
}

}  // namespace muster
