// What the fields of definitions of worlds have to be together.
#include "engine/state/validation.h"

#include <algorithm>
#include <cmath>

#include "engine/state/validation_parts.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr double kShortestRing = 10.0;  // More than twice as far as steering looks [m].
constexpr double kMostCells = 16e6;     // Of a grid.

Status isGround(const WorldDef& def) {
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
    if (def.clips.empty()) return invalidArgument("clips: expected 1 to 1000");
    return def.map ? validate(def.map->def).within("map") : Status();
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

/// Checks each of a list; the message names the index.
template <class Item, class Check>
Status eachSuits(const char* what, const std::vector<Item>& items, const Check& check) {
    for (std::size_t i = 0; i < items.size(); ++i)
        if (Status s = check(items[i]); !s.ok())
            return s.within(std::string(what) + "[" + std::to_string(i) + "]");
    return {};
}

Status isMotion(const PatchDef& patch, std::int32_t motions) {
    if (patch.motion >= 0 && patch.motion < motions) return {};
    return invalidArgument("motion is " + std::to_string(patch.motion) + ", expected a clip from 0 to " +
                           std::to_string(motions - 1));
}

Status isGroupOf(const FormationCheckpointDef& checkpoint, std::size_t groups) {
    return inRange("group", checkpoint.group, -1, static_cast<double>(groups) - 1);
}

// Whoever is in no group at first comes by a source.
Status areFed(const WorldDef& def) {
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
    return {};
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

Status validateTotal(std::int64_t characters, const Parameters& parameters) {
    const std::string found = "the groups would hold " + std::to_string(characters) + " characters, ";
    if (characters > kMaxCharacters)
        return {StatusCode::LimitExceeded, found + "a world holds at most " + std::to_string(kMaxCharacters)};
    if (characters > kMaxExact && parameters.plan.solver == PlanSolver::Exact)
        return {StatusCode::LimitExceeded,
                found + "exact plans (plan.solver 0) serve at most " + std::to_string(kMaxExact)};
    return {};
}

Status validateColour(const std::optional<std::uint32_t>& colour) {
    if (!colour || *colour <= 0xFFFFFFu) return {};
    return invalidArgument("colour is above 0xFFFFFF");
}

Status validatePatch(const PatchDef& patch, std::int32_t motions) {
    return first({validate(patch), isMotion(patch, motions)});
}

Status validateCheckpoint(const FormationCheckpointDef& checkpoint, std::size_t groups) {
    return first({validate(checkpoint), isGroupOf(checkpoint, groups)});
}

Status relations(const ObstacleDef& d) {
    if (d.polygon.empty())
        return first({isPlace("centre", d.centre), inRange("radius", d.radius, 1e-3, 1e5)});
    return d.radius == 0.0 ? Status() : invalidArgument("obstacle has both a polygon and a radius");
}

Status relations(const FormationDef& d) {
    if (d.kind == FormationKind::Points && d.points.empty())
        return invalidArgument("formation has no points");
    if (d.kind != FormationKind::Outline && d.outline.outline.empty())
        return d.outline.holes.empty() ? Status() : invalidArgument("holes without an outline");
    if (Status s = first(
            {isShape("outline", d.outline.outline), atMost("holes", d.outline.holes.size(), 1000)});
        !s.ok())
        return s;
    return eachSuits("holes", d.outline.holes, [](const Polygon& hole) { return isShape("hole", hole); });
}

Status relations(const GroupDef& d) {
    const auto count = static_cast<std::size_t>(d.count);
    if (!d.starts.empty() && d.starts.size() != count)
        return invalidArgument("starts has " + std::to_string(d.starts.size()) +
                               " points, expected none or " + std::to_string(d.count));
    if (d.formation.kind == FormationKind::Points && d.formation.points.size() < count)
        return invalidArgument("formation has " + std::to_string(d.formation.points.size()) + " points for " +
                               std::to_string(d.count) + " characters");
    return first({validateBodies(d.bodies, count, true), validateDemands(d.demands)});
}

Status relations(const WorldDef& d) {
    std::int64_t characters = 0;
    for (const GroupDef& group : d.groups) characters += group.count;
    const auto motions = static_cast<std::int32_t>(d.clips.size());
    return first(
        {isGround(d), validateTotal(characters, d.parameters),
         eachSuits("patches", d.patches, [&](const PatchDef& patch) { return isMotion(patch, motions); }),
         eachSuits("checkpoints", d.checkpoints,
                   [&](const FormationCheckpointDef& c) { return isGroupOf(c, d.groups.size()); }),
         areFed(d), validateParameters(d.parameters, d.box).within("parameters")});
}

}  // namespace muster
