// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// The fields of each definition in files, for a visitor (fields.h).
#pragma once

#include <string>
#include <vector>

#include "files/scenario/describe_parts.h"
#include "muster/generated/world_definitions.h"

namespace muster {

template <class Visitor>
void describe(Visitor& v, Waypoint& d) {
    v.number("t", d.time, {0.0, 1e9, "s"}, "Time from the start of the world.", Need::Required);
    v.number("x", d.position.x, {-1e6, 1e6, "m"}, "Offset from the defined placement.");
    v.number("y", d.position.y, {-1e6, 1e6, "m"}, "Offset from the defined placement.");
    v.number("angle", d.angle, {-1e6, 1e6, "rad"}, "Turn about its centre.");
}
template <class Visitor>
void describe(Visitor& v, TimedPath& d) {
    describeList(v, "waypoints", d.waypoints, kMaxCorners, "Places at rising times.", Need::Required);
    v.flag("loop", d.loop, "Starts again after the last waypoint; else it stays there.");
}
template <class Visitor>
void describe(Visitor& v, ObstacleDef& d) {
    v.text("name", d.name, "For people.");
    v.points("polygon", d.polygon, 3, kMaxCorners, "Its corners, convex or not, in either direction.");
    if (takesPart<Visitor>(d.polygon.empty() || isSet(d.centre)))
        v.point("centre", d.centre, "For a disc: its centre.");
    if (takesPart<Visitor>(isSet(d.radius)))
        v.number("radius", d.radius, {0.0, 1e5, "m"}, "For a disc, instead of a polygon.");
    describePath(v, d.path);
    v.optionalNumber("range", d.range, {0.0, 1e6, "m"},
                     "Range of its potential field; left out: the parameter field.range.");
    v.optionalNumber("strength", d.strength, {0.0, 1e4},
                     "Strength of its potential field; left out: the parameter field.strength.");
    v.number("height", d.height, {0.01, 1000.0, "m"}, "For the eye.");
}
template <class Visitor>
void describe(Visitor& v, ClipFacts& d, const std::string& folder, double run) {
    v.text("name", d.name, "What patches call it.", Need::Required);
    describeClipFile(v, d, folder, run);
    v.number("speed", d.speed, {0.01, 100.0}, "Travel speed relative to running.");
    v.number("length", d.length, {0.0, 1e4, "m"}, "Ground covered by one play; 0 where unknown.");
    v.number("duration", d.duration, {0.0, 1e4, "s"}, "Of one play.");
    v.flag("cyclic", d.cyclic, "False for motions that happen once per patch, such as a jump.");
    v.number("transitionTime", d.transitionTime, {0.0, 100.0, "s"},
             "Played on entering and leaving; 0 for none.");
    v.number("reachAhead", d.reachAhead, {0.0, 2.0, "m"},
             "From the character's position to the head of a body that leans or lies; 0 for upright bodies.");
    v.number("reachBehind", d.reachBehind, {0.0, 2.0, "m"}, "From there back to its hips.");
}
template <class Visitor>
void describe(Visitor& v, PatchDef& d, const std::vector<std::string>& motions) {
    v.text("name", d.name, "Shown on its tag.");
    v.points("polygon", d.polygon, 3, kMaxCorners, "Its corners.", Need::Required);
    describePath(v, d.path);
    v.nameOrIndex("motion", d.motion, motions, "Clip played on it: a name or index of `clips`.",
                  Need::Required);
    v.optionalNumber("speed", d.speed, {0.01, 100.0},
                     "Travel speed relative to running; left out: the clip's.");
    v.optionalNumber("ascent", d.ascent, {-1e6, 1e6, "rad"}, "For stairs and ramps: heading of the way up.",
                     Need::Optional);
    v.optionalNumber("speedDown", d.speedDown, {0.01, 100.0},
                     "For stairs and ramps: travel speed down; left out: as `speed`.");
}
template <class Visitor>
void describe(Visitor& v, MapDef& d) {
    v.number("metresPerCell", d.metresPerCell, {0.01, 1000.0, "m"}, "Edge of a map cell.");
    v.point("origin", d.origin, "Lower left corner of the map.");
    v.number("swampSpeed", d.swampSpeed, {0.01, 100.0}, "Travel speed of swamp cells.");
}
template <class Visitor>
void describe(Visitor& v, Arrivals& d) {
    v.number("t", d.time, {0.0, 1e9, "s"}, "When.", Need::Required);
    v.whole("count", d.count, {1.0, kMaxCharacters}, "How many.", Need::Required);
}
template <class Visitor>
void describe(Visitor& v, AreaDef& d, auto putGroup) {
    v.text("name", d.name, "Shown on its tag.");
    describeWord(v, "kind", d.kind, kAreaKindWords, "What it does.", Need::Required);
    v.points("polygon", d.polygon, 3, kMaxCorners, "Its corners.", Need::Required);
    v.flag("open", d.open, "False: nobody leaves or comes here for now.");
    v.number("rate", d.rate, {0.0, 1000.0, "1/s"},
             "For exit: the most who leave, 0 for as many as come. For source: how many come on average.");
    v.points("queue", d.queue, 2, kMaxCorners,
             "For exit: the line in which people queue, from who is next to the last.");
    putGroup();
    if (takesPart<Visitor>(isSet(d.from)))
        v.number("from", d.from, {0.0, 1e9, "s"},
                 "For exit: when it opens. For source with a rate: when it begins.");
    if (takesPart<Visitor>(d.until != 1e9))
        v.number("until", d.until, {0.0, 1e9, "s"},
                 "For exit: when it closes. For source with a rate: when it ends.");
    if (takesPart<Visitor>(d.most != 0))
        v.whole("most", d.most, {0.0, kMaxCharacters}, "For source with a rate: in all; 0 for no end.");
    describeList(v, "timetable", d.timetable, kMaxCorners, "For source: further people, by ascending times.");
}
template <class Visitor>
void describe(Visitor& v, ItemDef& d) {
    v.point("position", d.position, "Where it lies.", Need::Required);
    v.number("radius", d.radius, {0.01, 1e4, "m"}, "Collected when a character comes within it.");
}
template <class Visitor>
void describe(Visitor& v, Body& d) {
    v.number("radius", d.radius, {0.0, 1.5, "m"}, "0: the parameter's; else 0.05 or more.");
    v.number("maxSpeed", d.maxSpeed, {0.0, 50.0, "m/s"}, "0: the parameter's; else 0.01 or more.");
    v.number("acceleration", d.acceleration, {0.0, 1000.0, "m/s^2"},
             "0: the parameter's; else 0.01 or more.");
    v.number("mass", d.mass, {0.01, 1000.0}, "Who is heavy gives way less.");
    v.number("supply", d.supply, {1e-3, 1000.0}, "Units that it supplies to places.");
    v.whole("class", d.unitClass, {0.0, 255.0}, "For roles; 0 for none.");
    if (takesPart<Visitor>(isSet(d.headway)))
        v.number("headway", d.headway, {0.0, 5.0, "s"},
                 "Time that it keeps from who is ahead. 0: the parameter's; else 0.02 or more.");
    if (takesPart<Visitor>(isSet(d.premovement)))
        v.number("premovement", d.premovement, {0.0, 1e7, "s"}, "From its first order until it sets out.");
    if (takesPart<Visitor>(isSet(d.upstairs)))
        v.number("upstairs", d.upstairs, {0.0, 1.0},
                 "Speed up stairs as a share of that in the open; 0: the stairs'.");
    if (takesPart<Visitor>(isSet(d.downstairs)))
        v.number("downstairs", d.downstairs, {0.0, 1.0}, "The same for down.");
}
template <class Visitor>
void describe(Visitor& v, RoleDef& d) {
    describeWord(v, "area", d.area, kRoleAreaWords, "Part of the formation.", Need::Required);
    v.whole("class", d.unitClass, {1.0, 255.0}, "Of those who stand there.", Need::Required);
}
template <class Visitor>
void describe(Visitor& v, Distribution& d) {
    describeWord(v, "spread", d.spread, kSpreadWords, "Its kind.", Need::Required);
    v.number("a", d.a, {-1e9, 1e9},
             "The value of all, the least, the mean, the logarithm's mean, the shape, or Weibull's scale.");
    v.number("b", d.b, {-1e9, 1e9},
             "The most, the deviation, the logarithm's, the scale, or Weibull's shape.");
    v.number("least", d.least, {0.0, 1e9}, "What lies below does not occur.");
    v.number("most", d.most, {0.0, 1e9}, "What lies above does not occur.");
}
template <class Visitor>
void describe(Visitor& v, PeopleDef& d) {
    v.text("name", d.name, "For people.");
    v.number("share", d.share, {1e-9, 1e9}, "Of the group; shares are divided by their sum.");
    v.whole("class", d.unitClass, {0.0, 255.0}, "For roles; 0 for none.");
    describeDrawn(v, "speed", d.speed, "m/s", "Top speed in the open.");
    describeDrawn(v, "radius", d.radius, "m", "Radius of the body.");
    describeDrawn(v, "headway", d.headway, "s", "Time that it keeps from who is ahead.");
    describeDrawn(v, "premovement", d.premovement, "s", "Until it sets out on its first order.");
    describeDrawn(v, "age", d.age, "years", "Above 0 it gives the speed, as RiMEA has it.");
    if (takesPart<Visitor>(isSet(d.upstairs)))
        v.number("upstairs", d.upstairs, {0.0, 1.0},
                 "Speed up stairs as a share of that in the open; 0: the stairs'.");
    if (takesPart<Visitor>(isSet(d.downstairs)))
        v.number("downstairs", d.downstairs, {0.0, 1.0}, "The same for down.");
}
template <class Visitor>
void describe(Visitor& v, FormationDef& d) {
    describeWord(v, "kind", d.kind, kFormationKindWords, "The shape.");
    v.number("spacing", d.spacing, {0.05, 100.0, "m"}, "Distance between neighbouring places.");
    v.number("opening", d.opening, {0.01, 6.0, "rad"}, "Full angle of Pacman's mouth or the crescent's gap.");
    describeOutline(v, d.outline, "For outline: its corners, of any size.");
    v.points("points", d.points, 1, kMaxCharacters, "For points: places in the local frame, facing +x.");
    v.whole("files", d.files, {0.0, kMaxCharacters},
            "For square: how many stand abreast; 0: as deep as wide.");
}
template <class Visitor>
void describe(Visitor& v, Order& d) {
    describeTarget(v, d);
    v.points("route", d.route, 0, kMaxCorners, "Drawn way to the target.");
    describeShape(v, "formation", d.formation, "New formation; left out: the old one.");
    if (takesPart<Visitor>(d.kind == OrderKind::Move || d.manner != Manner::March))
        describeWord(v, "manner", d.manner, kMannerWords,
                     "In formation, each by the shortest way, or to one point by one field.");
    if (takesPart<Visitor>(d.kind == OrderKind::Move || d.turn != Turn::Flow))
        describeWord(v, "turn", d.turn, kTurnWords, "How it turns on a march.");
    if (takesPart<Visitor>(isSet(d.pace)))
        v.number("pace", d.pace, {0.0, 100.0, "m/s"}, "Of a march; 0 for as fast as all can.");
    v.number("share", d.share, {1e-6, 1.0}, "Of those who must be there before the next order begins.");
    if (takesPart<Visitor>(static_cast<bool>(d.group)))
        v.whole("leader", d.group.value, kId, "For follow and guard: the group to stay with.");
    if (takesPart<Visitor>(d.character != 0))
        v.whole("character", d.character, kId, "For follow and guard: the character to stay with.");
    if (takesPart<Visitor>(isSet(d.offset)))
        v.point("offset", d.offset, "For follow: from its centre, in its axes.");
    if (takesPart<Visitor>(isSet(d.halfSize)))
        v.point("halfSize", d.halfSize, "For guard: half the length and half the width.");
    describePath(v, d.path);
    describeIds(v, "exits", d.exits, 1000, "For leave: ids of areas, from 1; left out: all exits.");
    if (takesPart<Visitor>(d.choice != ExitChoice::Quickest))
        describeWord(v, "choice", d.choice, kExitChoiceWords,
                     "For leave: where it has left soonest, or the quickest way alone.");
    v.numbers("attractions", d.attractions, {-1e6, 1e6, "s"}, 1000,
              "For leave: seconds by which each exit counts as nearer.");
    if (takesPart<Visitor>(isSet(d.herding)))
        v.number("herding", d.herding, {0.0, 1e6, "s"},
                 "For leave: by so much an exit counts as nearer that all others nearby choose.");
    if (takesPart<Visitor>(isSet(d.misjudgement)))
        v.number("misjudgement", d.misjudgement, {0.0, 1e6, "s"},
                 "For leave: deviation of the error by which each misjudges the time by an exit.");
    if (takesPart<Visitor>(static_cast<bool>(d.area)))
        v.whole("area", d.area.value, kId, "For wait: id of the waiting area, from 1.",
                d.kind == OrderKind::Wait && !Visitor::kSchema ? Need::Required : Need::Optional);
    if (takesPart<Visitor>(isSet(d.seconds)))
        v.number("seconds", d.seconds, {0.0, 1e9, "s"}, "For wait: from when its share has come; 0: no end.");
}
template <class Visitor>
void describe(Visitor& v, Conduct& d) {
    describeWord(v, "stance", d.stance, kStanceWords, "Who makes room where groups meet.");
    v.number("cohesion", d.cohesion, {0.0, 1.0}, "0: each at their own pace; 1: at the slowest one's.");
    v.number("squeeze", d.squeeze, {0.0, 1.0}, "Share of its width that it may give up in passages.");
    v.flag("avoids", d.avoids, "Its mesh gives way to other meshes and to moving obstacles.");
}
template <class Visitor>
void describe(Visitor& v, GroupDef& d) {
    v.text("name", d.name, "Shown on its chip.", Need::Optional, "Group");
    v.colour("colour", d.colour,
             "Of its shirts and marks; left out: the palette's, by its place in the list.");
    describeWord(v, "build", d.build, kBodyBuildWords,
                 "Build of the drawn bodies; left out: both, by their ids.");
    describeWord(v, "motions", d.motions, kMotionSetWords, "How they walk and jog; left out: plainly.");
    v.whole("count", d.count, {0.0, kMaxCharacters}, "Characters; 0 where a source sends some.");
    describeShape(v, "formation", d.formation, "Kind and spacing, or the kind alone.");
    v.point("position", d.position, "Centre of the formation.");
    v.number("angle", d.angle, {-1e6, 1e6, "rad"}, "Where it faces, from +x counter-clockwise.");
    v.points("starts", d.starts, 0, kMaxCharacters,
             "Where characters stand at first, one point each; left out: on their places.");
    v.number("jitter", d.jitter, {0.0, 100.0, "m"}, "Start positions are moved by up to this, by the seed.");
    describeBodies(v, "bodies", d.bodies, Need::Optional);
    describePeople(v, d.people, Need::Optional);
    describeRoles(v, d.roles, Need::Optional);
    v.numbers("demands", d.demands, {0.0, 1000.0}, kMaxCharacters,
              "Units of supply that each place demands; left out: 1 each.");
    describeObject(v, "conduct", d.conduct, "How it behaves.");
    describeOrders(v, d.orders, 1000, "What it is to do at first, one after the other.");
    v.flag("patrols", d.patrols, "Orders that are done come last again.");
}
template <class Visitor>
void describe(Visitor& v, GroupColour& d) {
    v.colour("colour", d.colour, "Of its shirts and marks; left out: the palette's.");
}
template <class Visitor>
void describe(Visitor& v, GroupLook& d) {
    describeWord(v, "build", d.build, kBodyBuildWords,
                 "Build of the drawn bodies; left out: both, by their ids.");
    describeWord(v, "motions", d.motions, kMotionSetWords, "How they walk and jog; left out: plainly.");
}
template <class Visitor>
void describe(Visitor& v, FormationCheckpointDef& d, auto putGroup) {
    v.point("position", d.position, "Where it lies.", Need::Required);
    v.number("radius", d.radius, {0.01, 1e4, "m"}, "Works for who comes within it.");
    describeShape(v, "formation", d.formation, "What the group becomes.", Need::Required);
    putGroup();
    v.flag("once", d.once, "Works once per group; else each time the group comes anew.");
    describeWord(v, "trigger", d.trigger, kCheckpointTriggerWords,
                 "What passes it: a share of the crowd, or the centre of the mesh.");
    v.number("share", d.share, {1e-6, 1.0}, "For crowd: share of the group that has been in it.");
}
template <class Visitor>
void describe(Visitor& v, WorldDef& d, const std::string& folder) {
    v.text("name", d.name, "Shown in the studio.", Need::Optional, "Untitled");
    v.text("description", d.description, "One or two sentences.");
    v.text("credit", d.credit, "Whose data it uses.");
    describeGestures(v, d.gestures);
    describeGround(v, d, folder);
    describeBox(v, d.box);
    v.number("cell", d.cell, {0.01, 100.0, "m"}, "Edge of a ground cell.");
    v.whole("seed", d.seed, {0.0, 9007199254740991.0}, "Of all random numbers.");
    describeClips(v, d.clips, folder);
    describeList(v, "obstacles", d.obstacles, 20000, "What nobody can walk through.");
    describePatches(v, d);
    describeList(v, "groups", d.groups, 20000, "Crowds, each with one mesh.");
    describeCheckpoints(v, d);
    describeList(v, "items", d.items, 20000, "Things to collect.");
    describeAreas(v, d);
    if (takesPart<Visitor>(d.ring))
        v.flag("ring", d.ring, "The left and the right side of the box are joined.");
    describeParameters(v, d.parameters);
}

}  // namespace muster
