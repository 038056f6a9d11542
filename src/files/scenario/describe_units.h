// The fields of orders, conducts, bodies and roles in scenario and gesture files.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/appearance_text.h"
#include "base/generated/enumeration_words.h"
#include "files/scenario/describe_shapes.h"
#include "muster/world_def.h"

namespace muster {

inline constexpr NumberRange kId{0.0, 4294967295.0};
inline constexpr NumberRange kCoordinate{-1e6, 1e6, "m"};
inline constexpr NumberRange kDemand{0.0, 1000.0};

/// A value of an enumeration, as one of its words.
template <class Visitor, class Value, std::size_t N>
void describeWord(Visitor& v, const char* key, Value& value, const std::array<const char*, N>& words,
                  const char* about, Need need = Need::Optional) {
    const std::vector<std::string> names(words.begin(), words.end());
    std::string word = names[static_cast<std::size_t>(value)];
    v.choice(key, word, names, about, need);
    if constexpr (Visitor::kReading) {
        for (std::size_t i = 0; i < N; ++i)
            if (names[i] == word) value = static_cast<Value>(i);
    }
}

/// The same for a value that may be none, which is left out.
template <class Visitor, class Value, std::size_t N>
void describeWord(Visitor& v, const char* key, std::optional<Value>& value,
                  const std::array<const char*, N>& words, const char* about) {
    if constexpr (Visitor::kReading && !Visitor::kSchema) {
        if (!v.has(key)) return;
    }
    if (!Visitor::kReading && !Visitor::kSchema && !value) return;
    Value word = value.value_or(Value{});
    describeWord(v, key, word, words, about);
    if constexpr (Visitor::kReading) value = word;
}

/// The appearance of a group's people, of anything that has `build` and `motions`.
template <class Visitor, class Appearance>
void describeAppearance(Visitor& v, Appearance& of) {
    describeWord(v, "build", of.build, kBodyBuildWords,
                 "Build of the drawn bodies; left out: both, by their ids.");
    describeWord(v, "motions", of.motions, kMotionSetWords, "How they walk and jog; left out: plainly.");
}

/// True where a field takes part: in files it is read wherever it stands, and written where it says
/// something.
template <class Visitor>
bool takesPart(bool says) {
    return Visitor::kReading || Visitor::kSchema || says;
}

/// True for numbers that differ in any bit from 0.
inline bool isSet(double value) {
    return value != 0.0 || std::signbit(value);
}

/// True for points that differ in any bit from (0, 0).
inline bool isSet(Vec2 p) {
    return isSet(p.x) || isSet(p.y);
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

/// Whom an order stays with.
template <class Visitor>
void describeLeader(Visitor& v, Order& order) {
    if (takesPart<Visitor>(static_cast<bool>(order.group)))
        v.whole("leader", order.group.value, kId, "For follow and guard: the group to stay with.");
    if (takesPart<Visitor>(order.character != 0))
        v.whole("character", order.character, kId, "For follow and guard: the character to stay with.");
    if (takesPart<Visitor>(isSet(order.offset)))
        v.point("offset", order.offset, "For follow: from its centre, in its axes.");
    if (takesPart<Visitor>(isSet(order.halfSize)))
        v.point("halfSize", order.halfSize, "For guard: half the length and half the width.");
    describePath(v, order.path);
}

/// By which exits, or where it waits.
template <class Visitor>
void describeGoals(Visitor& v, Order& order) {
    std::vector<std::uint32_t> exits;
    for (const AreaId exit : order.exits) exits.push_back(exit.value);
    v.numbers("exits", exits, kId, kMaxAreas, "For leave: ids of areas, from 1; left out: all exits.");
    order.exits.clear();
    for (const std::uint32_t exit : exits) order.exits.push_back({exit});
    if (takesPart<Visitor>(order.choice != ExitChoice::Quickest))
        describeWord(v, "choice", order.choice, kExitChoiceWords,
                     "For leave: where it has left soonest, or the quickest way alone.");
    v.numbers("attractions", order.attractions, {-1e6, 1e6, "s"}, kMaxAreas,
              "For leave: seconds by which each exit counts as nearer.");
    if (takesPart<Visitor>(isSet(order.herding)))
        v.number("herding", order.herding, {0.0, 1e6, "s"},
                 "For leave: by so much an exit counts as nearer that all others nearby choose.");
    if (takesPart<Visitor>(isSet(order.misjudgement)))
        v.number("misjudgement", order.misjudgement, {0.0, 1e6, "s"},
                 "For leave: deviation of the error by which each misjudges the time by an exit.");
    if (takesPart<Visitor>(static_cast<bool>(order.area)))
        v.whole("area", order.area.value, kId, "For wait: id of the waiting area, from 1.",
                order.kind == OrderKind::Wait && !Visitor::kSchema ? Need::Required : Need::Optional);
    if (takesPart<Visitor>(isSet(order.seconds)))
        v.number("seconds", order.seconds, kTime, "For wait: from when its share has come; 0: no end.");
}

/// The fields of an order, except its kind.
template <class Visitor>
void describeOrder(Visitor& v, Order& order) {
    describeTarget(v, order);
    v.points("route", order.route, 0, kMaxCorners, "Drawn way to the target.");
    if (takesPart<Visitor>(order.formation.has_value())) {
        FormationDef formation = order.formation.value_or(FormationDef{});
        const bool given = v.objectOrKind("formation", "New formation; left out: the old one.",
                                          [&](auto& inner) { describeFormation(inner, formation); });
        if (Visitor::kReading && given) order.formation = formation;
    }
    if (takesPart<Visitor>(order.kind == OrderKind::Move || order.manner != Manner::March))
        describeWord(v, "manner", order.manner, kMannerWords,
                     "In formation, each by the shortest way, or to one point by one field.");
    if (takesPart<Visitor>(order.kind == OrderKind::Move || order.turn != Turn::Flow))
        describeWord(v, "turn", order.turn, kTurnWords, "How it turns on a march.");
    if (takesPart<Visitor>(order.pace != 0.0))
        v.number("pace", order.pace, {0.0, 100.0, "m/s"}, "Of a march; 0 for as fast as all can.");
    v.number("share", order.share, {1e-6, 1.0}, "Of those who must be there before the next order begins.");
    describeLeader(v, order);
    describeGoals(v, order);
}

template <class Visitor>
void describeConduct(Visitor& v, Conduct& conduct) {
    describeWord(v, "stance", conduct.stance, kStanceWords, "Who makes room where groups meet.");
    v.number("cohesion", conduct.cohesion, {0.0, 1.0}, "0: each at their own pace; 1: at the slowest one's.");
    v.number("squeeze", conduct.squeeze, {0.0, 1.0}, "Share of its width that it may give up in passages.");
    v.flag("avoids", conduct.avoids, "Its mesh gives way to other meshes and to moving obstacles.");
}

inline constexpr const char* kUpstairs = "Speed up stairs as a share of that in the open; 0: the stairs'.";
inline constexpr const char* kDownstairs = "The same for down.";

/// Equal bodies that stand one behind the other in a list.
struct BodyRun {
    Body body;
    std::int32_t count = 1;
};

/// A speed on stairs as a share of that in the open; 0 for the stairs'.
template <class Visitor>
void describeOwnShare(Visitor& v, const char* key, double& value, const char* about) {
    if (takesPart<Visitor>(isSet(value))) v.number(key, value, {0.0, 1.0}, about);
}

template <class Visitor>
void describeBody(Visitor& v, Body& body) {
    v.number("radius", body.radius, {0.0, 1.5, "m"}, "0: the parameter's; else 0.05 or more.");
    v.number("maxSpeed", body.maxSpeed, {0.0, 50.0, "m/s"}, "0: the parameter's; else 0.01 or more.");
    v.number("acceleration", body.acceleration, {0.0, 1000.0, "m/s^2"},
             "0: the parameter's; else 0.01 or more.");
    v.number("mass", body.mass, {0.01, 1000.0}, "Who is heavy gives way less.");
    v.number("supply", body.supply, {1e-3, 1000.0}, "Units that it supplies to places.");
    v.whole("class", body.unitClass, {0.0, 255.0}, "For roles; 0 for none.");
    if (takesPart<Visitor>(isSet(body.headway)))
        v.number("headway", body.headway, {0.0, 5.0, "s"},
                 "Time that it keeps from who is ahead. 0: the parameter's; else 0.02 or more.");
    if (takesPart<Visitor>(isSet(body.premovement)))
        v.number("premovement", body.premovement, {0.0, 1e7, "s"}, "From its first order until it sets out.");
    describeOwnShare(v, "upstairs", body.upstairs, kUpstairs);
    describeOwnShare(v, "downstairs", body.downstairs, kDownstairs);
}

template <class Visitor>
void describeBodyRun(Visitor& v, BodyRun& run) {
    if (takesPart<Visitor>(run.count != 1))
        v.whole("count", run.count, {1.0, kMaxCharacters}, "So many have this body.");
    describeBody(v, run.body);
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

template <class Visitor>
void describeRoles(Visitor& v, std::vector<RoleDef>& roles, Need need) {
    v.list(
        "roles", roles, 255, "Which class stands where, in the order in which they choose.",
        [](auto& item, RoleDef& role) {
            describeWord(item, "area", role.area, kRoleAreaWords, "Part of the formation.", Need::Required);
            item.whole("class", role.unitClass, {1.0, 255.0}, "Of those who stand there.", Need::Required);
        },
        need);
}

}  // namespace muster
