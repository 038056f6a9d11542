// The fields of formations and of paths in scenario and gesture files.
#pragma once

#include <string>
#include <vector>

#include "engine/state/validation.h"
#include "files/scenario/fields.h"
#include "muster/obstacle.h"

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
    v.whole("files", formation.files, {0.0, kMaxCharacters},
            "For square: how many stand abreast; 0: as deep as wide.");
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

}  // namespace muster
