// Definitions and lists that files have in forms of their own: shorter ones, mostly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/scenario/describe_parts.h"
#include "files/scenario/generated/described_definitions.h"
#include "muster/generated/world_definitions.h"

namespace muster {

inline constexpr const char* kAdultsWord = "adults";  ///< Stands for adults().

/// A path; nothing where there is none.
template <class Visitor>
void describePath(Visitor& v, TimedPath& path) {
    if (takesPart<Visitor>(!path.still() || path.loop))
        v.object("path", "Moves it, linearly from waypoint to waypoint.",
                 [&](auto& inner) { describe(inner, path); });
}

/// A formation, or its kind alone.
template <class Visitor>
bool describeShape(Visitor& v, const char* key, FormationDef& formation, const char* about,
                   Need need = Need::Optional) {
    return v.objectOrKind(
        key, about, [&](auto& inner) { describe(inner, formation); }, need);
}
/// The same, or none.
template <class Visitor>
void describeShape(Visitor& v, const char* key, std::optional<FormationDef>& formation, const char* about) {
    if (!takesPart<Visitor>(formation.has_value())) return;
    FormationDef found = formation.value_or(FormationDef{});
    const bool given = describeShape(v, key, found, about);
    if (Visitor::kReading && given) formation = found;
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

/// An outline, and its holes beside it.
template <class Visitor>
void describeOutline(Visitor& v, PolygonWithHoles& shape, const char* about) {
    v.points("outline", shape.outline, 3, kMaxCorners, about);
    if constexpr (Visitor::kSchema) {
        v.set("holes",
              {{"type", "array"}, {"maxItems", 1000}, {"items", {{"type", "array"}, {"minItems", 3}}}},
              "For outline: the corners of each hole.", Need::Optional);
    } else {
        describeHoles(v, shape.holes);
    }
}

/// The target of an order: a place, or both ends of a front.
template <class Visitor>
void describeTarget(Visitor& v, Order& order) {
    if constexpr (!Visitor::kSchema && Visitor::kReading) {
        if (v.has("line")) {
            std::vector<Vec2> ends;
            v.points("line", ends, 2, 2, "");
            if (v.failed()) return;
            if (ends[0] == ends[1]) return v.fail("line", "two equal points", "two different ones");
            const Order line = Order::moveToLine(ends[0], ends[1]);
            order.target = line.target;
            order.facing = line.facing;
            order.width = line.width;
            return;
        }
    }
    const bool goes = order.kind == OrderKind::Move;
    const Need need = goes && !Visitor::kSchema ? Need::Required : Need::Optional;
    if (takesPart<Visitor>(goes || order.kind == OrderKind::Guard || isSet(order.target))) {
        v.number("x", order.target.x, kCoordinate, "Where its centre goes; of a guarded rectangle.", need);
        v.number("y", order.target.y, kCoordinate, "Where its centre goes; of a guarded rectangle.", need);
    }
    const bool heads = order.kind == OrderKind::Face || order.kind == OrderKind::Walk;
    const Need turned = heads ? Need::Required : Need::Optional;
    v.optionalNumber("facing", order.facing, kAngle,
                     "Heading at the end; left out: of the last stretch. For walk: where to.", turned);
    if (takesPart<Visitor>(order.width != 0.0))
        v.number("width", order.width, {0.0, 1e5, "m"}, "Of the front; 0 for that of the formation.");
    if constexpr (Visitor::kSchema) {
        v.points("line", order.route, 2, 2,
                 "Left and right end of the front, instead of place, facing and width.");
    }
}

/// Orders with their kinds.
template <class Visitor>
void describeOrders(Visitor& v, std::vector<Order>& orders, std::size_t most, const char* about) {
    v.list("orders", orders, most, about, [](auto& item, Order& order) {
        describeWord(item, "kind", order.kind, kOrderKindWords, "What it asks for.", Need::Required);
        describe(item, order);
    });
}

/// Equal bodies that stand one behind the other in a list.
struct BodyRun {
    Body body;
    std::int32_t count = 1;
};

template <class Visitor>
void describeBodyRun(Visitor& v, BodyRun& run) {
    if (takesPart<Visitor>(run.count != 1))
        v.whole("count", run.count, {1.0, kMaxCharacters}, "So many have this body.");
    describe(v, run.body);
}

/// A list of bodies. Equal ones are written once, with their number.
template <class Visitor>
void describeBodies(Visitor& v, const char* key, std::vector<Body>& bodies, Need need) {
    std::vector<BodyRun> runs;
    for (const Body& body : bodies) {
        if (!runs.empty() && runs.back().body == body) {
            ++runs.back().count;
        } else {
            runs.push_back({body, 1});
        }
    }
    v.list(
        key, runs, kMaxCharacters, "One for all, or one for each; left out: the group's or the parameters'.",
        [](auto& item, BodyRun& run) { describeBodyRun(item, run); }, need);
    if constexpr (Visitor::kReading) {
        bodies.clear();
        for (const BodyRun& run : runs) {
            if (v.failed()) return;
            const auto count = static_cast<std::size_t>(run.count);
            if (bodies.size() + count > static_cast<std::size_t>(kMaxCharacters))
                return v.fail(key, "more than " + std::to_string(kMaxCharacters) + " bodies", "fewer");
            bodies.insert(bodies.end(), count, run.body);
        }
    }
}

/// Roles, in the order in which they choose.
template <class Visitor>
void describeRoles(Visitor& v, std::vector<RoleDef>& roles, Need need) {
    describeList(v, "roles", roles, 255, "Which class stands where, in the order in which they choose.",
                 need);
}

/// True where a number says it all.
bool isPlainNumber(const Distribution& drawn);

void describeDrawn(FieldReader& v, const char* key, Distribution& drawn, const char* unit, const char* about);
void describeDrawn(FieldWriter& v, const char* key, Distribution& drawn, const char* unit, const char* about);
void describeDrawn(FieldSchema& v, const char* key, Distribution& drawn, const char* unit, const char* about);

void describePeople(FieldReader& v, std::vector<PeopleDef>& people, Need need);
void describePeople(FieldWriter& v, std::vector<PeopleDef>& people, Need need);
void describePeople(FieldSchema& v, std::vector<PeopleDef>& people, Need need);

}  // namespace muster
