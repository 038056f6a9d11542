#include "engine/state/validation.h"

#include <cmath>

#include "engine/geometry/polygon.h"
#include "engine/state/validation_parts.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr double kShortestRing = 10.0;  // More than twice as far as steering looks [m].
constexpr double kMostCells = 16e6;     // Of a grid.

Status isShape(const char* what, std::span<const Vec2> corners) {
    if (corners.size() > kMaxCorners) {
        return {StatusCode::LimitExceeded, std::string(what) + " has " + std::to_string(corners.size()) +
                                               " corners, at most " + std::to_string(kMaxCorners) +
                                               " are allowed"};
    }
    if (Status s = arePlaces(what, corners); !s.ok()) return s;
    const auto clean = cleanPolygon(corners);
    return clean.ok() ? Status() : clean.status().within(what);
}

Status isText(const char* what, const std::string& value) {
    if (value.size() <= kMaxText) return {};
    return {StatusCode::LimitExceeded, std::string(what) + " has " + std::to_string(value.size()) +
                                           " bytes, at most " + std::to_string(kMaxText) + " are allowed"};
}

Status validateGround(const WorldDef& def) {
    if (Status s = first({isText("name", def.name), isText("description", def.description),
                          isText("credit", def.credit), isText("gestures", def.gestures),
                          isPlace("box", def.box.min), isPlace("box", def.box.max),
                          inRange("cell", def.cell, 0.01, 100.0)});
        !s.ok()) {
        return s;
    }
    if (def.seed > 9007199254740991ull) return invalidArgument("seed is above 2^53 - 1");
    if (!(def.box.width() > 0.0 && def.box.height() > 0.0)) return invalidArgument("box is empty");
    if (def.ring && def.box.width() < kShortestRing)
        return invalidArgument("ring: the box is " + numberText(def.box.width()) +
                               " m wide, expected at least " + numberText(kShortestRing) + " m");
    const double cells = std::ceil(def.box.width() / def.cell) * std::ceil(def.box.height() / def.cell);
    if (cells > kMostCells) {
        return {StatusCode::LimitExceeded,
                "box has " + numberText(cells) + " cells, at most 16 million are allowed"};
    }
    if (def.clips.empty() || def.clips.size() > 1000) return invalidArgument("clips: expected 1 to 1000");
    for (std::size_t i = 0; i < def.clips.size(); ++i) {
        if (Status s = validateClip(def.clips[i]); !s.ok())
            return s.within("clips[" + std::to_string(i) + "]");
    }
    if (def.map) {
        const MapGround& map = *def.map;
        if (Status s = first({inRange("metresPerCell", map.def.metresPerCell, 0.01, 1000.0),
                              isPlace("origin", map.def.origin),
                              inRange("swampSpeed", map.def.swampSpeed, 0.01, 100.0)});
            !s.ok()) {
            return s.within("map");
        }
    }
    return {};
}

/// Checks each of a list; the message names the index.
template <class List, class Check>
Status each(const char* name, const List& list, std::size_t most, Check check) {
    if (list.size() > most) {
        return {StatusCode::LimitExceeded, std::string(name) + ": found " + std::to_string(list.size()) +
                                               ", at most " + std::to_string(most) + " are allowed"};
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (Status s = check(list[i]); !s.ok())
            return s.within(std::string(name) + "[" + std::to_string(i) + "]");
    }
    return {};
}

/// Costs of a metre that fast marching is made for; patches and clips may be 0.01 to 100 times as fast as
/// running.
Status isCost(const Parameters& p) {
    constexpr double kCheapestGround = 0.01, kMostCost = 1e8, kSlowest = 0.01;
    if (p.cost.alpha + p.cost.beta < kCheapestGround) {
        return invalidArgument("parameters cost.alpha and cost.beta add up to " +
                               numberText(p.cost.alpha + p.cost.beta) + ", expected at least " +
                               numberText(kCheapestGround));
    }
    const double most = (p.cost.alpha + p.cost.beta + p.cost.gamma * p.discomfort.gain) /
                        (p.cost.minSpeed * kSlowest);
    if (most <= kMostCost) return {};
    return invalidArgument(
        "parameters cost.alpha, cost.beta, cost.gamma, discomfort.gain and cost.minSpeed let a metre cost " +
        numberText(most) + ", expected at most " + numberText(kMostCost));
}

}  // namespace

Status validateParameters(const Parameters& parameters, const Box& box) {
    Parameters scratch;
    for (const ParameterInfo& info : parameterTable()) {
        if (Status s = setParameter(scratch, info.name, info.get(parameters)); !s.ok()) return s;
    }
    if (parameters.density.max <= parameters.density.min) {
        return invalidArgument("parameter density.max is " + numberText(parameters.density.max) +
                               ", expected a number above density.min, " +
                               numberText(parameters.density.min));
    }
    const double cells = (box.width() / parameters.density.cell + 1.0) *
                         (box.height() / parameters.density.cell + 1.0);
    if (!(cells <= kMostCells)) {
        return {StatusCode::LimitExceeded, "parameter density.cell makes " + numberText(cells) +
                                               " density cells, at most 16 million are allowed"};
    }
    return isCost(parameters);
}

Status validateCheckpoint(const FormationCheckpointDef& checkpoint, std::size_t groups) {
    return first(
        {isPlace("position", checkpoint.position), inRange("radius", checkpoint.radius, 0.01, 1e4),
         inRange("group", checkpoint.group, -1, static_cast<double>(groups) - 1),
         checkpoint.trigger <= CheckpointTrigger::Mesh ? Status() : invalidArgument("trigger is not known"),
         inRange("share", checkpoint.share, 1e-6, 1.0), validateFormation(checkpoint.formation)});
}

Status validateShape(const char* what, const Polygon& polygon) {
    return isShape(what, polygon);
}

Status validateName(const std::string& name) {
    return isText("name", name);
}

Status validateColour(const std::optional<std::uint32_t>& colour) {
    if (!colour || *colour <= 0xFFFFFFu) return {};
    return invalidArgument("colour is above 0xFFFFFF");
}

Status validateAppearance(const std::optional<BodyBuild>& build, const std::optional<MotionSet>& motions) {
    if (build && *build > kLastOf<BodyBuild>) return invalidArgument("build is not known");
    return motions && *motions > kLastOf<MotionSet> ? invalidArgument("motions are not known") : Status();
}

Status validateItem(const ItemDef& item) {
    return first({isPlace("position", item.position), inRange("radius", item.radius, 0.01, 1e4)});
}

Status validateClip(const ClipFacts& clip) {
    return first({isText("name", clip.name), isText("file", clip.file),
                  inRange("speed", clip.speed, 0.01, 100.0), inRange("length", clip.length, 0.0, 1e4),
                  inRange("duration", clip.duration, 0.0, 1e4),
                  inRange("transitionTime", clip.transitionTime, 0.0, 100.0),
                  inRange("reachAhead", clip.reachAhead, 0.0, 2.0),
                  inRange("reachBehind", clip.reachBehind, 0.0, 2.0)});
}

Status validateTotal(std::int64_t characters, const Parameters& parameters) {
    const std::string found = "the groups would hold " + std::to_string(characters) + " characters, ";
    if (characters > kMaxCharacters)
        return {StatusCode::LimitExceeded, found + "a world holds at most " + std::to_string(kMaxCharacters)};
    if (characters > kMaxExact && parameters.plan.solver == PlanSolver::Exact)
        return {StatusCode::LimitExceeded,
                found + "exact plans (plan.solver 0) serve at most " + std::to_string(kMaxExact)};
    return {};
}

Status validateFormation(const FormationDef& formation) {
    if (formation.kind > FormationKind::Points) return invalidArgument("formation kind is not known");
    if (Status s = first({inRange("spacing", formation.spacing, 0.05, 100.0),
                          inRange("files", formation.files, 0, kMaxCharacters),
                          inRange("opening", formation.opening, 0.01, 6.0),
                          arePlaces("points", formation.points)});
        !s.ok()) {
        return s;
    }
    if (formation.kind == FormationKind::Points && formation.points.empty()) {
        return invalidArgument("formation has no points");
    }
    if (formation.kind != FormationKind::Outline && formation.outline.outline.empty()) {
        return formation.outline.holes.empty() ? Status() : invalidArgument("holes without an outline");
    }
    if (Status s = isShape("outline", formation.outline.outline); !s.ok()) return s;
    return each("holes", formation.outline.holes, 1000,
                [](const Polygon& hole) { return isShape("hole", hole); });
}

Status validateObstacle(const ObstacleDef& obstacle) {
    if (Status s = first({isText("name", obstacle.name), isPath(obstacle.path),
                          inRange("height", obstacle.height, 0.01, 1000.0)});
        !s.ok()) {
        return s;
    }
    if (!(obstacle.range < 0.0)) {
        if (Status s = inRange("range", obstacle.range, 0.0, kMaxCoordinate); !s.ok()) return s;
    }
    if (!(obstacle.strength < 0.0)) {
        if (Status s = inRange("strength", obstacle.strength, 0.0, 1e4); !s.ok()) return s;
    }
    if (!obstacle.polygon.empty()) {
        if (obstacle.radius != 0.0) return invalidArgument("obstacle has both a polygon and a radius");
        return isShape("polygon", obstacle.polygon);
    }
    return first({isPlace("centre", obstacle.centre), inRange("radius", obstacle.radius, 1e-3, 1e5)});
}

Status validatePatch(const PatchDef& patch, std::int32_t motions) {
    if (Status s = first({isText("name", patch.name), isPath(patch.path), isShape("polygon", patch.polygon)});
        !s.ok()) {
        return s;
    }
    if (patch.motion < 0 || patch.motion >= motions) {
        return invalidArgument("motion is " + std::to_string(patch.motion) + ", expected a clip from 0 to " +
                               std::to_string(motions - 1));
    }
    const auto isSpeed = [](const char* what, double speed) {
        return speed < 0.0 ? Status() : inRange(what, speed, 0.01, 100.0);
    };
    return first({isSpeed("speed", patch.speed), isSpeed("speedDown", patch.speedDown),
                  inRange("ascent", patch.ascent.value_or(0.0), -1e6, 1e6)});
}

Status validateGroup(const GroupDef& group) {
    if (Status s = first({isText("name", group.name), inRange("count", group.count, 0, kMaxCharacters),
                          isPlace("position", group.position), inRange("angle", group.angle, -1e6, 1e6),
                          inRange("jitter", group.jitter, 0.0, 100.0), arePlaces("starts", group.starts)});
        !s.ok()) {
        return s;
    }
    if (!group.starts.empty() && group.starts.size() != static_cast<std::size_t>(group.count)) {
        return invalidArgument("starts has " + std::to_string(group.starts.size()) +
                               " points, expected none or " + std::to_string(group.count));
    }
    const FormationDef& formation = group.formation;
    if (formation.kind == FormationKind::Points &&
        formation.points.size() < static_cast<std::size_t>(group.count)) {
        return invalidArgument("formation has " + std::to_string(formation.points.size()) + " points for " +
                               std::to_string(group.count) + " characters");
    }
    if (Status s = first({validateBodies(group.bodies, static_cast<std::size_t>(group.count), true),
                          validateRoles(group.roles), validateDemands(group.demands),
                          validateConduct(group.conduct), validateColour(group.colour),
                          validateAppearance(group.build, group.motions), validatePeople(group.people),
                          each("orders", group.orders, kMaxOrders, validateOrder)});
        !s.ok()) {
        return s;
    }
    return validateFormation(formation);
}

// Whoever is in no group at first comes by a source.
Status validateAreas(const WorldDef& def) {
    const auto groups = static_cast<std::int32_t>(def.groups.size());
    for (std::size_t k = 0; k < def.areas.size(); ++k) {
        const AreaDef& area = def.areas[k];
        if (area.kind == AreaKind::Source && (area.group < 0 || area.group >= groups))
            return invalidArgument("areas[" + std::to_string(k) + "]: group is " +
                                   std::to_string(area.group) + ", expected the index of a group");
    }
    for (std::int32_t g = 0; g < groups; ++g) {
        const bool fed = std::any_of(def.areas.begin(), def.areas.end(), [&](const AreaDef& area) {
            return area.kind == AreaKind::Source && area.group == g;
        });
        if (def.groups[g].count == 0 && !fed)
            return invalidArgument("groups[" + std::to_string(g) +
                                   "]: count is 0, expected at least 1 where no source sends people");
    }
    return each("areas", def.areas, kMaxAreas, validateArea);
}

Status validateWorld(const WorldDef& def) {
    if (Status s = validateGround(def); !s.ok()) return s;
    const auto motions = static_cast<std::int32_t>(def.clips.size());
    std::int64_t characters = 0;
    for (const GroupDef& group : def.groups) characters += group.count;
    if (Status s = validateTotal(characters, def.parameters); !s.ok()) return s;
    return first(
        {each("obstacles", def.obstacles, kMaxObstacles, validateObstacle),
         each("patches", def.patches, kMaxObstacles,
              [&](const PatchDef& patch) { return validatePatch(patch, motions); }),
         each("groups", def.groups, kMaxGroups, validateGroup),
         each("checkpoints", def.checkpoints, kMaxObstacles,
              [&](const FormationCheckpointDef& c) { return validateCheckpoint(c, def.groups.size()); }),
         each("items", def.items, kMaxObstacles, validateItem), validateAreas(def),
         validateParameters(def.parameters, def.box).within("parameters")});
}

}  // namespace muster
